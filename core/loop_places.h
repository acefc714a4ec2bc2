// loop_places.h -- Loop's rule over the parts of one mesh, welded where all of them agree.
#pragma once

#include <span>
#include <vector>

#include "loop.h"

namespace pelage {

// One part of a mesh. `values` holds quantities per vertex (positions, offsets of morph targets);
// every part of a mesh has equally many.
struct LoopPart {
    const PartCuts* cuts = nullptr;
    std::vector<uvec3> triangles;  // before the cuts, in vertices of the part
    std::vector<std::vector<vec3>> values;
    std::vector<uint> place;  // made by loopParts: equal where vertices are welded
};

// Moves the values and appends those of the new vertices. Vertices are welded, across parts too,
// where all their values are the same; so welded ones stay so, to the bit.
void loopParts(std::span<LoopPart> parts, Progress* progress = nullptr);

}  // namespace pelage
