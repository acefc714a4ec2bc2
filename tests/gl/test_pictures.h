// test_pictures.h -- PNG files made by tests, as bytes.
#pragma once

#include <vector>

#include "core/pixels.h"
#include "tests/gl/gl_context.h"

namespace pelage::test {

// RGBA8 rows from the top as the bytes of a PNG file.
inline std::vector<std::byte> pngOf(ivec2 size, const std::vector<unsigned char>& rgba) {
    return encodePng(size, 4, rgba);
}

// The left half in one sRGB color and the right half in another.
inline std::vector<std::byte> twoColorPng(ivec2 size, glm::ivec3 left, glm::ivec3 right) {
    std::vector<unsigned char> rgba;
    for (int i = 0; i < size.x * size.y; ++i) {
        const glm::ivec3 color = i % size.x < size.x / 2 ? left : right;
        for (int c = 0; c < 3; ++c) rgba.push_back(static_cast<unsigned char>(color[c]));
        rgba.push_back(255);
    }
    return pngOf(size, rgba);
}

// Quarters: red and blue above, green and black below.
inline std::vector<std::byte> quartersPng(int side) {
    std::vector<unsigned char> rgba;
    const auto full = [](bool on) { return static_cast<unsigned char>(on ? 255 : 0); };
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const bool left = x < side / 2, above = y < side / 2;
            rgba.insert(rgba.end(),
                        {full(left && above), full(left && !above), full(!left && above), 255});
        }
    }
    return pngOf(ivec2(side), rgba);
}

}  // namespace pelage::test
