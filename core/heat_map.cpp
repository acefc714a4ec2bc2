// heat_map.cpp -- nine colors and what lies between them.
#include "heat_map.h"

#include <tbb/parallel_for.h>

#include <array>

#include "srgb.h"

namespace pelage {

vec3 heatColor(float value) {
    // sRGB, 0 to 255.
    static constexpr std::array kColors = {
        vec3(0, 0, 4),      vec3(29, 17, 70),    vec3(80, 18, 124),
        vec3(130, 38, 129), vec3(182, 55, 121),  vec3(230, 81, 99),
        vec3(251, 135, 97), vec3(254, 195, 135), vec3(252, 253, 191)};
    constexpr auto kLast = static_cast<float>(kColors.size() - 1);
    const float place = value > 0.0f ? std::fmin(value, 1.0f) * kLast : 0.0f;
    const float from = std::fmin(std::floor(place), kLast - 1.0f);
    const auto i = static_cast<std::size_t>(from);
    const vec3 color = glm::mix(kColors[i], kColors[i + 1], place - from) / 255.0f;
    return {linearFromSrgb(color.r), linearFromSrgb(color.g), linearFromSrgb(color.b)};
}

Image heatMap(const Plane& plane) {
    Image image{plane.size, std::vector<vec4>(plane.values.size())};
    tbb::parallel_for(std::size_t(0), plane.values.size(), [&](std::size_t i) {
        image.pixels[i] = vec4(heatColor(plane.values[i]), 1.0f);
    });
    return image;
}

}  // namespace pelage
