// pixels.cpp -- the only place that decodes pictures.
#include "pixels.h"

#include <algorithm>
#include <memory>

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

Pixels decodePixels(std::span<const std::byte> picture) {
    Pixels result;
    int channels = 0;
    ivec2 size(0);
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(encoded(picture), encodedSize(picture), &size.x, &size.y, &channels,
                              4),
        stbi_image_free);
    if (!pixels) return result;
    result.size = size;
    const auto bytes = 4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    result.rgba.assign(pixels.get(), pixels.get() + bytes);
    return result;
}

}  // namespace pelage
