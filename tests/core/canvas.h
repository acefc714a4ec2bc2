// canvas.h -- a skin with hair to paint on, and measures of what painting changed.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/brush.h"
#include "test_skins.h"

namespace pelage::test {

inline constexpr vec3 kUp(0.0f, 1.0f, 0.0f);

// A skin to paint on, and its hair.
struct Canvas {
    std::shared_ptr<const Skin> skin;
    SkinQuery query;
    Groom groom;

    explicit Canvas(Source source)
        : skin(makeSkin(std::move(source))), query(skin), groom(evenGroom(*skin)) {}

    // The hair after one stroke along the path.
    Groom painted(const Brush& brush, const std::vector<vec3>& path, vec3 normal = kUp) const {
        Groom after = groom;
        Stroke stroke(query, groom, brush);
        for (const vec3 place : path) stroke.dab(after, place, normal);
        return after;
    }
};

inline Brush brushOf(Tool tool, Mode mode = Mode::add, float radius = 0.2f, float strength = 1.0f) {
    Brush brush;
    brush.tool = tool;
    brush.mode = mode;
    brush.radius = radius;
    brush.strength = strength;
    brush.value = tool == Tool::cut ? 0.01f : 0.25f;
    brush.color = vec3(0.75f, 0.5f, 0.25f);
    return brush;
}

// Uneven hair, so that there is something to smooth and to mix.
inline void shuffle(Canvas& canvas, uint seed) {
    Draws draws(seed);
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        FurVertex& fur = canvas.groom.fur.edit(v);
        fur.direction = 0.5f * draws.inBox(1.0f);
        fur.furLength = draws.in(0.01f, 0.1f);
        fur.density = draws.in(0.1f, 0.9f);
        fur.tint = 0.5f + draws.inBox(0.5f);
    }
}

inline float largestDifference(const Groom& a, const Groom& b) {
    float most = 0.0f;
    for (std::size_t v = 0; v < a.fur.size(); ++v) {
        const FurVertex &p = a.fur[v], &q = b.fur[v];
        most = std::max({most, std::abs(p.furLength - q.furLength), std::abs(p.density - q.density),
                         glm::distance(p.direction, q.direction), glm::distance(p.tint, q.tint),
                         std::abs(a.mask[v] - b.mask[v])});
    }
    return most;
}

inline bool equalValues(const Groom& a, const Groom& b) {
    for (std::size_t v = 0; v < a.fur.size(); ++v)
        if (!(a.fur[v] == b.fur[v]) || a.mask[v] != b.mask[v]) return false;
    return true;
}

// From one place to the other in equal parts, both ends among them.
inline std::vector<vec3> straight(vec3 from, vec3 to, int parts) {
    std::vector<vec3> path;
    for (int i = 0; i <= parts; ++i)
        path.push_back(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(parts)));
    return path;
}

inline const std::vector<Tool> kAllTools = [] {
    std::vector<Tool> all;
    for (const ToolInfo& info : tools()) all.push_back(info.tool);
    return all;
}();

}  // namespace pelage::test
