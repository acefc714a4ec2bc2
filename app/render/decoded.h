// decoded.h -- PNG and JPEG pictures as textures.
#pragma once

#include <cstddef>
#include <span>

#include "app/render/gl.h"
#include "core/pixels.h"

namespace pelage {

// The picture in the first level of a texture; without a texture where it is damaged.
struct Decoded {
    gl::Texture texture;
    ivec2 size{0};
};
Decoded decodePicture(std::span<const std::byte> picture, GLenum format, GLsizei levels = 1);

}  // namespace pelage
