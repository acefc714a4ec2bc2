// region.h -- parts of the skin that are named and not painted, and edits of all the hair there.
//
// Shortening over face, hands "and other desired areas" and scaling "in a selected 3D region" are
// section 3.2 of van Gelder and Wilhelms, An Interactive Fur Modeling Technique, 1997.
#pragma once

#include <string>
#include <vector>

#include "groom.h"
#include "skin_query.h"

namespace pelage {

enum class Where { all, sphere, box, segment, mask, narrow, curved, lasso };

// What a region selects; which fields count depends on `where`. The weight is 1 inside and falls to
// 0 smoothly within `falloff` outside. A field that is not a number selects nothing.
struct Region {
    Where where = Where::all;
    vec3 center{0.0f};       // m, world; of sphere and box
    float radius = 0.1f;     // of the sphere; 0 = the centre and its falloff
    vec3 half{0.1f};         // of the box, half of each side
    vec3 turn{0.0f};         // rad, world; the box is turned about this axis by its length
    std::string segment{};   // as segmentNamed takes it (body.h)
    float width = 0.02f;     // narrow: where the skin is thinner than this
    float curvature = 0.0f;  // 1/m; curved: where the mean curvature exceeds this, out or in
    float falloff = 0.0f;    // in what the border is measured: m; 1/m for curved; for the lasso in
                           // halves of the picture's height; for segment and mask m on the surface
    // Radius, half, width and falloff are multiples of the skin's size, curvature is per size.
    bool sizes = false;
    // The lasso: a closed polygon in clip space after division by w (x to the right and y up, both
    // [-1, 1] in the picture), self-crossing allowed. Only skin that faces the eye.
    std::vector<vec2> polygon{};
    mat4 viewProjection{1.0f};
    vec3 eye{0.0f};  // m, world; does not count for a parallel projection

    bool operator==(const Region&) const = default;
};

// The share by which each vertex belongs to the region, [0,1]. Throws std::runtime_error when there
// is no such segment.
std::vector<float> regionWeights(const SkinQuery& query, const Groom& groom, const Region& region);

enum class RegionAct { scale, set, smooth, randomise };

struct RegionEdit {
    Channel channel = Channel::length;  // length, density or direction
    RegionAct act = RegionAct::scale;
    float value = 1.0f;    // scale: factor; set: m or [0,1]; smooth, randomise: share [0,1]
    vec3 direction{0.0f};  // world; what direction is set to
    uint seed = 0;         // of randomise

    bool operator==(const RegionEdit&) const = default;
};

// Changes one channel by the weight w of the region at each vertex; the rest keeps its bits.
// Scale: multiplies the length, the density or the magnitude of the direction.
// Set: tends to the value; a direction to its part in the tangent plane, with the magnitude of
// `direction` (at most 1), and zero lets the hair stand.
// Smooth: tends to the mean around the vertex, as a flood with smooth does.
// Randomise: length and density times a number within 1 +- value; direction turns about the normal
// by up to value x half a turn. Drawn from the vertex's position in the world and the seed, so that
// the same place is drawn the same however the mesh is numbered.
// The painted mask holds back as it does in a flood, but not where the mask is the region.
// Values stay in the range of their channel. Throws std::runtime_error as regionWeights does.
void applyRegion(const SkinQuery& query, Groom& groom, const Region& region,
                 const RegionEdit& change);

}  // namespace pelage
