// thumbnail_gltest.cpp -- the promises of thumbnail.h.
#include "app/render/thumbnail.h"

#include "app/render/decoded.h"
#include "core/pixels.h"
#include "core/preset_file.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

// One for all tests: most of their time goes into shaders.
class Thumbnail : public ::testing::Test {
protected:
    static void SetUpTestSuite() { shared = std::make_unique<Thumbnailer>(); }
    static void TearDownTestSuite() { shared.reset(); }
    Thumbnailer& thumbnailer = *shared;

private:
    static inline std::unique_ptr<Thumbnailer> shared;
};

std::vector<std::byte> drawn(Thumbnailer& thumbnailer, const Fur& fur, int* calls = nullptr) {
    for (int i = 1; i < 100; ++i) {
        auto picture = thumbnailer.draw(fur);
        if (calls) *calls = i;
        if (picture) return *picture;
    }
    return {};
}

TEST_F(Thumbnail, IsDrawnBitByBitAndTheSameEachTime) {
    const Fur fox = presetNamed("fox").fur, mink = presetNamed("mink").fur;
    int calls = 0;
    const auto first = drawn(thumbnailer, fox, &calls);
    EXPECT_GT(calls, 8);
    EXPECT_EQ(decodedSize(first, 1024), ivec2(kThumbnailSide));
    thumbnailer.draw(mink);  // another coat begins anew
    EXPECT_EQ(drawn(thumbnailer, fox), first);
    EXPECT_NE(drawn(thumbnailer, mink), first);
}

TEST_F(Thumbnail, EveryPresetMakesASmallFile) {
    for (Preset preset : presets()) {
        preset.thumbnail = drawn(thumbnailer, preset.fur);
        EXPECT_LT(presetText(preset).size(), 60'000u) << preset.name;
    }
}

TEST(Decoded, DamagedAndLargePicturesAreNone) {
    auto bytes = encodeJpeg(ivec2(64), std::vector<unsigned char>(4 * 64 * 64, 100));
    EXPECT_EQ(decodedSize(bytes, 64), ivec2(64));
    EXPECT_EQ(decodedSize(bytes, 63), ivec2(0));
    EXPECT_EQ(decodedSize({}, 1024), ivec2(0));
    bytes.resize(bytes.size() / 2);
    EXPECT_FALSE(decodePicture(bytes, GL_RGBA8).texture);
}

}  // namespace
}  // namespace pelage
