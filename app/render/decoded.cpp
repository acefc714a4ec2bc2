// decoded.cpp -- PNG and JPEG pictures as textures.
#include "app/render/decoded.h"

namespace pelage {

Decoded decodePicture(std::span<const std::byte> picture, GLenum format, GLsizei levels) {
    Decoded result;
    const Pixels pixels = decodePixels(picture);
    if (pixels.rgba.empty()) return result;
    result.size = pixels.size;
    result.texture = gl::makeTexture(result.size, format, levels);
    glTextureSubImage2D(result.texture.name(), 0, 0, 0, result.size.x, result.size.y, GL_RGBA,
                        GL_UNSIGNED_BYTE, pixels.rgba.data());
    return result;
}

}  // namespace pelage
