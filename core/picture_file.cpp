// picture_file.cpp -- stb_image and stb_image_write, and files around them.
#include "picture_file.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "files.h"
#include "srgb.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb_image.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace pelage {
namespace {

const stbi_uc* encoded(std::span<const std::byte> picture) {
    return reinterpret_cast<const stbi_uc*>(picture.data());
}

int encodedSize(std::span<const std::byte> picture) {
    return static_cast<int>(std::min<std::size_t>(picture.size(), 1u << 30));
}

// For stb_image_write: appends to the vector that `to` is.
void append(void* to, void* data, int count) {
    const auto* bytes = static_cast<const std::byte*>(data);
    auto& all = *static_cast<std::vector<std::byte>*>(to);
    all.insert(all.end(), bytes, bytes + count);
}

template <class Value>
using Loaded = std::unique_ptr<Value, decltype(&stbi_image_free)>;

// The linear value of each of 16 bits; those of 8 bits, times 257, are among them.
std::vector<float> linearOf16Bits() {
    std::vector<float> linear(65536);
    for (std::size_t i = 0; i < linear.size(); ++i)
        linear[i] = linearFromSrgb(static_cast<float>(i) / 65535.0f);
    return linear;
}

unsigned char byteOf(float share) {
    return static_cast<unsigned char>(
        std::lround(255.0f * std::fmin(std::fmax(share, 0.0f), 1.0f)));
}

}  // namespace

ivec2 decodedSize(std::span<const std::byte> picture, int largestSide) {
    ivec2 size(0);
    int channels = 0;
    if (picture.empty() ||
        !stbi_info_from_memory(encoded(picture), encodedSize(picture), &size.x, &size.y, &channels))
        return ivec2(0);
    // A byte of PNG holds at most 8 * 1032 pixels, one of JPEG far fewer.
    const bool plausible = pixelCount(size) <= (std::size_t{1} << 20) + 8256 * picture.size();
    return plausible && std::max(size.x, size.y) <= largestSide ? size : ivec2(0);
}

Rgba8 decodedPixels(std::span<const std::byte> picture) {
    Rgba8 result;
    int channels = 0;
    const Loaded<stbi_uc> pixels(
        stbi_load_from_memory(encoded(picture), encodedSize(picture), &result.size.x,
                              &result.size.y, &channels, 4),
        stbi_image_free);
    if (!pixels) return {};
    result.bytes.assign(pixels.get(), pixels.get() + 4 * pixelCount(result.size));
    return result;
}

std::vector<std::byte> encodePng(ivec2 size, int channels, std::span<const unsigned char> bytes) {
    std::vector<std::byte> png;
    if (!stbi_write_png_to_func(append, &png, size.x, size.y, channels, bytes.data(),
                                channels * size.x))
        throw std::runtime_error("the picture could not be encoded");
    return png;
}

std::vector<std::byte> encodeJpeg(ivec2 size, std::span<const unsigned char> rgba) {
    constexpr int kQuality = 90;
    std::vector<std::byte> jpeg;
    if (!stbi_write_jpg_to_func(append, &jpeg, size.x, size.y, 4, rgba.data(), kQuality))
        throw std::runtime_error("the picture could not be encoded");
    return jpeg;
}

void writePng(const std::string& path, ivec2 size, std::span<const unsigned char> rgba) {
    writeFileAtomically(path, encodePng(size, 4, rgba));
}

Image readImage(const std::string& path) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 30;
    constexpr int kLargestSide = 8192;
    const std::vector<std::byte> file = readFile(path, kMostBytes);
    Image image{decodedSize(file, kLargestSide), {}};
    int channels = 0;
    const Loaded<stbi_us> pixels(
        image.size.x > 0 ? stbi_load_16_from_memory(encoded(file), encodedSize(file), &image.size.x,
                                                    &image.size.y, &channels, 4)
                         : nullptr,
        stbi_image_free);
    if (!pixels) throw std::runtime_error(path + ": is no PNG or JPEG picture that can be read");
    const std::vector<float> linear = linearOf16Bits();
    image.pixels.reserve(pixelCount(image.size));
    for (std::size_t i = 0; i < pixelCount(image.size); ++i) {
        const stbi_us* p = pixels.get() + 4 * i;
        const float alpha = static_cast<float>(p[3]) / 65535.0f;
        image.pixels.emplace_back(alpha * vec3(linear[p[0]], linear[p[1]], linear[p[2]]), alpha);
    }
    return image;
}

void writeImage(const std::string& path, const Image& image) {
    std::vector<unsigned char> bytes;
    bytes.reserve(4 * image.pixels.size());
    for (const vec4& pixel : image.pixels) {
        for (int i = 0; i < 3; ++i)
            bytes.push_back(pixel.a > 0.0f ? byteOf(srgbFromLinear(pixel[i] / pixel.a)) : 0);
        bytes.push_back(byteOf(pixel.a));
    }
    writePng(path, image.size, bytes);
}

}  // namespace pelage
