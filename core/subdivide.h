// subdivide.h -- a document whose mesh has four triangles for each, with its fur.
#pragma once

#include "document.h"
#include "edge_cuts.h"

namespace pelage {

// A mesh of more triangles is not made by subdivision.
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 23;
inline constexpr int kMostLevels = 8;

// The document with its mesh subdivided `levels` times, 1 to kMostLevels, as gltf_subdivide.h says:
// what the mesh becomes is a glTF like one that was opened, with everything of the source in it.
// Vertices keep their order and their fur, bit for bit; new ones come after those of their part and
// take the mean of both ends. Sizes are those of sizesAfterCuts. Throws std::runtime_error, with
// numbers, for more than kMostTriangles.
Document subdivided(const Document& document, int levels, Progress* progress = nullptr);

}  // namespace pelage
