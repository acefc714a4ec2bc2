// edge_cuts.h -- a triangle mesh with every edge cut in two: which vertices that makes.
//
// Triangle a b c becomes a ab ca, ab b bc, ca bc c and ab bc ca, in this order, where ab is the new
// vertex on the edge from a to b. Triangles that share an edge by its vertices share its new one.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "progress.h"
#include "source.h"

namespace pelage {

using EdgeEnds = std::array<uint, 2>;

// Numbers edges, whatever their direction, in the order in which they are first met.
class EdgeNumbers {
public:
    explicit EdgeNumbers(std::size_t mostEdges);
    // a and b must differ.
    uint number(uint a, uint b);
    std::vector<EdgeEnds> take() { return std::move(ends_); }

private:
    std::vector<uint> table_;
    std::vector<EdgeEnds> ends_;
};

// One cut of every edge. New vertex `vertexCount + i` lies on edges[i].
struct Cuts {
    std::vector<EdgeEnds> edges;
    std::vector<uvec3> triangles;
};

// A corner that a triangle names twice has no edge to itself: its new vertex is the corner.
Cuts cutEdges(std::size_t vertexCount, std::span<const uvec3> triangles);

// The triangles of a part in its own vertices, counted from 0.
std::vector<uvec3> trianglesOf(const Source& source, const SourcePart& part);

// Of each part of a source the cuts of `levels` times, one after the other, in vertices of the
// part.
using PartCuts = std::vector<Cuts>;
std::vector<PartCuts> cutParts(const Source& source, int levels, Progress* progress = nullptr);

// Appends to values of the vertices those of the new ones: what mix(a, b) makes of both ends.
template <typename T, typename Mix>
void carryOver(std::vector<T>& values, const PartCuts& levels, Mix mix) {
    for (const Cuts& level : levels) {
        values.reserve(values.size() + level.edges.size());
        for (const auto [a, b] : level.edges) values.push_back(mix(values[a], values[b]));
    }
}

struct MeshSize {
    std::size_t vertices = 0, triangles = 0;
    bool operator==(const MeshSize&) const = default;
};

// What the source has, and after 1 to `levels` cuts, counted without making them.
std::vector<MeshSize> sizesAfterCuts(const Source& source, int levels);

}  // namespace pelage
