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

// Two vertices that triangles join. Half-edge 3 t + k runs from corner k of triangle t to its next.
struct MeshEdge {
    static constexpr uint kNone = ~0u;
    uint side = kNone;   // a half-edge of it
    uint other = kNone;  // that of the other triangle, if there is one
    bool operator==(const MeshEdge&) const = default;
};

// Every edge once, however many triangles it has; none of triangles that name a vertex twice.
std::vector<MeshEdge> edgesOf(std::size_t vertexCount, std::span<const uvec3> triangles);

}  // namespace pelage
