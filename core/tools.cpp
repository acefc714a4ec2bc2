// tools.cpp -- the tools of the brush, a few lines each, and their table.
#include "tools.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace pelage {
namespace {

constexpr std::array<ToolInfo, 5> kTools{{
    {Tool::length, "length", "Length", "Grows, shortens or sets the length of the hair.", true,
     0.0f, 0.5f},
    {Tool::density, "density", "Density", "Changes how many of the hairs grow.", true, 0.0f, 1.0f},
    {Tool::comb, "comb", "Comb", "Lays the hair along the stroke and keeps its length.", false,
     0.0f, 1.0f},
    {Tool::smooth, "smooth", "Smooth", "Evens out length, density and direction.", false, 0.0f,
     1.0f},
    {Tool::mask, "mask", "Mask", "Protects hair from the other brushes.", true, 0.0f, 1.0f},
}};
constexpr std::array<const char*, 3> kModes{"add", "subtract", "set"};
constexpr std::array<const char*, 4> kFalloffs{"smooth", "linear", "sharp", "constant"};

constexpr float kLengthStep =
    0.04f;  // share of the skin's size by which one full stroke grows hair
constexpr float kGreatestLength = 1e6f;

float changed(float before, const Brush& brush, float share, float step, float value) {
    switch (brush.mode) {
        case Mode::add:
            return before + share * step;
        case Mode::subtract:
            return before - share * step;
        case Mode::set:
            return glm::mix(before, value, share);
    }
    return before;
}

// At most as long as 1.
vec3 shortened(vec3 direction) {
    const float length = glm::length(direction);
    return length > 1.0f ? direction / length : direction;
}

float lengthAfter(const Skin& skin, float before, const Brush& brush, uint v, float share) {
    const float scale = skin.frames[skin.vertices[v].frame].scale;
    const float step = kLengthStep * skin.size() / scale;
    const float after = changed(before, brush, share, step, brush.value / scale);
    return std::isfinite(after) ? std::clamp(after, 0.0f, kGreatestLength) : before;
}

// The path without its part along the normal, unit, or zero where nothing is left of it.
vec3 onTangentPlane(vec3 path, vec3 normal) {
    const float length = glm::length(path);
    if (!(length > 0.0f) || !std::isfinite(length)) return vec3(0.0f);
    path /= length;
    path -= normal * glm::dot(path, normal);
    const float left = glm::length(path);
    return left > 1e-3f ? path / left : vec3(0.0f);
}

vec3 combed(const Skin& skin, const FurVertex& before, const Brush& brush, uint v,
            const Touching& touching, float share) {
    vec3 target = onTangentPlane(touching.path, skin.vertices[v].normal);
    if (target == vec3(0.0f)) return before.direction;
    if (brush.mode == Mode::subtract) target = -target;
    FurVertex fur = furToWorld(skin, v, before);
    fur.direction = shortened(glm::mix(fur.direction, target, share));
    return shortened(furToMesh(skin, v, fur).direction);
}

// Adds differences and mixes no values, so that an even field stays as it is to the last bit.
FurVertex smoothed(const Skin& skin, const FurVertex& old, uint v, const FurVertex& around,
                   float share) {
    const FurVertex here = furToWorld(skin, v, old);
    FurVertex change{};
    change.furLength = share * (around.furLength - here.furLength);
    change.direction = share * (around.direction - here.direction);
    change = furToMesh(skin, v, change);
    FurVertex fur = old;
    fur.furLength = std::clamp(old.furLength + change.furLength, 0.0f, kGreatestLength);
    fur.density = std::clamp(old.density + share * (around.density - old.density), 0.0f, 1.0f);
    fur.tint = glm::clamp(old.tint + share * (around.tint - old.tint), vec3(0.0f), vec3(1.0f));
    if (change.direction != vec3(0.0f)) fur.direction = shortened(old.direction + change.direction);
    return fur;
}

bool finite(const FurVertex& fur) {
    return std::isfinite(fur.furLength) && std::isfinite(fur.density) &&
           std::isfinite(glm::dot(fur.direction, fur.direction));
}

}  // namespace

std::span<const ToolInfo> tools() { return kTools; }

const ToolInfo& toolInfo(Tool tool) {
    const ToolInfo& row = kTools[static_cast<std::size_t>(tool)];
    assert(row.tool == tool);
    return row;
}

std::span<const char* const> modeNames() { return kModes; }
std::span<const char* const> falloffNames() { return kFalloffs; }

FurVertex brushedFur(const Skin& skin, const Groom& before, const Brush& brush, uint v,
                     const Touching& touching) {
    const FurVertex old = before.fur[v];
    const float held = before.mask[v];
    const float share = touching.coverage * brush.strength;
    if (brush.tool == Tool::mask || share <= 0.0f || held >= 1.0f) return old;

    FurVertex fur = old;
    switch (brush.tool) {
        case Tool::length:
            fur.furLength = lengthAfter(skin, old.furLength, brush, v, share);
            break;
        case Tool::density:
            fur.density =
                std::clamp(changed(old.density, brush, share, 1.0f, brush.value), 0.0f, 1.0f);
            break;
        case Tool::comb:
            fur.direction = combed(skin, old, brush, v, touching, share);
            break;
        case Tool::smooth:
            fur = smoothed(skin, old, v, touching.around, share);
            break;
        case Tool::mask:
            break;
    }
    if (held > 0.0f) {
        fur.furLength = glm::mix(fur.furLength, old.furLength, held);
        fur.density = glm::mix(fur.density, old.density, held);
        fur.direction = glm::mix(fur.direction, old.direction, held);
        fur.tint = glm::mix(fur.tint, old.tint, held);
    }
    // A singular frame or a field from a hostile file may have no finite answer.
    return finite(fur) ? fur : old;
}

float brushedMask(const Groom& before, const Brush& brush, uint v, const Touching& touching) {
    const float old = before.mask[v];
    if (brush.tool != Tool::mask) return old;
    const float share = touching.coverage * brush.strength;
    return std::clamp(changed(old, brush, share, 1.0f, brush.value), 0.0f, 1.0f);
}

}  // namespace pelage
