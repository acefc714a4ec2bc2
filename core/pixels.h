// pixels.h -- PNG and JPEG pictures as pixels, and back.
//
// Bytes of pixels are display-encoded (sRGB), their rows come from the top, alpha is straight.
// Color profiles and gamma in files are not followed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image.h"

namespace pelage {

// "640x480"
std::string sizeText(ivec2 size);

// Pixels as the header of the picture says; 0 where it is not one that is decoded: of a side over
// `largestSide`, or larger than its bytes can tell.
ivec2 decodedSize(std::span<const std::byte> picture, int largestSide);

// RGBA8, as the picture encodes it; of size 0 where it is damaged.
struct Pixels {
    ivec2 size{0};
    std::vector<unsigned char> rgba;
};
Pixels decodePixels(std::span<const std::byte> picture);

// The pixels as linear light over black.
Image linearImage(const Pixels& pixels);
// And back, rounded; light over 1 becomes 1, NaN 0. Where nothing is covered there is no color.
Pixels displayPixels(const Image& image);

std::vector<std::byte> encodePng(ivec2 size, int channels, std::span<const unsigned char> bytes);
// RGBA8, without its alpha.
std::vector<std::byte> encodeJpeg(ivec2 size, std::span<const unsigned char> rgba);

// RGBA8 to a PNG file, atomically. Throws std::runtime_error naming the file.
void writePng(const std::string& path, ivec2 size, std::span<const unsigned char> rgba);

// A PNG of 8 or 16 bits or a JPEG as linear light, sides up to 8192. Throws std::runtime_error
// "a.png: is no PNG or JPEG picture: its 300 bytes begin with 68 65 6c 6c",
// "a.jpg: ends after 5120 bytes, in the middle of the picture",
// "a.png: has 9000x20 pixels, of which a side may have 8192", or
// "a.png: is damaged: its 300 bytes are no picture of 64x64 pixels".
Image readImage(const std::string& path);

// The displayPixels of the image as a PNG.
void writeImage(const std::string& path, const Image& image);

}  // namespace pelage
