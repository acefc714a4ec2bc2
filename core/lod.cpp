// lod.cpp -- which clusters of hair are drawn, how many of their hairs, how fine.
#include "lod.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelage {
namespace {

constexpr float kLeastShare = 0.01f;  // of the rules without an error; some hair at any distance
constexpr float kFadeWindow = 0.4f;   // share of the level of detail over which hairs fade
constexpr uint kMostSegments = 16;
// What a hair costs besides its segments, in segments; from the styles' times in tests/bench.
constexpr float kGrowth = 10.0f;

// Planes of the view volume, pointing inwards, normalised so that they measure metres. Gribb and
// Hartmann, "Fast Extraction of Viewing Frustum Planes", 2001. The near plane is left out: a
// cluster around the eye is always kept.
std::array<vec4, 4> sidePlanes(const mat4& m) {
    const mat4 rows = glm::transpose(m);
    std::array<vec4, 4> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                               rows[3] - rows[1]};
    for (vec4& plane : planes) plane /= std::max(glm::length(vec3(plane)), 1e-30f);
    return planes;
}

// Where all of a convex body lies in the window that reaches from `center` as far as `extent(e)`
// along unit vectors e.
template <typename Extent>
Outline outlineOf(const Sight& sight, vec3 center, const Extent& extent) {
    const mat4 rows = glm::transpose(sight.viewProjection);
    const auto span = [&](vec4 row) {
        const float middle = glm::dot(row, vec4(center, 1.0f));
        const float length = glm::length(vec3(row));
        if (!(length > 0.0f)) return vec2(middle);
        const vec3 axis = vec3(row) / length;
        return vec2(middle - length * extent(-axis), middle + length * extent(axis));
    };
    const vec2 w = span(rows[3]);
    Outline outline;
    if (!(w.x > 0.0f)) return outline;
    outline.known = true;
    for (int axis = 0; axis < 2; ++axis) {
        const vec2 x = span(rows[axis]);
        const float least = x.x / (x.x < 0.0f ? w.x : w.y);
        const float greatest = x.y / (x.y < 0.0f ? w.y : w.x);
        const float size = static_cast<float>(sight.size[axis]);
        outline.lower[axis] = (0.5f + 0.5f * least) * size;
        outline.upper[axis] = (0.5f + 0.5f * greatest) * size;
    }
    return outline;
}

bool isHidden(const Cluster& cluster, const Tuft& tuft, const Pelt& pelt, const Sight& sight,
              const SkinDepth& skin) {
    const auto extent = [&](vec3 e) { return cluster.radius + reachAlong(tuft, pelt, e); };
    const Outline outline = outlineOf(sight, cluster.center, extent);
    if (!outline.known) return false;
    // Hairs are round: their fronts stand before their axes.
    const float towards = extent(-sight.forward) + 0.5f * pelt.widest;
    const vec3 nearest = cluster.center - towards * sight.forward;
    const vec4 clip = sight.viewProjection * vec4(nearest, 1.0f);
    if (!(clip.w > 0.0f)) return false;
    constexpr float kRounding = 1e-6f;
    return skin.hides(outline.lower - 1.0f, outline.upper + 1.0f,
                      0.5f + 0.5f * clip.z / clip.w - kRounding);
}

// Segments of a hair of so many pixels, as segmentsFor; of the hair that bends most.
float segmentsOf(const Fineness& fineness, float bend, float pixels) {
    const float most = static_cast<float>(fineness.segments);
    if (!fineness.adapts) return most;
    return std::clamp(std::sqrt(0.25f * bend * pixels / fineness.tolerance), 1.0f, most);
}

float shareOf(const InSight::Seen& seen, const Sight& sight, const Pelt& pelt, const Detail& detail,
              float deviation) {
    const float mean = pelt.meanWidth * sight.pixelsPerMetre / seen.distance;
    const float widest = pelt.widest * sight.pixelsPerMetre / seen.distance;
    return shareKept(detail, mean, widest, deviation);
}

double workOf(const InSight::Seen& seen, float lod, const Pelt& pelt, const Fineness& fineness) {
    return static_cast<double>(lod * seen.hairs *
                               (kGrowth + segmentsOf(fineness, pelt.bend, seen.pixels)));
}

}  // namespace

float Sight::distanceTo(vec3 place) const {
    return perspective ? std::max(glm::dot(place - eye, forward), 1e-6f) : 1.0f;
}

Outline outlineOf(const Sight& sight, vec3 center, float radius) {
    return outlineOf(sight, center, [=](vec3) { return radius; });
}

Outline outlineOf(const Sight& sight, vec3 lower, vec3 upper, float reach) {
    const vec3 half = 0.5f * (upper - lower);
    return outlineOf(sight, 0.5f * (lower + upper),
                     [=](vec3 e) { return glm::dot(half, glm::abs(e)) + reach; });
}

SkinDepth::SkinDepth(ivec2 corner, int width, std::span<const float> strips) : corner_(corner) {
    if (width < 1 || strips.empty()) return;
    Level first{{(width + kTile - 1) / kTile, static_cast<int>(strips.size()) / width}, {}};
    first.farthest.assign(
        static_cast<std::size_t>(first.size.x) * static_cast<std::size_t>(first.size.y), 0.0f);
    for (std::size_t y = 0, at = 0; y < static_cast<std::size_t>(first.size.y); ++y) {
        float* tiles = first.farthest.data() + y * static_cast<std::size_t>(first.size.x);
        for (int x = 0; x < width; ++x, ++at)
            tiles[x / kTile] = std::max(tiles[x / kTile], strips[at]);
    }
    levels_.push_back(std::move(first));
    while (levels_.back().size != ivec2(1)) {
        const Level& fine = levels_.back();
        Level level{(fine.size + 1) / 2, {}};
        for (int y = 0; y < level.size.y; ++y)
            for (int x = 0; x < level.size.x; ++x) {
                float farthest = 0.0f;
                for (int j = 2 * y; j < std::min(2 * y + 2, fine.size.y); ++j)
                    for (int i = 2 * x; i < std::min(2 * x + 2, fine.size.x); ++i)
                        farthest = std::max(
                            farthest, fine.farthest[static_cast<std::size_t>(j * fine.size.x + i)]);
                level.farthest.push_back(farthest);
            }
        levels_.push_back(std::move(level));
    }
}

bool SkinDepth::hides(vec2 lower, vec2 upper, float depth) const {
    if (levels_.empty()) return false;
    const ivec2 limit = levels_.front().size * kTile;
    const vec2 low = glm::clamp(lower - vec2(corner_), vec2(0.0f), vec2(limit));
    const vec2 high = glm::clamp(upper - vec2(corner_), vec2(0.0f), vec2(limit));
    ivec2 first = ivec2(low) / kTile;
    ivec2 last = glm::min(ivec2(high) / kTile, levels_.front().size - 1);
    std::size_t level = 0;
    for (; glm::max(last.x - first.x, last.y - first.y) > 3; first /= 2, last /= 2) ++level;
    const Level& tiles = levels_[level];
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            if (!(tiles.farthest[static_cast<std::size_t>(y * tiles.size.x + x)] < depth))
                return false;
    return true;
}

InSight lookAt(const Roots& roots, std::span<const Tuft> tufts, const Pelt& pelt,
               const Sight& sight, const SkinDepth* skin) {
    InSight seen;
    const auto planes = sidePlanes(sight.viewProjection);
    const auto outside = [&](const Cluster& cluster, const Tuft& tuft) {
        return std::ranges::any_of(planes, [&](const vec4& plane) {
            const float extent = cluster.radius + reachAlong(tuft, pelt, vec3(plane));
            return glm::dot(vec3(plane), cluster.center) + plane.w < -extent;
        });
    };
    for (uint c = 0; c < roots.clusters.size(); ++c) {
        const Cluster& cluster = roots.clusters[c];
        const Tuft& tuft = tufts[c];
        const float hairs = tuft.densest * static_cast<float>(cluster.count);
        if (pelt.coats == 0 || !(tuft.longest > 0.0f) || !(hairs > 0.0f)) {
            ++seen.bald;
            continue;
        }
        if (skin && outside(cluster, tuft)) {
            ++seen.outside;
            continue;
        }
        if (skin && isHidden(cluster, tuft, pelt, sight, *skin)) {
            ++seen.hidden;
            continue;
        }
        const float distance = sight.distanceTo(cluster.center);
        const float nearest = sight.distanceTo(cluster.center - cluster.radius * sight.forward);
        seen.clusters.push_back({c, distance, nearest, hairs,
                                 pelt.length * tuft.longest * sight.pixelsPerMetre / distance});
    }
    return seen;
}

float deviationOf(const Detail& detail, float needed) {
    return detail.rule == Detail::Rule::pixels ? std::max(detail.limit, needed) : needed;
}

Fineness finenessOf(const Detail& detail, float deviation, const Fineness& otherwise) {
    if (detail.rule == Detail::Rule::pixels)
        return {kMostSegments, deviationOf(detail, deviation), true};
    // Pictures get as close to those of all hairs as is asked for.
    const bool approaches = detail.rule == Detail::Rule::flip;
    if (!(deviation > (approaches ? otherwise.tolerance : 0.0f))) return otherwise;
    return {otherwise.segments, std::max(otherwise.tolerance, deviation), true};
}

float shareKept(const Detail& detail, float pixels, float widest, float deviation) {
    float share = 1.0f;
    if (detail.rule == Detail::Rule::distance)
        share = std::clamp(std::min(1.0f, pixels), kLeastShare, 1.0f);
    if (detail.rule == Detail::Rule::share) share = std::clamp(detail.limit, kLeastShare, 1.0f);
    deviation = deviationOf(detail, deviation);
    if (!(deviation > 0.0f)) return share;
    // Divided by this share, the widest hair is 2 deviations wider: one on each side.
    return std::min(share, widest / (widest + 2.0f * deviation));
}

double workOf(const InSight& seen, const Sight& sight, const Pelt& pelt, const Detail& detail,
              float deviation, const Fineness& otherwise) {
    const Fineness fineness = finenessOf(detail, deviation, otherwise);
    double work = 0.0;
    for (const InSight::Seen& one : seen.clusters)
        work += workOf(one, shareOf(one, sight, pelt, detail, deviation), pelt, fineness);
    return work;
}

Choice choose(const Roots& roots, const InSight& seen, const Sight& sight, const Pelt& pelt,
              const Detail& detail, float deviation, const Fineness& otherwise) {
    Choice choice;
    choice.fineness = finenessOf(detail, deviation, otherwise);
    choice.clusters.reserve(seen.clusters.size());
    for (const InSight::Seen& one : seen.clusters) {
        const Cluster& cluster = roots.clusters[one.cluster];
        const float lod = shareOf(one, sight, pelt, detail, deviation);
        const float fade = std::min(1.0f, lod * (1.0f + 0.5f * kFadeWindow));
        choice.work += workOf(one, lod, pelt, choice.fineness);
        // Hair i is of rank (i + phase) / count.
        const float wanted = std::ceil(fade * one.hairs - cluster.phase);
        if (!(wanted > 0.0f)) {
            ++choice.small;
            continue;
        }
        const uint hairs = std::min(static_cast<uint>(wanted), cluster.count);
        const float widest = pelt.widest * sight.pixelsPerMetre / (one.nearest * lod);
        choice.clusters.push_back({one.cluster, lod, fade, hairs, widest <= kRoundFrom});
        choice.hairs += hairs;
    }
    return choice;
}

float deviationWithin(double work, const InSight& seen, const Sight& sight, const Pelt& pelt,
                      const Detail& detail, const Fineness& otherwise) {
    const auto fits = [&](float deviation) {
        return workOf(seen, sight, pelt, detail, deviation, otherwise) <= work;
    };
    if (fits(0.0f)) return 0.0f;
    // Halves the ratio of the bounds.
    float fine = 1e-3f, coarse = kMostDeviation;
    for (int i = 0; i < 12; ++i) {
        const float middle = std::sqrt(fine * coarse);
        (fits(middle) ? coarse : fine) = middle;
    }
    return coarse;
}

}  // namespace pelage
