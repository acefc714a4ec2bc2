// half_edges.h -- the topology of a triangle mesh: one-rings, boundary, and what is not manifold.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "types.h"

namespace pelage {

struct Topology {
    // Neighbours of vertex v: rings[ringFirst[v]] up to rings[ringFirst[v + 1]], each once.
    std::vector<uint> ringFirst, rings;
    std::size_t boundaryEdges = 0;     // used by one triangle
    std::size_t nonManifoldEdges = 0;  // used by three triangles or more
    std::size_t flippedEdges = 0;      // used by two triangles in the same direction
    std::size_t repeatedCorners = 0;   // triangles that name a vertex twice
};

// Builds an OpenMesh half-edge mesh. A triangle that does not fit a half-edge mesh (a third one at
// an edge, a flipped one, one that names a vertex twice) stays outside it, yet counts in the rings
// and the figures above.
Topology makeTopology(std::size_t vertexCount, std::span<const uvec3> triangles);

}  // namespace pelage
