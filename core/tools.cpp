// tools.cpp -- the tools of the brush, a few lines each, and their table.
#include "tools.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {
namespace {

constexpr std::array<ToolInfo, kToolCount> kTools{{
    {Tool::length, "length", "Length", "Grows, shortens or sets the length of the hair.", "Add",
     "Subtract", true, true, true, false, 0.0f, 0.5f},
    {Tool::cut, "cut", "Cut", "Shortens longer hair to a length; shorter hair stays.", nullptr,
     nullptr, true, false, true, false, 0.0f, 0.5f},
    {Tool::density, "density", "Density", "Changes how many of the hairs grow.", "Add", "Subtract",
     true, true, false, false, 0.0f, 1.0f},
    {Tool::comb, "comb", "Comb", "Lays the hair along the stroke and keeps its length.", "Along",
     "Against", false, false, false, false, 0.0f, 1.0f},
    {Tool::part, "part", "Part", "Lays the hair away from the stroke on both sides.", "Away",
     "Towards", false, false, false, true, 0.0f, 1.0f},
    {Tool::twist, "twist", "Twist", "Turns the hair about the normal, a quarter turn at most.",
     "Left", "Right", false, false, false, false, 0.0f, 1.0f},
    {Tool::clump, "clump", "Clump", "Gathers the hair over the middle of the stroke.", "Gather",
     "Spread", false, false, false, true, 0.0f, 1.0f},
    {Tool::puff, "puff", "Puff", "Makes the hair stand up.", "Up", "Down", false, false, false,
     false, 0.0f, 1.0f},
    {Tool::flatten, "flatten", "Flatten", "Lays the hair down the way it leans.", "Down", "Up",
     false, false, false, false, 0.0f, 1.0f},
    {Tool::smooth, "smooth", "Smooth", "Evens out length, density, direction and tint.", nullptr,
     nullptr, false, false, false, false, 0.0f, 1.0f},
    {Tool::tint, "tint", "Tint", "Colors the hair.", "Color", "Clear", false, false, false, false,
     0.0f, 1.0f},
    {Tool::mask, "mask", "Mask", "Protects hair from the other brushes.", "Add", "Subtract", true,
     false, false, false, 0.0f, 1.0f},
    {Tool::segment, "segment", "Segment", "Says to which part of the body the skin belongs.",
     "Paint", "Give back", false, false, false, false, 0.0f, 1.0f},
}};
constexpr std::array<const char*, 4> kModes{"add", "subtract", "set", "scale"};
constexpr std::array<const char*, 4> kFalloffs{"smooth", "linear", "sharp", "constant"};

constexpr float kLengthStep =
    0.04f;  // share of the skin's size by which one full stroke grows hair
constexpr float kLeastRadius = 1e-3f;  // of the skin's size; bounds the number of comb steps
constexpr float kMiddle = 0.1f;        // of the radius, where part and clump fade out
constexpr float kQuarterTurn = 0.5f * std::numbers::pi_v<float>;

float changed(float before, const Brush& brush, float share, float step, float value) {
    switch (modeOf(brush)) {
        case Mode::add:
            return before + share * step;
        case Mode::subtract:
            return before - share * step;
        case Mode::set:
            return glm::mix(before, value, share);
        case Mode::scale:
            return before * (1.0f + share * (brush.factor - 1.0f));
    }
    return before;
}

float lengthAfter(const Skin& skin, float before, const Brush& brush, uint v, float share) {
    const float scale = skin.frames[skin.vertices[v].frame].scale;
    const float step = kLengthStep * skin.size() / scale;
    const float after = changed(before, brush, share, step, brush.value / scale);
    return std::isfinite(after) ? std::clamp(after, 0.0f, kGreatestLength) : before;
}

float cutTo(const Skin& skin, float before, const Brush& brush, uint v, float share) {
    const float most = brush.value / skin.frames[skin.vertices[v].frame].scale;
    if (!(before > most)) return before;
    return std::clamp(glm::mix(before, most, share), 0.0f, before);
}

vec3 combed(const Skin& skin, const FurVertex& before, const Brush& brush, uint v,
            const Touching& touching, float share) {
    vec3 target = onTangentPlane(touching.path, skin.vertices[v].normal);
    if (target == vec3(0.0f)) return before.direction;
    if (brush.mode == Mode::subtract) target = -target;
    const FurVertex fur = furToWorld(skin, v, before);
    return inMesh(skin, v, fur, glm::mix(fur.direction, target, share));
}

// The way from the path to the vertex in the tangent plane.
struct Aside {
    vec3 heading{0.0f};     // unit, or zero on the path
    float distance = 0.0f;  // m
    float fade = 0.0f;      // [0,1] 0 on the path, where the heading is that of rounding errors
};

Aside asideOf(const Skin& skin, const Brush& brush, uint v, const Touching& touching) {
    const vec3 normal = skin.vertices[v].normal;
    const vec3 offset = touching.offset - glm::dot(touching.offset, normal) * normal;
    const float distance = glm::length(offset);
    if (!(distance > 0.0f) || !std::isfinite(distance)) return {};
    return {offset / distance, distance,
            std::min(1.0f, distance / (kMiddle * workingRadius(skin, brush)))};
}

vec3 parted(const Skin& skin, const FurVertex& before, const Brush& brush, uint v,
            const Touching& touching, float share) {
    const Aside aside = asideOf(skin, brush, v, touching);
    const float side = brush.mode == Mode::subtract ? -aside.fade : aside.fade;
    const FurVertex fur = furToWorld(skin, v, before);
    return inMesh(skin, v, fur, glm::mix(fur.direction, side * aside.heading, share));
}

vec3 clumped(const Skin& skin, const FurVertex& before, const Brush& brush, uint v,
             const Touching& touching, float share) {
    const Aside aside = asideOf(skin, brush, v, touching);
    if (!(aside.distance > 0.0f)) return before.direction;
    const FurVertex fur = furToWorld(skin, v, before);
    const float lean = aside.distance / std::max({fur.furLength, aside.distance,
                                                  kMiddle * workingRadius(skin, brush)});
    const float across = glm::dot(fur.direction, aside.heading);
    const float target = brush.mode == Mode::subtract ? lean : -lean;
    const float change = target - aside.fade * across;
    return inMesh(skin, v, fur, fur.direction + share * change * aside.heading);
}

vec3 twisted(const Skin& skin, const FurVertex& before, const Brush& brush, uint v, float turn) {
    const vec3 axis = skin.vertices[v].normal;
    if (axis == vec3(0.0f) || before.direction == vec3(0.0f)) return before.direction;
    const float angle = (brush.mode == Mode::subtract ? -turn : turn) * kQuarterTurn;
    const FurVertex fur = furToWorld(skin, v, before);
    const vec3 d = fur.direction;  // Rodrigues' rotation
    return inMesh(skin, v, fur,
                  d * std::cos(angle) + glm::cross(axis, d) * std::sin(angle) +
                      axis * (glm::dot(axis, d) * (1.0f - std::cos(angle))));
}

vec3 flattened(const Skin& skin, const FurVertex& before, uint v, float share) {
    const FurVertex fur = furToWorld(skin, v, before);
    const vec3 heading = onTangentPlane(fur.direction, skin.vertices[v].normal);
    if (heading == vec3(0.0f)) return before.direction;
    return inMesh(skin, v, fur, glm::mix(fur.direction, heading, share));
}

// Up or down.
vec3 stood(const Skin& skin, const FurVertex& before, const Brush& brush, uint v, float share) {
    const bool up = (brush.tool == Tool::puff) != (brush.mode == Mode::subtract);
    return up ? (1.0f - share) * before.direction : flattened(skin, before, v, share);
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

vec3 tinted(vec3 before, const Brush& brush, float share) {
    const vec3 target = brush.mode == Mode::subtract ? vec3(1.0f) : brush.color;
    return glm::clamp(before + share * (target - before), vec3(0.0f), vec3(1.0f));
}

bool finite(const FurVertex& fur) {
    return std::isfinite(fur.furLength) && std::isfinite(fur.density) &&
           std::isfinite(glm::dot(fur.direction, fur.direction)) &&
           std::isfinite(glm::dot(fur.tint, fur.tint));
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

vec3 shortened(vec3 direction) {
    const float length = glm::length(direction);
    return length > 1.0f ? direction / length : direction;
}

vec3 onTangentPlane(vec3 vector, vec3 normal) {
    const float length = glm::length(vector);
    if (!(length > 0.0f) || !std::isfinite(length)) return vec3(0.0f);
    vector /= length;
    vector -= normal * glm::dot(vector, normal);
    const float left = glm::length(vector);
    return left > 1e-3f ? vector / left : vec3(0.0f);
}

Mode modeOf(const Brush& brush) {
    const ToolInfo& tool = toolInfo(brush.tool);
    if (!tool.add) return tool.hasSet ? Mode::set : Mode::add;
    const bool offered = brush.mode == Mode::set     ? tool.hasSet
                         : brush.mode == Mode::scale ? tool.hasScale
                                                     : true;
    return offered ? brush.mode : Mode::add;
}

vec3 inMesh(const Skin& skin, uint v, FurVertex fur, vec3 direction) {
    fur.direction = shortened(direction);
    return shortened(furToMesh(skin, v, fur).direction);
}

float workingRadius(const Skin& skin, const Brush& brush) {
    return std::max(brush.radius, kLeastRadius * skin.size());
}

FurVertex heldBack(FurVertex after, const FurVertex& before, float held) {
    if (held <= 0.0f) return after;
    return held >= 1.0f ? before : towards(after, before, held);
}

FurVertex brushedFur(const Skin& skin, const Groom& before, const Brush& brush, uint v,
                     const Touching& touching) {
    const FurVertex old = before.fur[v];
    const float held = before.mask[v];
    const float share = touching.coverage * brush.strength;
    if (share <= 0.0f || held >= 1.0f) return old;

    FurVertex fur = old;
    switch (brush.tool) {
        case Tool::length:
            fur.furLength = lengthAfter(skin, old.furLength, brush, v, share);
            break;
        case Tool::density:
            fur.density =
                std::clamp(changed(old.density, brush, share, 1.0f, brush.value), 0.0f, 1.0f);
            break;
        case Tool::cut:
            fur.furLength = cutTo(skin, old.furLength, brush, v, share);
            break;
        case Tool::comb:
            fur.direction = combed(skin, old, brush, v, touching, share);
            break;
        case Tool::part:
            fur.direction = parted(skin, old, brush, v, touching, share);
            break;
        case Tool::twist:
            fur.direction = twisted(skin, old, brush, v, touching.turn * brush.strength);
            break;
        case Tool::clump:
            fur.direction = clumped(skin, old, brush, v, touching, share);
            break;
        case Tool::puff:
        case Tool::flatten:
            fur.direction = stood(skin, old, brush, v, share);
            break;
        case Tool::smooth:
            fur = smoothed(skin, old, v, touching.around, share);
            break;
        case Tool::tint:
            fur.tint = tinted(old.tint, brush, share);
            break;
        case Tool::mask:
        case Tool::segment:
            return old;
    }
    fur = heldBack(fur, old, held);
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
