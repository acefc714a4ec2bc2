// shell_source_test.cpp -- the promises of shell_source.h.
#include "core/shell_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/photo_regions.h"
#include "core/pixels.h"
#include "core/srgb.h"
#include "core/strand.h"
#include "reading.h"

namespace pelage {
namespace {

using test::refusal;
using Texel = ShellTexture::Texel;

// Tones like fur: soft spots of light that dies away with the depth. 8 bits.
Image furPhoto(int side, vec3 color = vec3(1.0f)) {
    const Plane spots = noisePicture({.side = side, .mask = 5});
    Pixels pixels{ivec2(side), {}};
    for (const float spot : spots.values) {
        const vec3 light = color * 0.02f * std::exp(std::log(40.0f) * spot);
        for (int c = 0; c < 3; ++c)
            pixels.rgba.push_back(
                static_cast<unsigned char>(std::lround(255.0f * srgbFromLinear(light[c]))));
        pixels.rgba.push_back(255);
    }
    return linearImage(pixels);
}

float toneOf(const Texel& texel) {
    const auto linear = [](unsigned char byte) {
        return linearFromSrgb(static_cast<float>(byte) / 255.0f);
    };
    return luminance({linear(texel[0]), linear(texel[1]), linear(texel[2])});
}

// Of the texels of that alpha, those as bright.
double covered(const std::vector<Texel>& level, unsigned char alpha, float threshold) {
    const auto of = std::ranges::count(level, alpha, [](const Texel& t) { return t[3]; });
    const auto bright = std::ranges::count_if(
        level, [&](const Texel& texel) { return texel[3] == alpha && toneOf(texel) >= threshold; });
    return static_cast<double>(bright) / static_cast<double>(of);
}

TEST(ShellSource, APhotographIsDrawnInItsOwnColors) {
    Image photo = furPhoto(32, {0.9f, 0.5f, 0.2f});
    photo.pixels[7] = vec4(0.0f);
    const ShellTexture texture = photoTexture(drawnPhoto(photo), {});
    EXPECT_TRUE(texture.photo);
    EXPECT_EQ(texture.size, ivec2(32));
    const Pixels pixels = displayPixels(photo);
    for (std::size_t i = 0; i < photo.pixels.size(); ++i) {
        const Texel texel = texture.levels[0][i];
        EXPECT_EQ(texel[3], i == 7 ? 0 : 255);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(texel[c], pixels.rgba[4 * i + c]) << i;
    }
}

TEST(ShellSource, APhotographOf256TexelsTakes341KiBWithAllLevels) {
    const ShellTexture texture = photoTexture(drawnPhoto(furPhoto(256)), {});
    EXPECT_EQ(texture.levels[0].size() * sizeof(Texel), 256u * 1024);
    EXPECT_EQ(texture.levels.size(), 9u);
    EXPECT_EQ(texture.bytes(), 4 * (4 * 256 * 256 - 1) / 3u);
    EXPECT_EQ(texture.bytes() / 1024, 341u);
}

TEST(ShellSource, EveryLayerOfEveryLevelCoversWhatItCoversInThePhotograph) {
    for (const ivec2 size : {ivec2(128), ivec2(100, 37)}) {
        Image photo{size, {}};
        const Image fur = furPhoto(128, {0.9f, 0.5f, 0.2f});
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                photo.pixels.push_back(fur.pixels[static_cast<std::size_t>(128 * y + x)]);
        const PhotoLayers layers = photoLayers(photo, {.layers = 8});
        const ShellTexture texture = photoTexture(photo, {});
        for (const auto& level : texture.levels) {
            if (level.size() < 64) break;
            for (const float threshold : layers.regions[0].thresholds) {
                const double share = covered(level, 255, threshold);
                // A texel, and a tone of 8 bits.
                EXPECT_NEAR(share, covered(texture.levels[0], 255, threshold),
                            1.0 / static_cast<double>(level.size()) + 0.012);
            }
        }
    }
}

TEST(ShellSource, EachRegionKeepsItsOwnTones) {
    Image photo = furPhoto(64, {1.0f, 1.0f, 1.0f});
    const Image brown = furPhoto(64, {0.3f, 0.08f, 0.02f});
    for (std::size_t i = 0; i < photo.pixels.size(); ++i)
        if (i % 64 < 20) photo.pixels[i] = brown.pixels[i];
    const std::vector<unsigned char> regions = colorRegions(photo);
    const PhotoLayers layers = photoLayers(photo, {.layers = 4, .twoColors = true});
    ASSERT_EQ(layers.regions.size(), 2u);
    const ShellTexture texture = photoTexture(photo, regions);
    for (std::size_t i = 0; i < regions.size(); ++i)
        EXPECT_EQ(texture.levels[0][i][3], regions[i] == 1 ? 128 : 255);
    for (const int level : {1, 2})
        for (const std::size_t region : {0u, 1u})
            for (const float threshold : layers.regions[region].thresholds) {
                const auto alpha = static_cast<unsigned char>(region == 1 ? 128 : 255);
                EXPECT_NEAR(
                    covered(texture.levels[static_cast<std::size_t>(level)], alpha, threshold),
                    covered(texture.levels[0], alpha, threshold), 0.04);
            }
}

TEST(ShellSource, LargePhotographsAreHalvedUntilTheyFit) {
    Image photo{ivec2(8192, 60), std::vector<vec4>(8192 * 60, vec4(0.25f, 0.25f, 0.25f, 1.0f))};
    photo.pixels[0] = vec4(0.0f);
    const Image drawn = drawnPhoto(std::move(photo));
    EXPECT_EQ(drawn.size, ivec2(4096, 30));
    for (const vec4 pixel : drawn.pixels) {
        EXPECT_EQ(pixel.a, 1.0f);  // what is left of some color is not transparent
        EXPECT_NEAR(pixel.g, 0.25f, 0.002f);
    }
}

// A wide one, so that it is small.
TEST(ShellSource, WhatAPanelShowsOfALargePhotographHoldsTheSameTones) {
    const Image fur = furPhoto(128, {0.9f, 0.5f, 0.2f});
    Image photo{ivec2(8192, 128), {}};
    photo.pixels.reserve(8192 * 128);
    for (std::size_t y = 0; y < 128; ++y)
        for (std::size_t x = 0; x < 8192; ++x)
            photo.pixels.push_back(fur.pixels[128 * y + (x + x / 128) % 128]);
    const test::TempFolder folder;
    ShellRecipe recipe{.from = ShellRecipe::From::photo, .file = folder.path("wide.png")};
    writeImage(recipe.file, photo);
    const ShellPicture picture = shellPicture(recipe);
    EXPECT_EQ(picture.texture->size, ivec2(4096, 64));
    EXPECT_EQ(halvedText(*picture.texture), "8192x128 pixels are drawn as 4096x64");
    EXPECT_EQ(picture.photo.size, ivec2(1024, 16));
    const PhotoLayers shown = photoLayers(picture, recipe.photo);
    const PhotoLayers all = photoLayers(drawnPhoto(photo), recipe.photo);
    EXPECT_NEAR(shown.regions[0].low, all.regions[0].low, 0.02f * all.regions[0].low);
    EXPECT_NEAR(shown.regions[0].high, all.regions[0].high, 0.02f * all.regions[0].high);
    for (std::size_t k = 0; k < 16; ++k)
        EXPECT_NEAR(static_cast<double>(shown.populations[k]) / (1024.0 * 16.0),
                    static_cast<double>(all.populations[k]) / (4096.0 * 64.0), 0.01)
            << k;
}

TEST(ShellSource, WhatFitsIsDrawnAsItIs) {
    const test::TempFolder folder;
    ShellRecipe recipe{.from = ShellRecipe::From::photo, .file = folder.path("a.png")};
    writeImage(recipe.file, furPhoto(32));
    EXPECT_EQ(halvedText(*shellPicture(recipe).texture), "");
    recipe.from = ShellRecipe::From::noise;
    EXPECT_EQ(halvedText(*shellPicture(recipe).texture), "");
}

TEST(ShellSource, ReadingThatIsCancelledEnds) {
    const test::TempFolder folder;
    ShellRecipe recipe{.from = ShellRecipe::From::photo, .file = folder.path("a.png")};
    writeImage(recipe.file, furPhoto(32));
    Progress progress;
    shellPicture(recipe, &progress);
    EXPECT_EQ(progress.done, 1.0f);
    progress.cancel = true;
    EXPECT_THROW(shellPicture(recipe, &progress), Cancelled);
}

TEST(ShellSource, HeightsAreThoseOfTheMap) {
    const ShellMap map = rankedMap(noisePicture({.side = 16}), {.coverage = 1.0f}, 1);
    const ShellTexture texture = heightTexture(map);
    EXPECT_FALSE(texture.photo);
    ASSERT_EQ(texture.levels.size(), map.levels.size());
    for (std::size_t level = 0; level < map.levels.size(); ++level)
        for (std::size_t i = 0; i < map.levels[level].texels.size(); ++i) {
            const auto texel = std::bit_cast<ShellTexel>(texture.levels[level][i]);
            EXPECT_EQ(texel.height, map.levels[level].texels[i].height);
            EXPECT_EQ(texel.id, map.levels[level].texels[i].id);
        }
}

TEST(ShellSource, LayersLieEvenlyFromTheTipsToTheSkin) {
    ShellSource source;
    source.layers = 4;
    EXPECT_EQ(source.layerAt(1), 0.75f);
    EXPECT_EQ(source.layerAt(4), 0.0f);
    source.gap = 0.5f;
    EXPECT_EQ(source.layerAt(1), 0.375f);
    EXPECT_EQ(source.layerAt(4), 0.0f);
}

TEST(ShellSource, TonesAreThoseOfTheLayersAndOfOneLuminanceAllIsInTheFirst) {
    ShellRecipe recipe{.from = ShellRecipe::From::photo};
    ShellPicture picture{.photo = furPhoto(32)};
    PhotoLayers layers = photoLayers(picture.photo, recipe.photo);
    ShellSource source = shellSource(picture, recipe, layers, 2.0f);
    EXPECT_EQ(source.tones[0], vec2(layers.regions[0].low, layers.regions[0].high));
    EXPECT_EQ(source.tones[1], vec2(0.0f));
    EXPECT_EQ(source.layers, 16u);
    EXPECT_FLOAT_EQ(source.side, 0.4f);
    picture.photo.pixels.assign(picture.photo.pixels.size(), vec4(0.5f, 0.5f, 0.5f, 1.0f));
    picture.photo.pixels[3] = vec4(0.1f, 0.1f, 0.1f, 1.0f);
    layers = photoLayers(picture.photo, recipe.photo);
    EXPECT_EQ(layers.populations[0], 1024u);
    EXPECT_EQ(shellSource(picture, recipe, layers, 2.0f).tones[0], vec2(0.0f));
}

TEST(ShellSource, WhatCannotBeReadIsRefused) {
    const std::string folder = testing::TempDir();
    ShellRecipe recipe{.from = ShellRecipe::From::photo, .file = folder + "/none.png"};
    writePng(recipe.file, ivec2(3, 2), std::vector<unsigned char>(24));
    EXPECT_EQ(refusal([&] { shellPicture(recipe); }),
              recipe.file + ": all of 3x2 pixels are transparent");
    recipe.file = folder + "/absent.png";
    EXPECT_TRUE(refusal([&] { shellPicture(recipe); }).starts_with(recipe.file + ": "));
    recipe.from = ShellRecipe::From::picture;
    EXPECT_TRUE(refusal([&] { shellPicture(recipe); }).starts_with(recipe.file + ": "));
}

TEST(ShellSource, PicturesAreTheSameWhateverTheRangeOfTonesIs) {
    const ShellRecipe a{.from = ShellRecipe::From::photo, .file = "a.png"};
    ShellRecipe b = a;
    b.photo.layers = 3;
    b.photo.darkest = 0.2f;
    b.side = 1.0f;
    b.gap = 0.5f;
    b.cut.coverage = 0.9f;
    EXPECT_TRUE(samePicture(a, b));
    b.photo.twoColors = true;
    EXPECT_FALSE(samePicture(a, b));
    b = a;
    b.file = "b.png";
    EXPECT_FALSE(samePicture(a, b));
    b = a;
    b.noise.mask = 3;
    EXPECT_FALSE(samePicture(a, b));
}

}  // namespace
}  // namespace pelage
