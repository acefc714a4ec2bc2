// transfer.h -- the groom of one mesh on another, by the nearest point of the surface.
#pragma once

#include "document.h"

namespace pelage {

struct Transferred {
    Document document;
    std::size_t far = 0;    // vertices farther than kFarShare of the size from the groomed surface
    float farthest = 0.0f;  // m, of all vertices
};
inline constexpr float kFarShare = 0.05f;

// `onto` with the coats of `from` and, at each vertex, the fur of the point of `from` that is
// nearest in the world at rest, on the side that faces as the vertex does: length (in metres of the
// world), density and tint as they are between the corners there, the direction turned from the
// normal there to that of the vertex by the smallest rotation. The mask stays. Onto the same mesh
// in any order of vertices the values are the same to 1e-6. Vertices that are far take what is
// nearest, too, and are counted.
Transferred transferred(const Document& from, const Document& onto, Progress* progress = nullptr);

// What to tell of it: "12 of 340 vertices are farther than 5 % of the size from the groomed
// surface, the farthest 0.3 m"; empty when none is.
std::string farNote(const Transferred& transfer);

}  // namespace pelage
