// gltf_subdivide.h -- a glTF with every triangle cut in four, and all else as it was.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "edge_cuts.h"

namespace pelage {

// The source as a .glb whose parts have the vertices and triangles of `cuts` (cutParts). Positions,
// and those of morph targets, follow Loop's rule over what is welded within a mesh, so that neither
// seams nor primitives come apart; normals follow the new shape; joints and weights are mixed, at
// most as many as before, and add up to 1; all else that vertices have is the mean of both ends,
// or the first end's where it is a whole number that names something. What was quantized becomes
// float. Throws std::runtime_error, naming an attribute that is a matrix or has joints alone.
std::vector<std::byte> subdividedGlb(const Source& source, std::span<const PartCuts> cuts,
                                     Progress* progress = nullptr);

}  // namespace pelage
