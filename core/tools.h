// tools.h -- what each tool does at one vertex: pure functions of the groom before and the
// coverage.
#pragma once

#include "brush.h"

namespace pelage {

inline constexpr float kGreatestLength = 1e6f;  // of hair, in units of the mesh
inline constexpr float kFloodReach =
    1.0f / 40.0f;  // of the mean around a vertex, of the skin's size

// The direction, at most as long as 1.
vec3 shortened(vec3 direction);

// The part of a vector in the tangent plane, as a unit vector; zero where nothing is left of it.
vec3 onTangentPlane(vec3 vector, vec3 normal);

// The direction, in the world, of hair that is `fur` otherwise, as vertex v keeps it.
vec3 inMesh(const Skin& skin, uint v, FurVertex fur, vec3 direction);

// How hard a tool works at a vertex.
struct Touching {
    float coverage = 0.0f;  // [0,1] of the brush, without its strength
    float turn = 0.0f;   // [-1,1]; the same, less than 0 where a mirror image of the stroke works
    vec3 path{0.0f};     // world; where the comb went, of any length
    vec3 offset{0.0f};   // m, world; to the vertex from the nearest point of the path
    FurVertex around{};  // world; for smooth, the mean around the vertex before (averages.h)
};

// The brush's mode; where the tool does not offer it set (cut) or add.
Mode modeOf(const Brush& brush);

// The brush's radius, or 1/1000 of the skin's size where that is more, m.
float workingRadius(const Skin& skin, const Brush& brush);

// What a vertex holds after the brush. Let c = coverage x strength.
// Length: grows or shrinks by c x 4 % of the skin's size, or tends by the share c to `value` or to
// `factor` times what it was.
// Cut: tends to `value` by the share c where the hair is longer; never lengthens.
// Density and mask: up or down by c, or tends to `value` (density: or to `factor` times what it
// was); kept in [0,1].
// Comb: the direction tends by the share c to the path (subtract: against it) laid onto the tangent
// plane, at full magnitude; the length stays.
// Part: the direction tends by the share c to point away from the path (subtract: towards it) in
// the tangent plane; within a tenth of the radius of the path it tends to stand up the more. Twist:
// the direction turns about the normal by c quarter turns, to the left seen from outside (subtract:
// to the right); mirror images of strokes turn it the other way. Clump: the part of the direction
// across the path tends by the share c to lean towards the path (subtract: away), by the distance
// from it over the hair's length, at most 1. So tips of long hair meet over the middle line, and
// what lies along the path goes on doing so. Puff: the magnitude of the direction falls by the
// share c to 0: the hair stands up. Flatten: the direction tends by the share c to its own heading
// on the tangent plane, magnitude 1. Puff and flatten with subtract are each other. Smooth: length,
// density, direction and tint tend by the share c to their mean around the vertex. Tint: tends by
// the share c to the brush's color (subtract: to 1, the coat's own color). The mask m holds back
// all but the mask tool: new values tend back to the old by the share m.
FurVertex brushedFur(const Skin& skin, const Groom& before, const Brush& brush, uint v,
                     const Touching& touching);
// The mask of the vertex after the brush; as before for all but the mask tool.
float brushedMask(const Groom& before, const Brush& brush, uint v, const Touching& touching);

// What of `after` a mask of the share `held` lets through.
FurVertex heldBack(FurVertex after, const FurVertex& before, float held);

}  // namespace pelage
