// split_normals.cpp -- sums triangles around groups of vertices.
#include "split_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pelage {
namespace {

constexpr double kSame = 0.999;  // cosine

glm::dvec3 unitOr(glm::dvec3 v, glm::dvec3 otherwise) {
    const double length = glm::length(v);
    return length > 1e-12 && std::isfinite(length) ? v / length : otherwise;
}

// Of each vertex the sum over its own triangles: unit normal x angle.
std::vector<glm::dvec3> ownSums(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
    for (const uvec3 t : triangles) {
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 here(positions[t[k]]);
            const glm::dvec3 a = glm::dvec3(positions[t[(k + 1) % 3]]) - here;
            const glm::dvec3 b = glm::dvec3(positions[t[(k + 2) % 3]]) - here;
            const glm::dvec3 across = glm::cross(a, b);
            const double doubled = glm::length(across);
            if (doubled > 0.0)
                sums[t[k]] += across * (std::atan2(doubled, glm::dot(a, b)) / doubled);
        }
    }
    return sums;
}

struct Group {
    glm::dvec3 before, sum;
    std::vector<uint> vertices;
};

}  // namespace

void renewNormals(std::span<const vec3> positions, std::span<const uint> place,
                  std::span<const uvec3> triangles, std::span<vec3> normals) {
    const std::vector<glm::dvec3> sums = ownSums(positions, triangles);
    std::vector<uint> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint a, uint b) { return place[a] < place[b]; });
    std::vector<Group> groups;  // at one place
    for (std::size_t i = 0; i < order.size(); ++i) {
        const uint v = order[i];
        const glm::dvec3 before = unitOr(glm::dvec3(normals[v]), glm::dvec3(0.0));
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return glm::dot(group.before, before) > kSame || group.before == before;
        });
        Group& group =
            same != groups.end() ? *same : groups.emplace_back(Group{before, glm::dvec3(0.0), {}});
        group.sum += sums[v];
        group.vertices.push_back(v);
        if (i + 1 < order.size() && place[order[i + 1]] == place[v]) continue;
        for (const Group& done : groups) {
            const double side = glm::dot(done.sum, done.before) < 0.0 ? -1.0 : 1.0;
            const vec3 normal(
                unitOr(side * done.sum, unitOr(done.before, glm::dvec3(0.0, 1.0, 0.0))));
            for (const uint of : done.vertices) normals[of] = normal;
        }
        groups.clear();
    }
}

}  // namespace pelage
