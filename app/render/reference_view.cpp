// reference_view.cpp -- a view of the renderer as the reference takes it.
#include "app/render/reference_view.h"

#include <algorithm>
#include <cmath>

#include "app/render/frame_view.h"

namespace pelage {
namespace {

// IEC 61966-2-1, as in shaders/display.frag.
unsigned char encodedSrgb(float linear) {
    const float c = std::clamp(linear, 0.0f, 1.0f);
    const float encoded = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
    return static_cast<unsigned char>(std::lround(255.0f * encoded));
}

}  // namespace

ReferenceView referenceView(const View& view) {
    const Camera& camera = view.camera;
    ReferenceView result;
    result.size = view.size;
    result.eye = camera.eye();
    result.forward = camera.forward();
    result.right = camera.right();
    result.up = camera.up();
    result.halfHeight =
        std::tan(0.5f * camera.fieldOfView) * (camera.orthographic ? camera.distance : 1.0f);
    result.orthographic = camera.orthographic;
    result.light = studioLight(camera);
    return result;
}

ReferenceOptions referenceOptions(const View& view) {
    ReferenceOptions options;
    options.seconds = view.seconds;
    options.skin = view.showSkin;
    options.over = view.showOver;
    options.under = view.showUnder;
    options.posed = view.posed;
    return options;
}

std::vector<unsigned char> displayed(const ReferencePicture& picture, vec3 background) {
    return displayed(picture.pixels(), background);
}

std::vector<unsigned char> displayed(std::span<const vec4> pixels, vec3 background) {
    std::vector<unsigned char> bytes;
    bytes.reserve(4 * pixels.size());
    for (const vec4& pixel : pixels) {
        const vec3 color = vec3(pixel) + (1.0f - pixel.a) * background;
        for (int c = 0; c < 3; ++c) bytes.push_back(encodedSrgb(color[c]));
        bytes.push_back(255);
    }
    return bytes;
}

}  // namespace pelage
