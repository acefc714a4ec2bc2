// cursor_lines.cpp -- what is drawn on the skin but is no hair: brush rings and direction arrows.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/app.h"
#include "app/region_lines.h"
#include "app/segment_arrow.h"
#include "app/viewport.h"

namespace pelage {
namespace {

constexpr int kRingSegments = 56;
constexpr std::size_t kArrows = 2400;  // at most, over the entire skin
constexpr vec4 kArrowColor{0.62f, 0.93f, 1.0f, 0.95f};
constexpr vec4 kArrowEdge{0.02f, 0.10f, 0.16f, 0.9f};  // so that it is seen on white fur

vec4 ringColor(const Brush& brush) {
    switch (brush.tool) {
        case Tool::comb:
            return {1.0f, 0.72f, 0.40f, 1.0f};
        case Tool::smooth:
            return {0.72f, 0.66f, 1.0f, 1.0f};
        case Tool::tint:  // the color itself, or that of the coat
            return vec4(brush.mode == Mode::subtract ? vec3(1.0f) : displayedColor(brush.color),
                        1.0f);
        default:
            break;
    }
    if (brush.mode == Mode::add) return {0.55f, 0.92f, 0.55f, 1.0f};
    if (brush.mode == Mode::subtract) return {1.0f, 0.50f, 0.45f, 1.0f};
    return {0.50f, 0.80f, 1.0f, 1.0f};
}

// The distance at which the falloff has this value, as a share of the radius.
float distanceAt(Falloff falloff, float value) {
    float least = 0.0f, greatest = 1.0f;
    for (int i = 0; i < 12; ++i) {
        const float middle = 0.5f * (least + greatest);
        (falloffWeight(falloff, middle, 1.0f) > value ? least : greatest) = middle;
    }
    return greatest;
}

struct Ring {
    vec3 center{0.0f}, normal{0.0f};  // world
    float radius = 0.0f;              // m
    vec4 color{1.0f};
};

// A circle about the normal, let down onto the skin where there is skin below it.
void addRing(const SkinQuery& query, const Ring& ring, std::vector<OverlayLine>& lines) {
    const vec3 any = std::abs(ring.normal.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
    const vec3 across = glm::normalize(glm::cross(any, ring.normal));
    const vec3 along = glm::cross(ring.normal, across);
    const float lift = 0.015f * query.skin().size() * 0.25f;
    vec3 before{0.0f};
    for (int i = 0; i <= kRingSegments; ++i) {
        const float angle =
            2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kRingSegments;
        const vec3 spoke = std::cos(angle) * across + std::sin(angle) * along;
        vec3 point = ring.center + ring.radius * spoke;
        const auto below = query.cast(point + ring.radius * ring.normal, -ring.normal);
        if (below && below->distance < 2.0f * ring.radius) point = below->position;
        point += lift * ring.normal;
        if (i > 0) lines.push_back({before, point, ring.color});
        before = point;
    }
}

void addCursor(App& app, std::vector<OverlayLine>& lines) {
    const Viewport& viewport = app.viewport;
    if (!viewport.hit || app.session.hand.job != Job::paint) return;
    const Brush brush = app.workspace.stroke ? app.workspace.stroke->brush()
                                             : brushInHand(app, viewport.hit->position,
                                                           viewport.shift, viewport.control);
    const SkinQuery& query = *app.workspace.query;
    const vec4 outer = ringColor(brush);
    const vec4 inner{outer.x, outer.y, outer.z, 0.4f + 0.5f * brush.strength};
    // Of a brush that knows no degrees, up to where it paints.
    const float value = brush.tool == Tool::segment ? 1.0f - brush.strength : 0.5f;
    const float half = distanceAt(brush.falloff, value) * brush.radius;
    const SkinHit& hit = *viewport.hit;
    // Two units wide, with a dark edge so that it is seen on light fur.
    const float unit = app.theme.scale * worldPerUnit(app.session.camera, viewport, hit.distance);
    const bool dark = brush.tool == Tool::tint && outer.x + outer.y + outer.z < 1.2f;
    const vec4 edge(vec3(dark ? 1.0f : 0.0f), 0.4f);
    addRing(query, {hit.position, hit.normal, brush.radius + 1.6f * unit, edge}, lines);
    addRing(query, {hit.position, hit.normal, brush.radius + 0.5f * unit, outer}, lines);
    addRing(query, {hit.position, hit.normal, brush.radius - 0.5f * unit, outer}, lines);
    if (brush.falloff != Falloff::constant)
        addRing(query, {hit.position, hit.normal, half, inner}, lines);
    lines.push_back({hit.position, hit.position + 0.35f * brush.radius * hit.normal, inner});
    const vec4 faint{outer.x, outer.y, outer.z, 0.7f};
    PathPoint own{.position = hit.position, .normal = hit.normal};
    own.foot = hit;
    const std::vector<Mirroring> mirrorings = pelage::mirrorings(query.skin(), brush.mirror);
    for (std::size_t i = 1; i < mirrorings.size(); ++i) {
        const PathPoint image = imageOf(query, own, mirrorings[i].matrix, brush.facingOnly);
        addRing(query, {image.position, image.normal, brush.radius, faint}, lines);
    }
}

// An arrow for a fair sample of the vertices: they are in spatial order, so every n-th will do.
void addArrows(const App& app, std::vector<OverlayLine>& lines) {
    const Skin& skin = app.skin();
    const std::size_t count = skin.vertices.size();
    const std::size_t stride = std::max<std::size_t>(1, (count + kArrows - 1) / kArrows);
    const float spacing = static_cast<float>(
        std::sqrt(skin.area / static_cast<double>(std::max<std::size_t>(count / stride, 1))));
    const float reach = 1.3f * spacing;
    const vec3 eye = app.session.camera.eye();
    for (std::size_t v = 0; v < count; v += stride) {
        const SkinVertex& vertex = skin.vertices[v];
        if (glm::dot(eye - vertex.position, vertex.normal) <= 0.0f) continue;
        const FurVertex fur = furToWorld(skin, static_cast<uint>(v), app.document().groom.fur[v]);
        const float strength = glm::length(fur.direction);
        if (!(strength > 1e-4f)) continue;
        const vec3 step = reach * fur.direction;
        const vec3 root = vertex.position + 0.25f * spacing * vertex.normal;
        const vec3 tip = root + step;
        const vec3 across =
            glm::normalize(glm::cross(fur.direction, eye - vertex.position) + vec3(1e-9f));
        const vec3 side = 0.22f * reach * strength * across;
        const vec3 thick =
            0.5f * app.theme.scale *
            worldPerUnit(app.session.camera, app.viewport, glm::length(eye - vertex.position)) *
            across;
        lines.push_back({root + thick, tip + thick, kArrowColor});
        lines.push_back({root - thick, tip - thick, kArrowEdge});
        lines.push_back({tip, tip - 0.35f * step + side, kArrowColor});
        lines.push_back({tip, tip - 0.35f * step - side, kArrowColor});
    }
}

}  // namespace

void updateLines(App& app) {
    auto& lines = app.viewport.lines;
    lines.clear();
    if (!app.isOpen()) return;
    if (app.session.view.overlay == Overlay::direction) addArrows(app, lines);
    const bool axes = std::exchange(app.session.segment.shown, false);
    if (axes && !app.workspace.posed) addAxes(app, lines);  // they are those of the rest pose
    if (app.session.regionShown) addRegionOutline(app, lines);
    if (!app.session.playback.playing) addCursor(app, lines);
}

}  // namespace pelage
