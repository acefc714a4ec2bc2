// animal_shape.h -- the built-in animal as a smooth solid: a distance, and what grows where on it.
// Private to animal*.cpp.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "source.h"
#include "types.h"

namespace pelage::animal {

enum class Form { cone, ellipsoid, ear };
enum class Paint { trunk, limb, neck, head, ruff, ear, sock, tail, nose, eye };

// One convex piece of the body. `paired` pieces lie at x > 0 and have a mirror image.
struct Part {
    Form form = Form::cone;
    bool paired = false;
    bool sided = false;  // its mirror image is another segment: `segment` + 1
    uint segment = 0;
    Paint paint = Paint::trunk;
    vec3 a{0.0f}, b{0.0f};           // m; ends of the axis, or an ellipsoid's middle (a)
    float ra = 0.0f, rb = 0.0f;      // m; radii at the ends
    vec3 radii{0.0f};                // m; of an ellipsoid. Of an ear: x = thickness over width
    vec3 facing{0.0f};               // unit; where the hollow of an ear looks
    float blend = 0.0f;              // m; how far it melts into the pieces before it
    vec3 comb{0.0f};                 // unit; where its hair lies, before it is laid on the skin
    float furLength = 0.0f;          // m
    float start = 0.0f, end = 0.0f;  // share of the segment's axis at a and b
};

struct Sample {
    float distance = 0.0f;  // m, negative inside; exact on the surface and near it to first order
    vec3 gradient{0.0f};
};

// How much each piece has to say at a point; the weights sum to 1.
struct Blend {
    struct Term {
        const Part* part = nullptr;
        float weight = 0.0f;
        float along = 0.0f;  // share of the segment's axis, [0,1]
    };
    const Part* nearest = nullptr;
    std::array<Term, 64> terms;  // the first `count` of them
    std::size_t count = 0;

    const Term* begin() const { return terms.data(); }
    const Term* end() const { return terms.data() + count; }
};

// The solid. Every query takes a point with x >= 0; the other half is the mirror image.
class Shape {
public:
    // Pieces thinner than `cell` (m) are made thicker, so that a coarse mesh has no holes in them.
    explicit Shape(float cell);

    Sample sample(vec3 p) const;
    Blend blend(vec3 p) const;
    std::span<const Part> parts() const { return parts_; }

    static constexpr float kLipschitz = 1.3f;  // no value changes faster than this times the way

private:
    std::span<const unsigned char> candidates(vec3 p) const;

    std::vector<Part> parts_;
    std::vector<std::vector<unsigned char>> near_;  // per cell of a coarse grid: pieces that matter
};

// The body's segments, in the order that Part::segment counts.
std::vector<Segment> bodySegments();

// Bounds of the solid's half x >= 0, m.
inline constexpr vec3 kLower{0.0f, -0.02f, -0.72f};
inline constexpr vec3 kUpper{0.22f, 0.92f, 0.56f};

// A closed triangle mesh of the solid, exactly symmetric about x = 0; triangles face outwards.
struct Surface {
    std::vector<vec3> positions, normals;
    std::vector<uvec3> triangles;
    float cell = 0.0f;  // m; spacing of the lattice it was made on
};
Surface polygonise(std::size_t triangles);

// Where the corners of each triangle lie in the picture, and which vertices that splits.
struct Atlas {
    std::vector<vec2> uvs;         // one per split vertex, in [0,1]; v = 0 at the top
    std::vector<uint> vertexOf;    // split vertex -> vertex of the surface
    std::vector<uvec3> triangles;  // split vertices, in the surface's order
};
Atlas unwrap(const Surface& surface);

inline constexpr int kPictureSize = 1024;  // pixels
// The base-color picture as PNG.
std::vector<std::byte> paintPicture(const Shape& shape, const Surface& surface, const Atlas& atlas);

}  // namespace pelage::animal
