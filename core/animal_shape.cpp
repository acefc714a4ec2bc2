// animal_shape.cpp -- the distance to the animal: pieces melted into each other.
//
// A cubic smooth minimum (Quilez, "Smooth minimum", 2013) joins the pieces one after another; it is
// exact where two of them differ by more than the blend, so that pieces far away can be left out.
#include "animal_shape.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "animal_body.h"

namespace pelage::animal {
namespace {

constexpr float kGridCell = 0.025f;    // m; of the grid of candidates
constexpr int kGroup = 4;              // cells along the edge of a group
constexpr float kReach = 0.08f;        // m; beyond this a piece neither blends nor colors
constexpr float kBlendReach = 0.055f;  // m; of the weights of hair and color

vec3 unit(vec3 v) {
    const float size = std::sqrt(glm::dot(v, v));
    return size > 1e-12f ? v / size : vec3(0.0f, 1.0f, 0.0f);
}

// a and b joined with a fillet of size k.
Sample smoothMin(const Sample& a, const Sample& b, float k) {
    const Sample& low = a.distance <= b.distance ? a : b;
    const Sample& high = a.distance <= b.distance ? b : a;
    const float gap = high.distance - low.distance;
    if (gap >= k) return low;
    const float h = (k - gap) / k;
    const float share = 0.5f * h * h;
    return {low.distance - h * h * h * k / 6.0f,
            (1.0f - share) * low.gradient + share * high.gradient};
}

Sample negated(const Sample& s) { return {-s.distance, -s.gradient}; }

Sample smoothMax(const Sample& a, const Sample& b, float k) {
    return negated(smoothMin(negated(a), negated(b), k));
}

// A cone with round ends: the hull of two balls.
Sample roundCone(vec3 p, vec3 a, vec3 b, float ra, float rb) {
    const vec3 axis = b - a;
    const float length = std::sqrt(glm::dot(axis, axis));
    const float shrink = ra - rb;
    const float slant = std::sqrt(std::max(length * length - shrink * shrink, 1e-12f));
    const vec3 u = axis / length;
    const vec3 fromA = p - a;
    const float h = glm::dot(fromA, u);
    const vec3 radial = fromA - h * u;
    const float rho = std::sqrt(glm::dot(radial, radial));
    const float foot = h - rho * shrink / slant;
    if (foot <= 0.0f) return {std::sqrt(glm::dot(fromA, fromA)) - ra, unit(fromA)};
    if (foot >= length) return {std::sqrt(glm::dot(p - b, p - b)) - rb, unit(p - b)};
    const vec3 outwards = rho > 1e-12f ? radial / rho : vec3(0.0f);
    return {(rho * slant + h * shrink) / length - ra, (outwards * slant + u * shrink) / length};
}

// First-order distance to an ellipsoid whose axes are those of the world.
Sample ellipsoid(vec3 p, vec3 middle, vec3 radii) {
    const vec3 q = (p - middle) / radii;
    const vec3 g = q / radii;
    const float k0 = std::sqrt(glm::dot(q, q));
    const float k1 = std::sqrt(glm::dot(g, g));
    if (k1 < 1e-9f) return {-std::min({radii.x, radii.y, radii.z}), vec3(0.0f, 1.0f, 0.0f)};
    return {k0 * (k0 - 1.0f) / k1, g / k1};
}

// A round cone squeezed to `flat` times its thickness along `facing`.
Sample flatCone(vec3 p, vec3 a, vec3 b, float ra, float rb, vec3 facing, float flat) {
    const auto stretched = [&](vec3 v) {
        return v + (1.0f / flat - 1.0f) * glm::dot(v, facing) * facing;
    };
    const Sample s = roundCone(stretched(p - a), vec3(0.0f), stretched(b - a), ra, rb);
    const vec3 g = stretched(s.gradient);
    const float slope = std::sqrt(glm::dot(g, g));
    return {s.distance / slope, g / slope};
}

// A leaf with a hollow on its front.
Sample ear(vec3 p, const Part& part) {
    const float flat = part.radii.x;
    const Sample leaf = flatCone(p, part.a, part.b, part.ra, part.rb, part.facing, flat);
    const float depth = part.radii.y;
    if (depth <= 0.0f) return leaf;
    const vec3 up = unit(part.b - part.a);
    const vec3 forward = part.facing * depth;
    const Sample hollow =
        flatCone(p, part.a + forward + 0.012f * up, part.b + forward - 0.022f * up, part.ra * 0.74f,
                 part.rb * 0.55f, part.facing, flat * 0.95f);
    return smoothMax(leaf, negated(hollow), 0.008f);
}

Sample single(vec3 p, const Part& part) {
    switch (part.form) {
        case Form::cone:
            return roundCone(p, part.a, part.b, part.ra, part.rb);
        case Form::ellipsoid:
            return ellipsoid(p, part.a, part.radii);
        case Form::ear:
            return ear(p, part);
    }
    return {};
}

// The piece, with its mirror image where it has one.
Sample whole(vec3 p, const Part& part) {
    const Sample here = single(p, part);
    // The image is farther than the plane x = 0 and the piece's own way from it.
    const float inner = std::min(part.a.x - part.ra, part.b.x - part.rb) - part.radii.x;
    if (!part.paired || here.distance + part.blend < p.x + inner) return here;
    Sample there = single(vec3(-p.x, p.y, p.z), part);
    there.gradient.x = -there.gradient.x;
    return smoothMin(here, there, std::max(part.blend, 1e-4f));
}

struct Grid {
    int x, y, z;  // cells
    std::size_t index(int i, int j, int k) const { return std::size_t((k * y + j) * x + i); }
};
Grid gridOf() {
    const vec3 cells = (kUpper - kLower) / kGridCell;
    return {int(cells.x) + 1, int(cells.y) + 1, int(cells.z) + 1};
}

}  // namespace

Shape::Shape(float cell) : parts_(bodyParts(cell)) {
    assert(parts_.size() <= Blend{}.terms.size());
    // Of some pieces, those that can matter to any point of a cube.
    const auto mattering = [&](const std::vector<unsigned char>& among, vec3 middle, float edge) {
        std::array<float, 64> distances;
        float least = 1e3f;
        for (const unsigned char i : among) {
            distances[i] = whole(middle, parts_[i]).distance;
            least = std::min(least, distances[i]);
        }
        std::vector<unsigned char> kept;
        const float most = least + 2.0f * kLipschitz * 0.867f * edge + kReach;
        for (const unsigned char i : among) {
            if (distances[i] <= most) kept.push_back(i);
        }
        return kept;
    };
    std::vector<unsigned char> all(parts_.size());
    std::iota(all.begin(), all.end(), static_cast<unsigned char>(0));
    const Grid grid = gridOf();
    near_.resize(std::size_t(grid.x) * std::size_t(grid.y) * std::size_t(grid.z));
    const auto coarse = [](int cells) { return (cells + kGroup - 1) / kGroup; };
    tbb::parallel_for(0, coarse(grid.z), [&](int gz) {
        for (int gy = 0; gy < coarse(grid.y); ++gy) {
            for (int gx = 0; gx < coarse(grid.x); ++gx) {
                const vec3 first(float(gx * kGroup), float(gy * kGroup), float(gz * kGroup));
                const float edge = float(kGroup) * kGridCell;
                const auto group = mattering(all, kLower + first * kGridCell + 0.5f * edge, edge);
                for (int i = 0; i < kGroup * kGroup * kGroup; ++i) {
                    const int x = gx * kGroup + i % kGroup;
                    const int y = gy * kGroup + i / kGroup % kGroup;
                    const int z = gz * kGroup + i / (kGroup * kGroup);
                    if (x >= grid.x || y >= grid.y || z >= grid.z) continue;
                    const vec3 cellPlace = vec3(float(x), float(y), float(z)) + 0.5f;
                    near_[grid.index(x, y, z)] =
                        mattering(group, kLower + cellPlace * kGridCell, kGridCell);
                }
            }
        }
    });
}

std::span<const unsigned char> Shape::candidates(vec3 p) const {
    const Grid grid = gridOf();
    const vec3 q = (p - kLower) / kGridCell;
    const int x = std::clamp(int(q.x), 0, grid.x - 1);
    const int y = std::clamp(int(q.y), 0, grid.y - 1);
    const int z = std::clamp(int(q.z), 0, grid.z - 1);
    return near_[grid.index(x, y, z)];
}

Sample Shape::sample(vec3 p) const {
    Sample sum{1e3f, vec3(0.0f)};
    for (const unsigned char i : candidates(p)) {
        sum = smoothMin(sum, whole(p, parts_[i]), std::max(parts_[i].blend, 1e-4f));
    }
    // The paws stand flat on the ground.
    return smoothMax(sum, Sample{-p.y, vec3(0.0f, -1.0f, 0.0f)}, 0.008f);
}

Blend Shape::blend(vec3 p) const {
    Blend blend;
    float least = 1e3f;
    std::array<float, 64> distances;
    std::size_t n = 0;
    for (const unsigned char i : candidates(p)) {
        const float distance = single(p, parts_[i]).distance;
        distances[n++] = distance;
        if (distance < least) {
            least = distance;
            blend.nearest = &parts_[i];
        }
    }
    float sum = 0.0f;
    n = 0;
    for (const unsigned char i : candidates(p)) {
        const Part& part = parts_[i];
        const float closeness = 1.0f - (distances[n++] - least) / kBlendReach;
        if (closeness <= 0.0f) continue;
        const vec3 axis = part.b - part.a;
        const float size = glm::dot(axis, axis);
        const float h =
            size > 0.0f ? std::clamp(glm::dot(p - part.a, axis) / size, 0.0f, 1.0f) : 0.0f;
        const float weight = closeness * closeness * closeness;
        blend.terms[blend.count++] = {&part, weight, part.start + h * (part.end - part.start)};
        sum += weight;
    }
    for (std::size_t i = 0; i < blend.count; ++i) blend.terms[i].weight /= sum;
    return blend;
}

}  // namespace pelage::animal
