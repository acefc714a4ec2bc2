// decoded.cpp -- the only place that decodes pictures for the GPU.
#include "app/render/decoded.h"

#include <algorithm>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace pelage {
namespace {

const stbi_uc* encoded(std::span<const std::byte> picture) {
    return reinterpret_cast<const stbi_uc*>(picture.data());
}

int encodedSize(std::span<const std::byte> picture) {
    return static_cast<int>(std::min<std::size_t>(picture.size(), 1u << 30));
}

}  // namespace

ivec2 decodedSize(std::span<const std::byte> picture, int largestSide) {
    ivec2 size(0);
    int channels = 0;
    if (picture.empty() ||
        !stbi_info_from_memory(encoded(picture), encodedSize(picture), &size.x, &size.y, &channels))
        return ivec2(0);
    // A byte of PNG holds at most 8 * 1032 pixels, one of JPEG far fewer.
    const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const bool plausible = pixels <= (std::size_t{1} << 20) + 8256 * picture.size();
    return plausible && std::max(size.x, size.y) <= largestSide ? size : ivec2(0);
}

Decoded decodePicture(std::span<const std::byte> picture, GLenum format, GLsizei levels) {
    Decoded result;
    int channels = 0;
    ivec2 size(0);
    stbi_uc* pixels = stbi_load_from_memory(encoded(picture), encodedSize(picture), &size.x,
                                            &size.y, &channels, 4);
    if (!pixels) return result;
    result.size = size;
    result.texture = gl::makeTexture(size, format, levels);
    glTextureSubImage2D(result.texture.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels);
    stbi_image_free(pixels);
    return result;
}

}  // namespace pelage
