// pixels_test.cpp -- the promises of pixels.h, heat_map.h and srgb.h.
#include "core/pixels.h"

#include <limits>

#include "core/files.h"
#include "core/heat_map.h"
#include "core/srgb.h"
#include "core/strand.h"
#include "gtest/gtest.h"
#include "reading.h"

namespace pelage {
namespace {

using test::bytesOf;
using test::refusal;
using test::TempFolder;
using namespace std::string_view_literals;

// 2x1 pixels of 16 bits: (1, 257, 32768, 65535) and (65535, 40000, 3, 16384).
constexpr std::string_view k16Bits =
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x02\x00\x00\x00"
    "\x01\x10\x06\x00\x00\x00\xa4\xb2\xa3\xc9\x00\x00\x00\x1c\x49\x44\x41\x54\x78\x01\x01\x11\x00"
    "\xee\xff\x00\x00\x01\x01\x01\x80\x00\xff\xff\xff\xff\x9c\x40\x00\x03\x40\x00\x2d\x8a\x05\x9f"
    "\x3c\x13\x9d\x81\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82"sv;

// Two rows: every value of 8 bits in red, and the same as coverage.
std::vector<unsigned char> ramps() {
    std::vector<unsigned char> bytes;
    for (int alpha : {255, -1}) {
        for (int i = 0; i < 256; ++i) {
            const int pixel[] = {i, 255 - i, 7, alpha < 0 ? i : alpha};
            for (const int value : pixel) bytes.push_back(static_cast<unsigned char>(value));
        }
    }
    return bytes;
}

TEST(Srgb, EncodingUndoesDecoding) {
    for (int i = 0; i <= 1000; ++i) {
        const float encoded = static_cast<float>(i) / 1000.0f;
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(encoded)), encoded, 1e-5f);
    }
    EXPECT_NEAR(srgbFromLinear(0.21404f), 0.5f, 1e-5f);
}

TEST(Pixels, PixelsOf8BitsAreLinearOverBlack) {
    const TempFolder folder;
    const std::vector<unsigned char> bytes = ramps();
    writePng(folder.path("a.png"), {256, 2}, bytes);
    EXPECT_EQ(folder.fileCount(), 1u);
    const Image image = readImage(folder.path("a.png"));
    ASSERT_EQ(image.size, ivec2(256, 2));
    for (std::size_t i = 0; i < 512; ++i) {
        const float alpha = static_cast<float>(bytes[4 * i + 3]) / 255.0f;
        EXPECT_EQ(image.pixels[i].a, alpha);
        for (int c = 0; c < 3; ++c) {
            const auto byte = bytes[4 * i + static_cast<std::size_t>(c)];
            EXPECT_EQ(image.pixels[i][c],
                      alpha * linearFromSrgb(static_cast<float>(byte) / 255.0f));
        }
    }
}

TEST(Pixels, WhatIsWrittenIsReadBack) {
    const TempFolder folder;
    writePng(folder.path("a.png"), {256, 2}, ramps());
    writeImage(folder.path("b.png"), readImage(folder.path("a.png")));
    const Pixels pixels = decodePixels(readFile(folder.path("b.png"), 100000));
    std::vector<unsigned char> expected = ramps();
    for (std::size_t c = 0; c < 3; ++c) expected[4 * 256 + c] = 0;  // nothing has no color
    EXPECT_EQ(pixels.size, ivec2(256, 2));
    EXPECT_EQ(pixels.rgba, expected);
}

TEST(Pixels, LightOverOneIsWrittenAsOneAndNanAsZero) {
    const TempFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    writeImage(folder.path("a.png"), {{2, 1}, {vec4(3, -1, nan, 1), vec4(nan, 0, 0, nan)}});
    const std::vector<unsigned char> expected = {255, 0, 0, 255, 0, 0, 0, 0};
    EXPECT_EQ(decodePixels(readFile(folder.path("a.png"), 100000)).rgba, expected);
}

TEST(Pixels, PixelsOf16BitsKeepAllBits) {
    const TempFolder folder;
    const Image image = readImage(folder.write("a.png", k16Bits));
    ASSERT_EQ(image.size, ivec2(2, 1));
    const auto linear = [](float value) { return linearFromSrgb(value / 65535.0f); };
    EXPECT_EQ(image.pixels[0], vec4(linear(1), linear(257), linear(32768), 1));
    const float alpha = 16384.0f / 65535.0f;
    EXPECT_EQ(image.pixels[1], vec4(alpha * vec3(1, linear(40000), linear(3)), alpha));
}

TEST(Pixels, JpegsAreReadWithoutAlpha) {
    const TempFolder folder;
    const std::vector<unsigned char> gray(std::size_t{16} * 8 * 4, 128);
    const Image image = readImage(folder.write("a.jpg", encodeJpeg({16, 8}, gray)));
    ASSERT_EQ(image.size, ivec2(16, 8));
    EXPECT_EQ(image.pixels[0].a, 1.0f);
    EXPECT_NEAR(image.pixels[0].r, 0.2158f, 0.005f);
}

TEST(Pixels, WhatIsNoPictureIsRefusedInOneLine) {
    const TempFolder folder;
    const auto expectRefused = [&](std::string_view text, const std::string& why) {
        const std::string path = folder.write("a.png", text);
        EXPECT_EQ(refusal([&] { readImage(path); }), path + ": " + why);
    };
    expectRefused("", "is no PNG or JPEG picture: it is empty");
    expectRefused("hello", "is no PNG or JPEG picture: its 5 bytes begin with 68 65 6c 6c");
    expectRefused(k16Bits.substr(0, 20), "ends after 20 bytes, in the middle of the picture");
    expectRefused(k16Bits.substr(0, 50), "ends after 50 bytes, in the middle of the picture");
    std::string wrong(k16Bits);
    wrong[41] = '\x07';  // of the compressed pixels
    expectRefused(wrong, "is damaged: its 85 bytes are no picture of 2x1 pixels");
    std::string huge(k16Bits);
    huge[18] = huge[22] = '\x40';  // sides of 16386 and 16385
    expectRefused(huge, "is damaged: its 85 bytes have no header of a picture");
    std::string wide(k16Bits);
    wide[18] = '\x40';
    expectRefused(wide, "has 16386x1 pixels, of which a side may have 8192");
    EXPECT_EQ(
        refusal([&] { readImage(folder.path("none.png")); }).rfind(folder.path("none.png"), 0), 0u);
    EXPECT_EQ(decodedSize(bytesOf(huge), 1 << 20), ivec2(0)) << "larger than its bytes can tell";
    EXPECT_EQ(decodedSize(bytesOf(k16Bits), 1), ivec2(0)) << "over the largest side";
    EXPECT_TRUE(decodePixels(bytesOf("hello")).rgba.empty());
}

TEST(Pixels, WhatIsDisplayedIsReadBack) {
    Pixels pixels{{256, 2}, ramps()};
    const Pixels back = displayPixels(linearImage(pixels));
    for (std::size_t c = 0; c < 3; ++c) pixels.rgba[4 * 256 + c] = 0;  // nothing has no color
    EXPECT_EQ(back.size, pixels.size);
    EXPECT_EQ(back.rgba, pixels.rgba);
}

TEST(Pixels, APictureThatEndsEarlyIsRefusedWithItsBytes) {
    const TempFolder folder;
    std::vector<unsigned char> noise;
    for (uint i = 0; i < 64 * 64 * 4; ++i) noise.push_back(static_cast<unsigned char>(pcg(i)));
    const std::vector<std::byte> jpeg = encodeJpeg({64, 64}, noise);
    const auto part = [&](std::size_t bytes) {
        return folder.write("a.jpg", std::span(jpeg).first(bytes));
    };
    EXPECT_EQ(readImage(part(jpeg.size())).size, ivec2(64, 64));
    for (const std::size_t bytes : {jpeg.size() - 1, jpeg.size() / 2, std::size_t{300}})
        EXPECT_EQ(refusal([&] { readImage(part(bytes)); }),
                  folder.path("a.jpg") + ": ends after " + std::to_string(bytes) +
                      " bytes, in the middle of the picture");
    // What a camera adds behind the picture, or before it, is no harm, nor is the end of a
    // thumbnail the end of the picture.
    std::vector<std::byte> more = jpeg;
    more.insert(more.end(), 100, std::byte{0});
    EXPECT_EQ(readImage(folder.write("a.jpg", more)).size, ivec2(64, 64));
    const std::vector<std::byte> thumbnail = bytesOf("\xff\xe1\x00\x06\xff\xd8\xff\xd9"sv);
    more = jpeg;
    more.insert(more.begin() + 2, thumbnail.begin(), thumbnail.end());
    EXPECT_EQ(readImage(folder.write("a.jpg", more)).size, ivec2(64, 64));
    more.resize(more.size() - 2);
    EXPECT_NE(refusal([&] { readImage(folder.write("a.jpg", more)); }), "(not refused)");
}

TEST(HeatMap, GoesFromBlackToLightYellow) {
    const auto bytes = [](float value) {
        const vec3 c = heatColor(value);
        const vec3 encoded(srgbFromLinear(c.r), srgbFromLinear(c.g), srgbFromLinear(c.b));
        return glm::ivec3(glm::round(255.0f * encoded));
    };
    EXPECT_EQ(bytes(0.0f), glm::ivec3(0, 0, 4));
    EXPECT_EQ(bytes(1.0f), glm::ivec3(252, 253, 191));
    EXPECT_EQ(bytes(0.25f), glm::ivec3(80, 18, 124));
}

TEST(HeatMap, GetsLighterAllTheWay) {
    for (int i = 0; i < 1000; ++i) {
        const auto value = static_cast<float>(i);
        EXPECT_LT(luminance(heatColor(value / 1000.0f)),
                  luminance(heatColor((value + 1) / 1000.0f)))
            << i;
    }
}

TEST(HeatMap, ValuesOutsideCountAsTheNearerEnd) {
    EXPECT_EQ(heatColor(-3.0f), heatColor(0.0f));
    EXPECT_EQ(heatColor(1.5f), heatColor(1.0f));
    EXPECT_EQ(heatColor(std::numeric_limits<float>::quiet_NaN()), heatColor(0.0f));
}

TEST(HeatMap, OfAPlaneIsFullyCovered) {
    const Image image = heatMap({{2, 1}, {0.0f, 0.7f}});
    EXPECT_EQ(image.size, ivec2(2, 1));
    EXPECT_EQ(image.pixels[0], vec4(heatColor(0.0f), 1.0f));
    EXPECT_EQ(image.pixels[1], vec4(heatColor(0.7f), 1.0f));
}

}  // namespace
}  // namespace pelage
