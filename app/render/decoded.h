// decoded.h -- PNG and JPEG pictures as textures.
#pragma once

#include <cstddef>
#include <span>

#include "app/render/gl.h"

namespace pelage {

// Pixels as the header of the picture says; 0 where it is not one that is decoded: of a side over
// `largestSide`, or larger than its bytes can tell.
ivec2 decodedSize(std::span<const std::byte> picture, int largestSide);

// The picture in the first level of a texture; without a texture where it is damaged.
struct Decoded {
    gl::Texture texture;
    ivec2 size{0};
};
Decoded decodePicture(std::span<const std::byte> picture, GLenum format, GLsizei levels = 1);

}  // namespace pelage
