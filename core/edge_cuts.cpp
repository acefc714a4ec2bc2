// edge_cuts.cpp -- cuts edges, and counts what that makes.
#include "edge_cuts.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "strand.h"

namespace pelage {
namespace {

constexpr uint kNone = ~0u;

// How many different sets of three different corners the triangles have.
std::size_t differentTriangles(std::vector<uvec3> triangles) {
    for (uvec3& t : triangles) std::sort(&t.x, &t.x + 3);
    std::erase_if(triangles, [](uvec3 t) { return t.x == t.y || t.y == t.z; });
    std::sort(triangles.begin(), triangles.end(), [](uvec3 a, uvec3 b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    return static_cast<std::size_t>(std::unique(triangles.begin(), triangles.end()) -
                                    triangles.begin());
}

std::size_t differentEdges(std::span<const uvec3> triangles) {
    EdgeNumbers numbers(triangles.size() * 3);
    for (const uvec3 t : triangles)
        for (int k = 0; k < 3; ++k)
            if (t[k] != t[(k + 1) % 3]) numbers.number(t[k], t[(k + 1) % 3]);
    return numbers.take().size();
}

}  // namespace

std::vector<uvec3> trianglesOf(const Source& source, const SourcePart& part) {
    const auto first = source.triangles.begin() + part.firstTriangle;
    std::vector<uvec3> triangles(first, first + part.triangleCount);
    for (uvec3& t : triangles) t -= part.firstVertex;
    return triangles;
}

EdgeNumbers::EdgeNumbers(std::size_t mostEdges) : table_(std::bit_ceil(mostEdges * 2 + 2), kNone) {}

uint EdgeNumbers::number(uint a, uint b) {
    assert(a != b);
    if (a > b) std::swap(a, b);
    const std::size_t wrap = table_.size() - 1;
    std::size_t slot = pcg(a ^ pcg(b)) & wrap;
    while (table_[slot] != kNone && ends_[table_[slot]] != EdgeEnds{a, b}) slot = (slot + 1) & wrap;
    if (table_[slot] == kNone) {
        table_[slot] = static_cast<uint>(ends_.size());
        ends_.push_back({a, b});
    }
    return table_[slot];
}

Cuts cutEdges(std::size_t vertexCount, std::span<const uvec3> triangles) {
    EdgeNumbers numbers(triangles.size() * 3);
    const auto first = static_cast<uint>(vertexCount);
    const auto middle = [&](uint a, uint b) { return a == b ? a : first + numbers.number(a, b); };
    Cuts cuts;
    cuts.triangles.reserve(triangles.size() * 4);
    for (const uvec3 t : triangles) {
        const uint xy = middle(t.x, t.y), yz = middle(t.y, t.z), zx = middle(t.z, t.x);
        cuts.triangles.emplace_back(t.x, xy, zx);
        cuts.triangles.emplace_back(xy, t.y, yz);
        cuts.triangles.emplace_back(zx, yz, t.z);
        cuts.triangles.emplace_back(xy, yz, zx);
    }
    cuts.edges = numbers.take();
    return cuts;
}

std::vector<PartCuts> cutParts(const Source& source, int levels, Progress* progress) {
    std::vector<PartCuts> cuts;
    for (const SourcePart& part : source.parts) {
        std::size_t vertices = part.vertexCount;
        std::vector<uvec3> triangles = trianglesOf(source, part);
        PartCuts& ofPart = cuts.emplace_back();
        for (int level = 0; level < levels; ++level) {
            ofPart.push_back(cutEdges(vertices, level == 0 ? triangles : ofPart.back().triangles));
            vertices += ofPart.back().edges.size();
            if (progress) progress->report(progress->done);
        }
    }
    return cuts;
}

std::vector<MeshSize> sizesAfterCuts(const Source& source, int levels) {
    std::vector<MeshSize> sizes(static_cast<std::size_t>(levels) + 1);
    for (const SourcePart& part : source.parts) {
        const std::vector<uvec3> triangles = trianglesOf(source, part);
        // A cut halves every edge and puts three more into every triangle. Triangles with the same
        // corners share those; one that names a corner twice has none.
        std::size_t vertices = part.vertexCount, inside = 3 * differentTriangles(triangles);
        std::size_t edges = differentEdges(triangles), all = triangles.size();
        for (MeshSize& size : sizes) {
            size.vertices += vertices;
            size.triangles += all;
            vertices += edges;
            edges = 2 * edges + inside;
            inside *= 4;
            all *= 4;
        }
    }
    return sizes;
}

}  // namespace pelage
