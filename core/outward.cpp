// outward.cpp -- volumes of the connected parts of a mesh.
#include "outward.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace pelage {
namespace {

// Disjoint sets of vertices. Galler and Fischer, "An Improved Equivalence Algorithm", 1964.
uint firstOf(std::vector<uint>& parent, uint v) {
    while (parent[v] != v) {
        parent[v] = parent[parent[v]];
        v = parent[v];
    }
    return v;
}

}  // namespace

bool facesOutward(std::span<const SkinVertex> vertices, std::span<const uvec3> triangles) {
    if (triangles.empty()) return false;
    std::vector<uint> parent(vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    for (const uvec3 t : triangles) {
        const uint first = firstOf(parent, t.x);
        parent[firstOf(parent, t.y)] = first;
        parent[firstOf(parent, t.z)] = first;
    }
    // Six times the volume, about a vertex of the part: the model may lie far from the origin.
    std::vector<double> volume(vertices.size(), 0.0);
    for (const uvec3 t : triangles) {
        const uint first = firstOf(parent, t.x);
        const glm::dvec3 origin(vertices[first].position);
        const auto at = [&](uint v) { return glm::dvec3(vertices[v].position) - origin; };
        volume[first] += glm::dot(at(t.x), glm::cross(at(t.y), at(t.z)));
    }
    return std::all_of(triangles.begin(), triangles.end(),
                       [&](uvec3 t) { return volume[firstOf(parent, t.x)] > 0.0; });
}

}  // namespace pelage
