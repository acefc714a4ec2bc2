// picture_test.cpp -- encoded pictures: what they are, and what is taken out of them.
#include <gtest/gtest.h>

#include <span>
#include <string>

#include "core/gltf_carry.h"

namespace pelage {
namespace {

TEST(PictureType, IsDecidedByTheFirstBytes) {
    const auto of = [](std::string_view text) {
        return pictureType(std::as_bytes(std::span(text)));
    };
    EXPECT_EQ(of("\x89PNG\r\n\x1A\nrest"), "image/png");
    EXPECT_EQ(of("\xFF\xD8\xFF\xE0"), "image/jpeg");
    EXPECT_EQ(of("RIFF1234WEBPVP8 "), "image/webp");
    EXPECT_EQ(of("\xABKTX 20\xBB\r\n\x1A\n"), "image/ktx2");
    EXPECT_EQ(of("GIF89a"), "");
    EXPECT_EQ(of(""), "");
}

TEST(PlainPicture, HasThePixelsAndNoWordOfTheirColors) {
    const auto chunk = [](const std::string& type, const std::string& data) {
        return std::string(3, '\0') + static_cast<char>(data.size()) + type + data + "sum!";
    };
    const std::string start = "\x89PNG\r\n\x1A\n" + chunk("IHDR", "0123456789abc");
    const std::string end = chunk("IDAT", "pixels") + chunk("IEND", "");
    const auto plain = [](const std::string& text) {
        const auto bytes = plainPicture(std::as_bytes(std::span(text)));
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    EXPECT_EQ(plain(start + chunk("iCCP", "profile") + chunk("pHYs", "") + end), start + end);
    EXPECT_EQ(plain(start + end), start + end);
    const std::string cut = start + chunk("gAMA", "1234") + "IDAT";
    EXPECT_EQ(plain(cut), cut);  // not understood to the end, so not touched
    EXPECT_EQ(plain("\xFF\xD8\xFF jpeg"), "\xFF\xD8\xFF jpeg");
}

}  // namespace
}  // namespace pelage
