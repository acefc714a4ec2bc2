// pixels.cpp -- the only place that decodes and encodes pictures.
#include "pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>

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

// Linear light over black from display-encoded values with straight alpha.
template <class Value>
Image linearOf(ivec2 size, std::span<const Value> rgba) {
    constexpr std::size_t kMost = std::numeric_limits<Value>::max();
    std::vector<float> linear(kMost + 1);
    for (std::size_t i = 0; i <= kMost; ++i)
        linear[i] = linearFromSrgb(static_cast<float>(i) / static_cast<float>(kMost));
    Image image{size, {}};
    image.pixels.reserve(pixelCount(size));
    for (; !rgba.empty(); rgba = rgba.subspan(4)) {
        const float alpha = static_cast<float>(rgba[3]) / static_cast<float>(kMost);
        image.pixels.emplace_back(alpha * vec3(linear[rgba[0]], linear[rgba[1]], linear[rgba[2]]),
                                  alpha);
    }
    return image;
}

// The picture with all bits that it has; without pixels where it is damaged.
Image decodedImage(std::span<const std::byte> picture) {
    if (!stbi_is_16_bit_from_memory(encoded(picture), encodedSize(picture)))
        return linearImage(decodePixels(picture));
    ivec2 size(0);
    int channels = 0;
    const Loaded<stbi_us> pixels(stbi_load_16_from_memory(encoded(picture), encodedSize(picture),
                                                          &size.x, &size.y, &channels, 4),
                                 stbi_image_free);
    if (!pixels) return {};
    return linearOf(size, std::span<const stbi_us>(pixels.get(), 4 * pixelCount(size)));
}

constexpr int kLargestSide = 8192;

// 0 beyond the file's end.
std::size_t byteAt(std::span<const std::byte> file, std::size_t i) {
    return i < file.size() ? std::to_integer<std::size_t>(file[i]) : 0;
}

bool beginsWith(std::span<const std::byte> file, std::string_view head) {
    return file.size() >= head.size() &&
           std::ranges::equal(std::as_bytes(std::span(head)), file.first(head.size()));
}
bool isPng(std::span<const std::byte> file) { return beginsWith(file, "\x89PNG\r\n\x1a\n"); }
bool isJpeg(std::span<const std::byte> file) { return beginsWith(file, "\xff\xd8\xff"); }

// Whether a PNG lacks the chunk that ends it. Each has a length, a name of four letters, so many
// bytes and a checksum. ISO/IEC 15948, 5.3.
bool isCutPng(std::span<const std::byte> file) {
    for (std::size_t i = 8; i + 12 <= file.size();) {
        const auto number = [&](std::size_t at) {
            return byteAt(file, at) << 24 | byteAt(file, at + 1) << 16 | byteAt(file, at + 2) << 8 |
                   byteAt(file, at + 3);
        };
        if (number(i + 4) == 0x49454e44) return false;  // IEND
        i += 12 + number(i);
    }
    return true;
}

// Whether the scans of a JPEG have no end, which the decoder takes for gray. Markers before the
// first scan have a length; in it, FF D9 can be nothing but the end. ITU-T T.81, annex B.
bool isCutJpeg(std::span<const std::byte> file) {
    const auto at = [&](std::size_t i) { return byteAt(file, i); };
    std::size_t i = 2;
    while (i + 4 <= file.size() && at(i) == 0xff && at(i + 1) != 0xda)
        i += at(i + 1) == 0xff ? 1 : 2 + (at(i + 2) << 8 | at(i + 3));  // FF may fill
    for (; i + 2 <= file.size(); ++i)
        if (at(i) == 0xff && at(i + 1) == 0xd9) return false;
    return true;
}

// Pixels as the header says, whatever they are; 0 where there is none.
ivec2 headerSize(std::span<const std::byte> picture) {
    ivec2 size(0);
    int channels = 0;
    if (picture.empty() ||
        !stbi_info_from_memory(encoded(picture), encodedSize(picture), &size.x, &size.y, &channels))
        return ivec2(0);
    return size;
}

// Why no picture could be read from a file.
std::string faultOf(std::span<const std::byte> file) {
    const std::string bytes = std::to_string(file.size()) + " bytes";
    if (!isPng(file) && !isJpeg(file)) {
        std::string head;
        for (const std::byte byte : file.first(std::min<std::size_t>(file.size(), 4))) {
            char hex[4];
            std::snprintf(hex, sizeof hex, " %02x", std::to_integer<unsigned>(byte));
            head += hex;
        }
        return "is no PNG or JPEG picture: " +
               (head.empty() ? "it is empty" : "its " + bytes + " begin with" + head);
    }
    if (isPng(file) ? isCutPng(file) : isCutJpeg(file))
        return "ends after " + bytes + ", in the middle of the picture";
    const ivec2 size = headerSize(file);
    if (size == ivec2(0)) return "is damaged: its " + bytes + " have no header of a picture";
    if (std::max(size.x, size.y) > kLargestSide)
        return "has " + sizeText(size) + " pixels, of which a side may have " +
               std::to_string(kLargestSide);
    return "is damaged: its " + bytes + " are no picture of " + sizeText(size) + " pixels";
}

unsigned char byteOf(float share) {
    return static_cast<unsigned char>(
        std::lround(255.0f * std::fmin(std::fmax(share, 0.0f), 1.0f)));
}

}  // namespace

std::string sizeText(ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

ivec2 decodedSize(std::span<const std::byte> picture, int largestSide) {
    const ivec2 size = headerSize(picture);
    // A byte of PNG holds at most 8 * 1032 pixels, one of JPEG far fewer.
    const bool plausible = pixelCount(size) <= (std::size_t{1} << 20) + 8256 * picture.size();
    return plausible && std::max(size.x, size.y) <= largestSide ? size : ivec2(0);
}

Pixels decodePixels(std::span<const std::byte> picture) {
    Pixels result;
    int channels = 0;
    const Loaded<stbi_uc> pixels(
        stbi_load_from_memory(encoded(picture), encodedSize(picture), &result.size.x,
                              &result.size.y, &channels, 4),
        stbi_image_free);
    if (!pixels) return {};
    result.rgba.assign(pixels.get(), pixels.get() + 4 * pixelCount(result.size));
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

Image linearImage(const Pixels& pixels) {
    return linearOf(pixels.size, std::span<const unsigned char>(pixels.rgba));
}

Image readImage(const std::string& path) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 30;
    const std::vector<std::byte> file = readFile(path, kMostBytes);
    Image image;
    if (decodedSize(file, kLargestSide).x > 0 && !(isJpeg(file) && isCutJpeg(file)))
        image = decodedImage(file);
    if (image.pixels.empty()) throw std::runtime_error(path + ": " + faultOf(file));
    return image;
}

Pixels displayPixels(const Image& image) {
    Pixels pixels{image.size, {}};
    pixels.rgba.reserve(4 * image.pixels.size());
    for (const vec4& pixel : image.pixels) {
        for (int i = 0; i < 3; ++i)
            pixels.rgba.push_back(pixel.a > 0.0f ? byteOf(srgbFromLinear(pixel[i] / pixel.a)) : 0);
        pixels.rgba.push_back(byteOf(pixel.a));
    }
    return pixels;
}

void writeImage(const std::string& path, const Image& image) {
    writePng(path, image.size, displayPixels(image).rgba);
}

}  // namespace pelage
