// thumbnail_gltest.cpp -- the promises of thumbnail.h.
#include "app/render/thumbnail.h"

#include "app/render/decoded.h"
#include "core/preset_file.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

std::vector<std::byte> drawn(Thumbnailer& thumbnailer, const Fur& fur, int* calls = nullptr) {
    for (int i = 1; i < 100; ++i) {
        auto picture = thumbnailer.draw(fur);
        if (calls) *calls = i;
        if (picture) return *picture;
    }
    return {};
}

TEST(Thumbnail, IsDrawnBitByBitAndTheSameEachTime) {
    Thumbnailer thumbnailer;
    const Fur fox = presetNamed("fox").fur, mink = presetNamed("mink").fur;
    int calls = 0;
    const auto first = drawn(thumbnailer, fox, &calls);
    EXPECT_GT(calls, 8);
    EXPECT_EQ(decodedSize(first, 1024), ivec2(kThumbnailSide));
    thumbnailer.draw(mink);  // another coat begins anew
    EXPECT_EQ(drawn(thumbnailer, fox), first);
    EXPECT_NE(drawn(thumbnailer, mink), first);
}

TEST(Thumbnail, EveryPresetMakesASmallFile) {
    Thumbnailer thumbnailer;
    for (Preset preset : presets()) {
        preset.thumbnail = drawn(thumbnailer, preset.fur);
        EXPECT_LT(presetText(preset).size(), 60'000u) << preset.name;
    }
}

TEST(Decoded, DamagedAndLargePicturesAreNone) {
    Thumbnailer thumbnailer;
    auto bytes = drawn(thumbnailer, defaultFur());
    EXPECT_EQ(decodedSize(bytes, kThumbnailSide - 1), ivec2(0));
    EXPECT_EQ(decodedSize({}, 1024), ivec2(0));
    bytes.resize(bytes.size() / 2);
    EXPECT_FALSE(decodePicture(bytes, GL_RGBA8).texture);
}

}  // namespace
}  // namespace pelage
