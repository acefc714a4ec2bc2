// image.h -- a picture as numbers: linear light and coverage.
#pragma once

#include <cstddef>
#include <vector>

#include "types.h"

namespace pelage {

inline std::size_t pixelCount(ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

// Linear RGB as it is seen over black (premultiplied, may exceed 1), and coverage, [0,1]: exactly 0
// where there is nothing, exactly 1 where all is covered.
struct Image {
    ivec2 size{0};             // width, height in pixels
    std::vector<vec4> pixels;  // rows from the top
};

// One number a pixel, rows from the top.
struct Plane {
    ivec2 size{0};
    std::vector<float> values;
};

// Of a plane that is not empty.
inline double meanOf(const Plane& plane) {
    double sum = 0.0;
    for (const float value : plane.values) sum += static_cast<double>(value);
    return sum / static_cast<double>(plane.values.size());
}

// The relative luminance of linear RGB with the primaries of sRGB; 1 for white.
inline float luminance(vec3 rgb) {
    return (2613072.0f * rgb.r + 8788810.0f * rgb.g + 887015.0f * rgb.b) / 12288897.0f;
}

}  // namespace pelage
