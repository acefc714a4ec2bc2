// decoded.cpp -- pixels of encoded pictures, uploaded.
#include "app/render/decoded.h"

#include "core/picture_file.h"

namespace pelage {

Decoded decodePicture(std::span<const std::byte> picture, GLenum format, GLsizei levels) {
    const Rgba8 pixels = decodedPixels(picture);
    Decoded result;
    result.size = pixels.size;
    if (pixels.bytes.empty()) return result;
    result.texture = gl::makeTexture(pixels.size, format, levels);
    glTextureSubImage2D(result.texture.name(), 0, 0, 0, pixels.size.x, pixels.size.y, GL_RGBA,
                        GL_UNSIGNED_BYTE, pixels.bytes.data());
    return result;
}

}  // namespace pelage
