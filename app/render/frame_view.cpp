// frame_view.cpp -- the numbers of a frame: camera, light, coats, sample.
#include "app/render/frame_view.h"

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

constexpr float kWidest = 26.0f;  // pixels from the middle of a hair to its edge, and some

// Sub-pixel offset of a sample, in pixels around the center; the first one is the center itself.
// Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
vec2 sampleOffset(int sample) {
    const double n = sample;
    const auto fraction = [](double x) { return static_cast<float>(x - std::floor(x)) - 0.5f; };
    return {fraction(0.5 + n * 0.7548776662466927), fraction(0.5 + n * 0.5698402909980532)};
}

}  // namespace

Light studioLight(const Camera& camera) {
    Light light;
    const vec3 toEye(std::sin(camera.yaw), 0.0f, std::cos(camera.yaw));
    light.toKey = glm::normalize(-0.55f * camera.right() + vec3(0.0f, 0.85f, 0.0f) + 0.6f * toEye);
    light.key = 1.45f;
    light.sky = vec3(0.62f, 0.68f, 0.78f);
    light.ground = vec3(0.26f, 0.23f, 0.20f);
    return light;
}

mat4 viewProjection(const View& view, const Mirror& mirror) {
    const float radius = mirror.skin().radius + mirror.longestHair();
    const float aspect = static_cast<float>(view.size.x) / static_cast<float>(view.size.y);
    return view.camera.projection(aspect, mirror.skin().center(), radius) * view.camera.view();
}

FrameData frameData(const Document& document, const View& view, const Mirror& mirror, int sample,
                    ivec2 pixels) {
    FrameData frame;
    const Camera& camera = view.camera;
    const vec2 offset = 2.0f * sampleOffset(sample) / vec2(pixels);
    mat4 shift(1.0f);
    shift[3] = vec4(offset, 0.0f, 1.0f);
    frame.viewProjection = shift * viewProjection(view, mirror);
    frame.eye = camera.eye();
    frame.forward = camera.forward();
    frame.perspective = camera.orthographic ? 0.0f : 1.0f;
    const float halfHeight =
        std::tan(0.5f * camera.fieldOfView) * (camera.orthographic ? camera.distance : 1.0f);
    frame.pixelsPerMetre = 0.5f * static_cast<float>(pixels.y) / halfHeight;
    frame.light = studioLight(camera);
    const bool unit = view.overlay == Overlay::density || view.overlay == Overlay::mask;
    frame.overlayRange = vec2(0.0f, unit ? 1.0f : std::max(mirror.longestHair(), 1e-12f));
    frame.overlay = static_cast<uint>(view.overlay);
    frame.segments = std::clamp(view.segments, 1u, 16u);
    frame.size = pixels;
    const Fur& fur = document.fur;
    frame.overWidth = coatWidth(*document.skin, fur.hairs, fur.over);
    frame.underWidth = coatWidth(*document.skin, fur.hairs, fur.under);
    frame.hairsPerArea =
        document.skin->area > 0.0 ? static_cast<float>(fur.hairs / document.skin->area) : 0.0f;
    frame.coats = (view.showOver ? 1u : 0u) | (view.showUnder ? 2u : 0u);
    frame.seconds = view.seconds;
    frame.tolerance = std::max(view.tolerance, 0.01f);
    frame.sides = view.sides;
    frame.textured = mirror.textured() ? 1u : 0u;
    return frame;
}

Sight sightOf(const FrameData& frame) {
    return {frame.viewProjection,     frame.eye, frame.forward, frame.pixelsPerMetre,
            frame.perspective > 0.0f, frame.size};
}

Fineness finenessOf(const FrameData& frame) { return {frame.segments, frame.tolerance, false}; }

Box boxOf(const Sight& sight, const Pelt& pelt, const Mirror& mirror) {
    const Skin& skin = mirror.skin();
    const float reach = std::max(pelt.reach() * mirror.longestHair(), pelt.clumpReach);
    const Outline outline = outlineOf(sight, skin.lower, skin.upper, reach);
    if (!outline.known) return {ivec2(0), sight.size};
    const vec2 limit(sight.size);
    return {ivec2(glm::clamp(glm::floor(outline.lower - kWidest), vec2(0.0f), limit)),
            ivec2(glm::clamp(glm::ceil(outline.upper + kWidest), vec2(0.0f), limit))};
}

}  // namespace pelage
