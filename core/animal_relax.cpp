// animal_relax.cpp -- even triangles on the animal's surface, and its other half.
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "animal_half.h"

namespace pelage::animal {
namespace {

struct Rings {
    std::vector<uint> first, of;
};

// The neighbours of each vertex; on the wall both sides of the mirror count.
Rings ringsOf(const Half& half) {
    std::vector<std::uint64_t> pairs;
    pairs.reserve(half.triangles.size() * 6);
    for (const uvec3& t : half.triangles) {
        for (int i = 0; i < 3; ++i) {
            const uint a = t[i], b = t[(i + 1) % 3];
            pairs.push_back(std::uint64_t(a) << 32 | b);
            pairs.push_back(std::uint64_t(b) << 32 | a);
        }
    }
    tbb::parallel_sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Rings rings;
    rings.first.assign(half.positions.size() + 1, 0);
    for (const std::uint64_t p : pairs) ++rings.first[(p >> 32) + 1];
    for (std::size_t i = 1; i < rings.first.size(); ++i) rings.first[i] += rings.first[i - 1];
    rings.of.reserve(pairs.size());
    for (const std::uint64_t p : pairs) rings.of.push_back(uint(p));
    return rings;
}

// Where the vertices' neighbours pull it: their middle. A neighbour off the wall pulls a vertex of
// the wall twice, once from each side.
vec3 middleOfRing(const Half& half, const Rings& rings, std::size_t v) {
    vec3 sum(0.0f);
    float count = 0.0f;
    for (uint i = rings.first[v]; i < rings.first[v + 1]; ++i) {
        const uint n = rings.of[i];
        const float weight = half.onWall[v] && !half.onWall[n] ? 2.0f : 1.0f;
        sum += weight * half.positions[n];
        count += weight;
    }
    return sum / count;
}

// Where the mesh is too coarse for a detail of the solid, the solid's normal there says nothing
// about the mesh: the normal of its faces takes its place.
void mendNormals(Half& half) {
    std::vector<vec3> sums(half.positions.size(), vec3(0.0f));
    for (const uvec3& t : half.triangles) {
        const vec3 a = half.positions[t.x];
        const vec3 face = glm::cross(half.positions[t.y] - a, half.positions[t.z] - a);
        for (int i = 0; i < 3; ++i) sums[t[i]] += face;
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
        if (half.onWall[v]) sums[v].x = 0.0f;
        const float size = std::sqrt(glm::dot(sums[v], sums[v]));
        if (size > 1e-20f && glm::dot(sums[v], half.normals[v]) < 0.6f * size) {
            half.normals[v] = sums[v] / size;
        }
    }
}

}  // namespace

void relax(const Shape& shape, Half& half, float cell) {
    constexpr int kRounds = 7;
    const Rings rings = ringsOf(half);
    const std::size_t count = half.positions.size();
    half.normals.resize(count);
    std::vector<vec3> moved = half.positions;
    // One Newton step to the surface; the gradient there is the next normal.
    const auto settle = [&](std::size_t v, vec3 p) {
        if (half.onWall[v]) p.x = 0.0f;
        p.x = std::max(p.x, 0.0f);
        const Sample s = shape.sample(p);
        const float slope = glm::dot(s.gradient, s.gradient);
        const float step = s.distance / std::max(slope, 0.25f);
        p -= std::clamp(step, -0.5f * cell, 0.5f * cell) * s.gradient;
        vec3 n = s.gradient / std::sqrt(std::max(slope, 1e-12f));
        if (half.onWall[v]) {
            p.x = n.x = 0.0f;
            n /= std::sqrt(std::max(glm::dot(n, n), 1e-12f));
        }
        p.x = std::max(p.x, 0.0f);
        half.normals[v] = n;
        moved[v] = p;
    };
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t v) { settle(v, half.positions[v]); });
    for (int round = 0; round < kRounds; ++round) {
        half.positions = moved;
        tbb::parallel_for(std::size_t(0), count, [&](std::size_t v) {
            const vec3 p = half.positions[v], n = half.normals[v];
            const vec3 pull = middleOfRing(half, rings, v) - p;
            settle(v, p + 0.6f * (pull - glm::dot(pull, n) * n));
        });
    }
    for (int step = 0; step < 3; ++step) {
        tbb::parallel_for(std::size_t(0), count, [&](std::size_t v) { settle(v, moved[v]); });
    }
    half.positions = std::move(moved);
}

Surface mirrored(Half half, float cell) {
    mendNormals(half);
    Surface surface;
    surface.cell = cell;
    surface.positions = half.positions;
    surface.normals = std::move(half.normals);
    std::vector<uint> twin(half.positions.size());
    for (std::size_t v = 0; v < half.positions.size(); ++v) {
        twin[v] = uint(v);
        if (half.onWall[v]) continue;
        twin[v] = uint(surface.positions.size());
        const vec3 p = surface.positions[v], n = surface.normals[v];
        surface.positions.push_back({-p.x, p.y, p.z});
        surface.normals.push_back({-n.x, n.y, n.z});
    }
    surface.triangles = half.triangles;
    for (const uvec3& t : half.triangles) {
        surface.triangles.push_back({twin[t.x], twin[t.z], twin[t.y]});
    }
    return surface;
}

}  // namespace pelage::animal
