// pixels.h -- PNG and JPEG pictures as pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "types.h"

namespace pelage {

// Pixels as the header of the picture says; 0 where it is not one that is decoded: of a side over
// `largestSide`, or larger than its bytes can tell.
ivec2 decodedSize(std::span<const std::byte> picture, int largestSide);

// RGBA8, as the picture encodes it, rows from the top; of size 0 where it is damaged.
struct Pixels {
    ivec2 size{0};
    std::vector<unsigned char> rgba;
};
Pixels decodePixels(std::span<const std::byte> picture);

}  // namespace pelage
