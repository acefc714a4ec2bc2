// region.cpp -- the weights of each kind of region.
#include "region.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "body.h"
#include "narrow.h"

namespace pelage {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kFacingRamp = 0.2f;  // cosine to the eye from which a vertex counts in full

// [0,1] at `distance` outside a border: 1 up to it and 0 from `falloff` on. 0 for what is no
// number.
float fade(float distance, float falloff) {
    if (distance <= 0.0f) return 1.0f;
    if (!(distance < falloff)) return 0.0f;
    const float x = distance / falloff;
    return 1.0f - x * x * (3.0f - 2.0f * x);
}

template <class Weight>
std::vector<float> weightsOf(const Skin& skin, const Weight& weight) {
    std::vector<float> weights(skin.vertices.size());
    tbb::parallel_for(tbb::blocked_range<uint>(0, static_cast<uint>(weights.size()), 1024),
                      [&](const auto& range) {
                          for (uint v = range.begin(); v < range.end(); ++v) weights[v] = weight(v);
                      });
    return weights;
}

// The inverse of the turn by |turn| about it, as a matrix (Rodrigues).
mat3 turnedBack(vec3 turn) {
    const float angle = glm::length(turn);
    if (angle == 0.0f) return mat3(1.0f);
    const vec3 k = turn / angle;
    const float c = std::cos(angle), s = std::sin(angle);
    const mat3 cross(vec3(0.0f, k.z, -k.y), vec3(-k.z, 0.0f, k.x), vec3(k.y, -k.x, 0.0f));
    return c * mat3(1.0f) + (1.0f - c) * glm::outerProduct(k, k) - s * cross;
}

// m outside the box.
float outsideBox(vec3 local, vec3 half) {
    const vec3 beyond = glm::max(glm::abs(local) - half, vec3(0.0f));
    // max drops what is no number.
    const float sum = local.x + local.y + local.z + half.x + half.y + half.z;
    return std::isnan(sum) ? kInfinite : glm::length(beyond);
}

// 1 at the seeds, fading with the distance along edges from the nearest of them.
std::vector<float> spread(const Skin& skin, const std::vector<bool>& seeds, float falloff) {
    std::vector<float> distance(skin.vertices.size(), kInfinite);
    using Entry = std::pair<float, uint>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
    for (uint v = 0; v < distance.size(); ++v) {
        if (!seeds[v]) continue;
        distance[v] = 0.0f;
        if (falloff > 0.0f) open.push({0.0f, v});
    }
    while (!open.empty()) {
        const auto [far, v] = open.top();
        open.pop();
        if (far > distance[v]) continue;
        for (const uint u : skin.ring(v)) {
            const float next =
                far + glm::distance(skin.vertices[v].position, skin.vertices[u].position);
            if (!(next < falloff) || !(next < distance[u])) continue;
            distance[u] = next;
            open.push({next, u});
        }
    }
    return weightsOf(skin, [&](uint v) { return fade(distance[v], falloff); });
}

// A lasso ready to test points: its polygon in units of half the picture's height.
struct Lasso {
    std::vector<vec2> border;
    vec2 lower{0.0f}, upper{0.0f};
    vec2 unit{1.0f};  // from clip space to those units
    bool parallel = false;
    vec3 towardsEye{0.0f};  // of a parallel projection
};

Lasso lassoOf(const Region& region) {
    Lasso lasso;
    const mat4& m = region.viewProjection;
    const auto row = [&](int r) { return vec3(m[0][r], m[1][r], m[2][r]); };
    // The rows of x and y differ in length by the aspect of the picture.
    const float aspect = glm::length(row(1)) / glm::length(row(0));
    if (aspect > 0.0f && std::isfinite(aspect)) lasso.unit.x = aspect;
    lasso.parallel = row(3) == vec3(0.0f);
    lasso.towardsEye = -row(2);
    lasso.lower = vec2(kInfinite);
    lasso.upper = vec2(-kInfinite);
    for (const vec2 point : region.polygon) {
        lasso.border.push_back(point * lasso.unit);
        lasso.lower = glm::min(lasso.lower, lasso.border.back());
        lasso.upper = glm::max(lasso.upper, lasso.border.back());
        if (!std::isfinite(point.x + point.y)) return {};
    }
    return lasso;
}

float distanceToLine(vec2 p, vec2 a, vec2 b) {
    const vec2 along = b - a;
    const float square = glm::dot(along, along);
    const float t = square > 0.0f ? glm::clamp(glm::dot(p - a, along) / square, 0.0f, 1.0f) : 0.0f;
    return glm::distance(p, a + t * along);
}

// How far outside the polygon, 0 inside. Inside is what the polygon winds around.
float outsideLasso(const Lasso& lasso, vec2 p, float falloff) {
    const vec2 beyond = glm::max(lasso.lower - p, p - lasso.upper);
    if (!(std::max(beyond.x, beyond.y) <= std::max(falloff, 0.0f))) return kInfinite;
    int winds = 0;
    float nearest = kInfinite;
    for (std::size_t i = 0; i < lasso.border.size(); ++i) {
        const vec2 a = lasso.border[i], b = lasso.border[(i + 1) % lasso.border.size()];
        const float side = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y);
        if (a.y <= p.y && b.y > p.y && side > 0.0f) ++winds;
        if (a.y > p.y && b.y <= p.y && side < 0.0f) --winds;
        if (falloff > 0.0f) nearest = std::min(nearest, distanceToLine(p, a, b));
    }
    return winds != 0 ? 0.0f : nearest;
}

float lassoWeight(const Region& region, const Lasso& lasso, const SkinVertex& vertex) {
    const vec4 clip = region.viewProjection * vec4(vertex.position, 1.0f);
    if (!(clip.w > 0.0f)) return 0.0f;  // behind the eye
    const vec2 place = vec2(clip) / clip.w * lasso.unit;
    const float weight = fade(outsideLasso(lasso, place, region.falloff), region.falloff);
    if (weight == 0.0f || vertex.normal == vec3(0.0f)) return weight;
    const vec3 towards = lasso.parallel ? lasso.towardsEye : region.eye - vertex.position;
    const float far = glm::length(towards);
    if (!(far > 0.0f) || !std::isfinite(far)) return 0.0f;
    return weight * glm::smoothstep(0.0f, kFacingRamp, glm::dot(vertex.normal, towards / far));
}

}  // namespace

std::vector<float> regionWeights(const SkinQuery& query, const Groom& groom, const Region& region) {
    const Skin& skin = query.skin();
    assert(groom.mask.size() == skin.vertices.size());
    const float unit = region.sizes ? skin.size() : 1.0f;
    const float falloff = region.falloff * unit;
    switch (region.where) {
        case Where::all:
            return std::vector<float>(skin.vertices.size(), 1.0f);
        case Where::sphere:
            return weightsOf(skin, [&](uint v) {
                const float far = glm::distance(skin.vertices[v].position, region.center);
                return fade(far - region.radius * unit, falloff);
            });
        case Where::box: {
            const mat3 back = turnedBack(region.turn);
            return weightsOf(skin, [&](uint v) {
                const vec3 local = back * (skin.vertices[v].position - region.center);
                return fade(outsideBox(local, region.half * unit), falloff);
            });
        }
        case Where::segment: {
            const uint segment = segmentNamed(groom.body(), region.segment);
            std::vector<bool> seeds(skin.vertices.size());
            for (uint v = 0; v < seeds.size(); ++v) seeds[v] = groom.segmentOf[v] == segment;
            return spread(skin, seeds, falloff);
        }
        case Where::mask: {
            std::vector<bool> seeds(skin.vertices.size());
            for (uint v = 0; v < seeds.size(); ++v) seeds[v] = groom.mask[v] >= 0.5f;
            std::vector<float> weights(seeds.size(), 0.0f);
            if (falloff > 0.0f) weights = spread(skin, seeds, falloff);
            for (uint v = 0; v < seeds.size(); ++v)
                weights[v] = seeds[v] ? groom.mask[v] : std::max(weights[v], groom.mask[v]);
            return weights;
        }
        case Where::narrow: {
            const float width = region.width * unit;
            const float farthest = falloff > 0.0f ? width + falloff : width;
            return weightsOf(skin, [&](uint v) {
                return fade(thicknessAt(query, v, farthest) - width, falloff);
            });
        }
        case Where::curved:
            return weightsOf(skin, [&](uint v) {
                return fade(region.curvature - curvatureAt(skin, v) * unit, region.falloff);
            });
        case Where::lasso: {
            const Lasso lasso = lassoOf(region);
            if (lasso.border.size() < 3) return std::vector<float>(skin.vertices.size(), 0.0f);
            return weightsOf(skin,
                             [&](uint v) { return lassoWeight(region, lasso, skin.vertices[v]); });
        }
    }
    return {};
}

}  // namespace pelage
