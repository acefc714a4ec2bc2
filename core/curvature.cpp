// curvature.cpp -- a least-squares fit of the shape operator to each one-ring.
#include "curvature.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "strand.h"

namespace pelage {
namespace {

// The symmetric map (p q; q r) in the plane of the tangents a and b as one of space.
Curvature inSpace(vec3 a, vec3 b, vec3 pqr) {
    const auto at = [&](int i, int j) {
        return pqr.x * a[i] * a[j] + pqr.y * (a[i] * b[j] + b[i] * a[j]) + pqr.z * b[i] * b[j];
    };
    return {at(0, 0), at(0, 1), at(0, 2), at(1, 1), at(1, 2), at(2, 2)};
}

Curvature curvatureAt(const Skin& skin, std::span<const vec3> normals, uint v) {
    const vec3 n = normals[v];
    if (!(glm::dot(n, n) > 0.5f)) return {};
    const vec3 a = anyTangent(n), b = glm::cross(n, a);
    // Normal equations of p x + q y = dn.a, q x + r y = dn.b, each neighbor weighted by its
    // distance to the power of -2.
    glm::dmat3 left(0.0);
    glm::dvec3 right(0.0);
    for (const uint u : skin.ring(v)) {
        const vec3 way = skin.vertices[u].position - skin.vertices[v].position;
        const vec3 turn = normals[u] - n;
        const double square = glm::dot(way, way);
        if (!(square > 0.0) || !(glm::dot(normals[u], normals[u]) > 0.5f)) continue;
        const double weight = 1.0 / square;
        const double x = glm::dot(way, a), y = glm::dot(way, b);
        const double s = glm::dot(turn, a), t = glm::dot(turn, b);
        left +=
            weight * glm::dmat3(x * x, x * y, 0.0, x * y, x * x + y * y, x * y, 0.0, x * y, y * y);
        right += weight * glm::dvec3(x * s, y * s + x * t, y * t);
    }
    // The mean of the diagonal is about the number of neighbors; two directions leave no less of
    // it.
    if (!(std::abs(glm::determinant(left)) > 1e-6)) return {};
    return inSpace(a, b, vec3(glm::inverse(left) * right));
}

}  // namespace

float Curvature::along(vec3 t) const {
    return xx * t.x * t.x + yy * t.y * t.y + zz * t.z * t.z +
           2.0f * (xy * t.x * t.y + xz * t.x * t.z + yz * t.y * t.z);
}

std::vector<Curvature> curvaturesOf(const Skin& skin, std::span<const vec3> normals) {
    std::vector<Curvature> curvatures(skin.vertices.size());
    tbb::parallel_for(std::size_t{0}, curvatures.size(), [&](std::size_t v) {
        curvatures[v] = curvatureAt(skin, normals, static_cast<uint>(v));
    });
    return curvatures;
}

std::vector<vec3> smoothNormals(const Skin& skin, float deviation) {
    std::vector<vec3> normals, before;
    normals.reserve(skin.vertices.size());
    for (const SkinVertex& v : skin.vertices) normals.push_back(v.normal);
    // A mean over a vertex and a ring of six, all a spacing away, has 3/7 of its square as
    // variance.
    const float perSpacing = deviation / std::max(skin.spacing, 1e-30f);
    const auto rounds = static_cast<int>(std::min(7.0f / 3.0f * perSpacing * perSpacing, 64.0f));
    for (int round = 0; round < rounds; ++round) {
        before = normals;
        tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t v) {
            vec3 sum = before[v];
            for (const uint u : skin.ring(static_cast<uint>(v))) sum += before[u];
            normals[v] = safeUnit(sum, vec3(0.0f));
        });
    }
    return normals;
}

}  // namespace pelage
