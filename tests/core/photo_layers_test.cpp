// photo_layers_test.cpp -- the promises of photo_layers.h and photo_regions.h.
#include "core/photo_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <regex>

#include "core/photo_regions.h"
#include "core/pixels.h"
#include "core/srgb.h"
#include "core/strand.h"
#include "reading.h"
#include "tests/figures.h"

namespace pelage {
namespace {

using test::reached;
using test::refusal;

// A grey picture of these luminances.
Image greys(ivec2 size, const std::vector<float>& tones) {
    Image image{size, {}};
    for (const float tone : tones) image.pixels.emplace_back(vec3(tone), 1.0f);
    return image;
}

// Luminances as they are in fur: by the exponential of a depth with many small parts, 8 bits.
Image furPhoto(int side) {
    std::vector<float> tones;
    for (uint i = 0; i < static_cast<uint>(side * side); ++i) {
        float depth = 0.0f;
        for (uint j = 0; j < 4; ++j) depth += 0.7f * rand01(pcg(i) + j);
        const float code = std::round(255.0f * srgbFromLinear(0.8f * std::exp(-depth)));
        tones.push_back(linearFromSrgb(code / 255.0f));
    }
    return greys(ivec2(side), tones);
}

std::size_t sumOf(const PhotoLayers& layers) {
    return std::accumulate(layers.populations.begin(), layers.populations.end(), std::size_t{0});
}

std::size_t largest(const PhotoLayers& layers) { return std::ranges::max(layers.populations); }

TEST(PhotoLayers, ThresholdsFallGeometricallyToTheDarkest) {
    const std::vector<float> thresholds = layerThresholds(0.0625f, 1.0f, 4);
    ASSERT_EQ(thresholds.size(), 4u);
    EXPECT_NEAR(thresholds[0], 0.5f, 1e-7f);
    EXPECT_NEAR(thresholds[1], 0.25f, 1e-7f);
    EXPECT_NEAR(thresholds[2], 0.125f, 1e-7f);
    EXPECT_EQ(thresholds[3], 0.0625f);
    EXPECT_EQ(layerThresholds(0.3f, 0.9f, 1), std::vector{0.3f});
    for (const int n : {1, 2, 16, 255, 256})
        for (const float low : {0.0003f, 0.1f, 0.7f}) {
            const std::vector<float> p = layerThresholds(low, 0.8f, n);
            EXPECT_EQ(p.back(), low);
            EXPECT_TRUE(std::ranges::is_sorted(p, std::greater<>()));
            EXPECT_LT(p.front(), 0.8f);
        }
}

TEST(PhotoLayers, ALayerHoldsWhatReachesItsThresholdAndNoneBefore) {
    const std::vector<float> p = layerThresholds(0.0625f, 1.0f, 4);  // .5 .25 .125 .0625
    EXPECT_EQ(layerOf(7.0f, p), 1);
    EXPECT_EQ(layerOf(1.0f, p), 1);
    EXPECT_EQ(layerOf(p[0], p), 1);
    EXPECT_EQ(layerOf(std::nextafter(p[0], 0.0f), p), 2);
    EXPECT_EQ(layerOf(p[1], p), 2);
    EXPECT_EQ(layerOf(0.2f, p), 3);
    EXPECT_EQ(layerOf(p[3], p), 4);
    EXPECT_EQ(layerOf(0.01f, p), 4);
    EXPECT_EQ(layerOf(0.0f, p), 4);
}

TEST(PhotoLayers, AShaderFindsTheLayerWithoutATable) {
    for (const int n : {1, 2, 5, 16, 64, 256})
        for (const auto& [low, high] : {std::pair(0.0003f, 1.0f), {0.02f, 0.5f}, {0.3f, 0.31f}}) {
            const std::vector<float> p = layerThresholds(low, high, n);
            int differing = 0;
            for (uint i = 0; i < 20000; ++i) {
                const float intensity = rand01(pcg(i)) * 1.2f * high;
                const double x = n * std::log(static_cast<double>(high / intensity)) /
                                 std::log(static_cast<double>(high) / static_cast<double>(low));
                if (std::abs(x - std::round(x)) < 1e-4 * n) continue;  // on a threshold
                const double closed = std::clamp(std::ceil(x), 1.0, static_cast<double>(n));
                differing += static_cast<int>(closed) != layerOf(intensity, p);
            }
            EXPECT_EQ(differing, 0) << n << " layers, " << low << " to " << high;
        }
}

TEST(PhotoLayers, ExtinctionIsPositiveAndTakesTheBrightestToTheDarkest) {
    // 200 to 20 over 2 cm: ln(10) / 0.02. With the other sign 20 would be 2000.
    EXPECT_NEAR(extinction(20.0f, 200.0f, 0.02), 115.12925465, 1e-6);
    double worst = 0.0;
    for (const float low : {0.001f, 0.2f, 0.899f}) {
        const double sigma = extinction(low, 0.9f, 0.03);
        EXPECT_GT(sigma, 0.0);
        const double deepest = static_cast<double>(0.9f) * std::exp(-sigma * 0.03);
        worst = std::max(worst, std::abs(deepest / static_cast<double>(low) - 1.0));
        EXPECT_EQ(layerThresholds(low, 0.9f, 16).back(), low);
    }
    reached("U1", "luminance that is left under fur, against the darkest tone, relative", worst,
            1e-6);
}

TEST(PhotoLayers, EightBitsTellSoManyLayersApart) {
    EXPECT_EQ(layersToldApart(5.0f, 255.0f, 1.0f), 21);
    EXPECT_EQ(layersToldApart(10.0f, 255.0f, 1.0f), 33);
    EXPECT_EQ(layersToldApart(10.0f, 10.5f, 1.0f), 1);
    EXPECT_EQ(layersToldApart(10.0f, 255.0f, 1e-9f), kMostLayers);
    // The darkest layer is narrower than a step with one layer more.
    const auto width = [](int n) { return 5.0 * (std::pow(51.0, 1.0 / n) - 1.0); };
    EXPECT_GE(width(21), 1.0);
    EXPECT_LT(width(22), 1.0);
}

TEST(PhotoLayers, EntropyIsThatOfShares) {
    EXPECT_EQ(entropy(std::vector<std::size_t>{4, 4, 4, 4}), 2.0);
    EXPECT_EQ(entropy(std::vector<std::size_t>{0, 9, 0}), 0.0);
    EXPECT_EQ(entropy(std::vector<std::size_t>{}), 0.0);
    EXPECT_EQ(entropy(std::vector<std::size_t>{0, 0}), 0.0);
    EXPECT_EQ(entropy(std::vector<std::size_t>{2, 1, 1, 0}), 1.5);
}

TEST(PhotoLayers, EveryPixelIsInExactlyOneLayer) {
    std::vector<float> hot(4096, 0.05f), black(4096, 0.5f), ramp;
    hot[17] = 1.0f;
    black[99] = 0.0f;
    for (int i = 0; i < 4096; ++i) ramp.push_back(static_cast<float>(i) / 4095.0f);
    const std::vector<std::vector<float>> pictures = {
        hot, black, ramp, std::vector<float>(4096, 0.0f), std::vector<float>(4096, 1.0f)};
    std::size_t wrong = 0;
    for (std::size_t which = 0; which < pictures.size(); ++which)
        for (const int n : {1, 2, 16, 256})
            for (const float outside : {0.0f, 0.01f})
                for (const bool uniform : {false, true}) {
                    const PhotoLayers layers =
                        photoLayers(greys({64, 64}, pictures[which]), {.layers = n,
                                                                       .darkest = outside,
                                                                       .brightest = 1.0f - outside,
                                                                       .uniform = uniform});
                    std::vector<std::size_t> counted(static_cast<std::size_t>(n));
                    for (const int k : layers.layerOfPixel)
                        ++counted.at(static_cast<std::size_t>(k - 1));
                    EXPECT_EQ(counted, layers.populations) << which << " " << n;
                    wrong += counted != layers.populations || sumOf(layers) != 4096 ? 1u : 0u;
                }
    reached("U2", "hard pictures of which not every pixel is in one layer",
            static_cast<double>(wrong), 0.0);
}

TEST(PhotoLayers, OutliersDoNotCount) {
    Image photo = furPhoto(128);
    photo.pixels[77] = vec4(0, 0, 0, 1);
    photo.pixels[78] = vec4(1, 1, 1, 1);
    const PhotoLayers clamped = photoLayers(photo, {});
    reached("U3", "bits that 16 layers of fur with one black pixel fall short of 4",
            4.0 - clamped.bits, 1.0);
    EXPECT_LE(clamped.bits, 4.0);
    EXPECT_EQ(std::ranges::count(clamped.populations, 0u), 0);
    const PhotoLayers all = photoLayers(photo, {.darkest = 0.0f, .brightest = 1.0f});
    EXPECT_LT(all.bits, 2.5) << "without the clamp one black pixel takes most layers";
    // 200 tones: the first and the last percent are the two lowest and highest.
    std::vector<float> tones;
    for (int i = 0; i < 201; ++i) tones.push_back(0.1f + 0.001f * static_cast<float>(i));
    const PhotoLayers ramp = photoLayers(greys({201, 1}, tones), {});
    EXPECT_EQ(ramp.regions[0].low, tones[2]);
    EXPECT_EQ(ramp.regions[0].high, tones[198]);
}

TEST(PhotoLayers, TheDarkestThatCountsIsOneStepOfEightBits) {
    std::vector<float> tones(100, 0.5f);
    for (std::size_t i = 0; i < 50; ++i) tones[i] = 0.0f;
    const PhotoLayers layers = photoLayers(greys({10, 10}, tones), {});
    EXPECT_EQ(layers.regions[0].low, linearFromSrgb(1.0f / 255.0f));
    EXPECT_EQ(layers.populations.front(), 50u);
    EXPECT_EQ(layers.populations.back(), 50u);
}

TEST(PhotoLayers, OneLuminanceIsOneLayerAndAWarning) {
    for (const float tone : {0.0f, 0.2f, 1.0f})
        for (const bool uniform : {false, true})
            for (const ivec2 size : {ivec2(1, 1), ivec2(7, 3)}) {
                const PhotoLayers layers = photoLayers(
                    greys(size, std::vector<float>(pixelCount(size), tone)), {.uniform = uniform});
                EXPECT_EQ(layers.populations.front(), pixelCount(size));
                EXPECT_EQ(largest(layers), pixelCount(size));
                ASSERT_EQ(layers.warnings.size(), 1u);
                EXPECT_NE(layers.warnings[0].find("nearly everywhere"), std::string::npos);
            }
    // Also with a few darker pixels, which the percentiles leave out.
    std::vector<float> nearly(1000, 0.2f);
    nearly[3] = 0.1f;
    EXPECT_EQ(photoLayers(greys({1000, 1}, nearly), {}).populations.front(), 1000u);
}

TEST(PhotoLayers, LayersWithoutPixelsAreWarnedOf) {
    std::vector<float> ramp;  // 8 bits of linear light, from 5 to 255
    for (int i = 5; i < 256; ++i) ramp.push_back(static_cast<float>(i) / 255.0f);
    const PhotoOptions all{.layers = 60, .darkest = 0.0f, .brightest = 1.0f};
    const PhotoLayers layers = photoLayers(greys({251, 1}, ramp), all);
    const auto empty = std::ranges::count(layers.populations, 0u);
    EXPECT_GT(empty, 1);
    ASSERT_EQ(layers.warnings.size(), 1u);
    EXPECT_EQ(layers.warnings[0], std::to_string(empty) +
                                      " of 60 layers hold no pixel: the darkest tones tell 21 "
                                      "layers apart");
    PhotoOptions fewer = all;
    fewer.layers = 21;
    EXPECT_TRUE(photoLayers(greys({251, 1}, ramp), fewer).warnings.empty());
}

TEST(PhotoLayers, UniformLayersHoldEquallyMany) {
    const PhotoLayers layers = photoLayers(furPhoto(128), {.layers = 8, .uniform = true});
    EXPECT_GT(layers.bits, 2.99);
    // Different tones: to a pixel, whatever the numbers.
    std::vector<float> tones;
    for (uint i = 0; i < 1000; ++i) tones.push_back(0.001f * static_cast<float>(i * 7 % 1000));
    for (const int n : {1, 3, 7, 16, 256}) {
        const PhotoLayers even =
            photoLayers(greys({100, 10}, tones), {.layers = n, .uniform = true});
        const auto [least, most] = std::ranges::minmax(even.populations);
        EXPECT_LE(most - least, 1u) << n;
        EXPECT_TRUE(std::ranges::is_sorted(even.regions[0].thresholds, std::greater<>()));
    }
}

TEST(PhotoLayers, LuminanceIsLinearAndItsHistogramAsDisplayed) {
    // Every code of 8 bits once: each bar is 1.
    std::vector<float> tones;
    for (int i = 0; i < 256; ++i) tones.push_back(linearFromSrgb(static_cast<float>(i) / 255.0f));
    const PhotoLayers layers = photoLayers(greys({16, 16}, tones), {.layers = 2});
    EXPECT_EQ(std::ranges::count(layers.histogram, 1u), 256);
    // Of linear light: the middle threshold is the geometric mean of the range.
    const PhotoRegion& region = layers.regions[0];
    EXPECT_NEAR(region.thresholds[0], std::sqrt(region.low * region.high), 1e-6f);
    // Green is brighter than blue.
    const Image colors{{2, 1}, {vec4(0, 0, 1, 1), vec4(0, 1, 0, 1)}};
    const PhotoLayers two = photoLayers(colors, {.layers = 2, .darkest = 0.0f, .brightest = 1.0f});
    EXPECT_EQ(two.layerOfPixel, (std::vector<std::uint16_t>{2, 1}));
    EXPECT_NEAR(two.regions[0].low, 0.07218f, 1e-4f);
    EXPECT_NEAR(two.regions[0].high, 0.71517f, 1e-4f);
}

TEST(PhotoLayers, TransparentPixelsAreInNoLayer) {
    Image photo{{4, 1},
                {vec4(0), vec4(0.2f, 0.2f, 0.2f, 1), vec4(0.4f, 0.4f, 0.4f, 0.5f), vec4(0)}};
    const PhotoLayers layers =
        photoLayers(photo, {.layers = 2, .darkest = 0.0f, .brightest = 1.0f});
    // What is half covered shows a luminance of 0.8 there.
    EXPECT_EQ(layers.layerOfPixel, (std::vector<std::uint16_t>{0, 2, 1, 0}));
    EXPECT_NEAR(layers.regions[0].high, 0.8f, 1e-6f);
    EXPECT_EQ(sumOf(layers), 2u);
    EXPECT_EQ(refusal([] {
                  photoLayers({{8, 8}, std::vector<vec4>(64, vec4(0))}, {});
              }),
              "all of 8x8 pixels are transparent");
}

TEST(PhotoLayers, APictureOfALayerIsThePhotographThere) {
    std::vector<unsigned char> photo;
    for (unsigned char i = 0; i < 16; ++i) photo.push_back(static_cast<unsigned char>(10 + i));
    PhotoLayers layers;
    layers.size = {2, 2};
    layers.layerOfPixel = {1, 3, 0, 2};
    using Bytes = std::vector<unsigned char>;
    const Bytes second = layerPicture(photo, layers, 2, false);
    EXPECT_EQ(second, (Bytes{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 22, 23, 24, 25}));
    const Bytes upTo = layerPicture(photo, layers, 2, true);
    EXPECT_EQ(upTo, (Bytes{10, 11, 12, 13, 0, 0, 0, 0, 0, 0, 0, 0, 22, 23, 24, 25}));
    EXPECT_EQ(layerPicture(photo, layers, 3, true),
              (Bytes{10, 11, 12, 13, 14, 15, 16, 17, 0, 0, 0, 0, 22, 23, 24, 25}));
}

// Two colors side by side, hairs of which are bright and dark.
Image twoFurs(int side, vec3 left, vec3 right) {
    Image image{ivec2(side), {}};
    for (int i = 0; i < side * side; ++i) {
        const float light = std::exp(-2.0f * rand01(pcg(static_cast<uint>(i))));
        image.pixels.emplace_back(light * (i % side < side / 3 ? left : right), 1.0f);
    }
    return image;
}

TEST(PhotoRegions, TwoColorsAreToldApartAlsoWithoutHue) {
    const vec3 orange(0.8f, 0.35f, 0.1f), white(0.9f), black(0.03f), red(0.9f, 0.1f, 0.1f),
        green(0.05f, 0.35f, 0.05f);
    for (const auto& [left, right] :
         {std::pair(orange, white), {black, white}, {white, black}, {red, green}})
        for (const int side : {32, 128, 256}) {
            const std::vector<unsigned char> regions = colorRegions(twoFurs(side, left, right));
            int wrong = 0;
            for (int i = 0; i < side * side; ++i)  // away from the border by two cells
                if (std::abs(i % side - side / 3) > 8)
                    wrong += regions[static_cast<std::size_t>(i)] != (i % side < side / 3 ? 1 : 0);
            EXPECT_LE(wrong, side * side / 500) << side << " " << left.r << " " << right.r;
        }
}

TEST(PhotoRegions, OneColorIsOneRegion) {
    for (const float tone : {0.0f, 0.3f, 1.0f}) {
        const std::vector<unsigned char> regions =
            colorRegions(greys({40, 30}, std::vector<float>(1200, tone)));
        EXPECT_EQ(std::ranges::count(regions, 0), 1200);
    }
    EXPECT_EQ(colorRegions({{2, 1}, {vec4(0), vec4(0)}}), (std::vector<unsigned char>{0, 0}));
    EXPECT_EQ(colorRegions(greys({1, 1}, {0.5f})), std::vector<unsigned char>{0});
}

TEST(PhotoRegions, TransparentPixelsAreOfNoColor) {
    Image image = twoFurs(64, vec3(0.02f), vec3(0.9f));
    for (int i = 0; i < 64 * 64; ++i)
        if (i % 64 < 32) image.pixels[static_cast<std::size_t>(i)] = vec4(0);
    const std::vector<unsigned char> regions = colorRegions(image);
    for (int i = 0; i < 64 * 64; ++i) {
        if (i % 64 < 32) {
            EXPECT_EQ(regions[static_cast<std::size_t>(i)], 0);
        }
    }
}

TEST(PhotoLayers, EachColorHasARangeOfItsOwn) {
    const Image zebra = twoFurs(256, vec3(0.03f), vec3(0.9f));
    const PhotoLayers one = photoLayers(zebra, {}), two = photoLayers(zebra, {.twoColors = true});
    ASSERT_EQ(one.regions.size(), 1u);
    ASSERT_EQ(two.regions.size(), 2u);
    EXPECT_GT(two.regions[0].pixels, two.regions[1].pixels);
    EXPECT_EQ(two.regions[0].pixels + two.regions[1].pixels, 256u * 256u);
    // exp(-2 u) of the color, u uniform.
    EXPECT_NEAR(two.regions[0].high, 0.9f, 0.03f);
    EXPECT_NEAR(two.regions[0].low, 0.9f * std::exp(-2.0f), 0.01f);
    EXPECT_NEAR(two.regions[1].low, 0.03f * std::exp(-2.0f), 0.001f);
    EXPECT_NEAR(two.regions[0].color.g / 0.9f, 0.5f * (1.0f - std::exp(-2.0f)), 0.01f);
    // The dark fur is no longer all at the skin: its layers are filled as those of the bright one.
    const auto layersOf = [&](const PhotoLayers& layers) {
        std::vector<std::size_t> dark(16);
        for (int i = 0; i < 256 * 256; ++i)
            if (i % 256 < 70)
                ++dark[static_cast<std::size_t>(layers.layerOfPixel[static_cast<std::size_t>(i)] -
                                                1)];
        return dark;
    };
    EXPECT_EQ(std::ranges::count(layersOf(two), 0u), 0);
    EXPECT_LT(entropy(layersOf(one)), 3.2);
    EXPECT_GT(entropy(layersOf(two)), 3.8);
}

TEST(PhotoLayers, TwoColorsAskedForWhereThereIsOneAreWarnedOf) {
    std::vector<float> tones;
    for (uint i = 0; i < 4096; ++i) tones.push_back(0.2f + 0.3f * rand01(pcg(i)));
    const PhotoLayers flat =
        photoLayers(greys({4, 4}, std::vector<float>(16, 0.3f)), {.twoColors = true});
    EXPECT_EQ(flat.regions.size(), 1u);
    EXPECT_EQ(flat.warnings.back(), "there are no two colors to tell apart");
}

TEST(PhotoLayers, TheHistogramHasItsBarsAndALineForEachThreshold) {
    const auto countOf = [](const std::string& text, const char* pattern) {
        const std::regex wanted(pattern);
        return std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), {});
    };
    // Three tones, one of them twice: bars of half and of full height, at 0, 128 and 255 of 256.
    const float middle = linearFromSrgb(128.0f / 255.0f);
    const PhotoLayers layers = photoLayers(greys({4, 1}, {0.0f, middle, middle, 1.0f}),
                                           {.layers = 5, .darkest = 0.0f, .brightest = 1.0f});
    const std::string svg = histogramSvg(layers, "a<b>.png");
    EXPECT_EQ(countOf(svg, "<rect x="), 3);
    EXPECT_EQ(countOf(svg, "<rect x=\"12.00\" y=\"110.00\" width=\"2.00\" height=\"80.00\""), 1);
    EXPECT_EQ(countOf(svg, "<rect x=\"268.00\" y=\"30.00\" width=\"2.00\" height=\"160.00\""), 1);
    EXPECT_EQ(countOf(svg, "<rect x=\"522.00\" y=\"110.00\" width=\"2.00\" height=\"80.00\""), 1);
    EXPECT_EQ(countOf(svg, "<line "), 5);
    EXPECT_EQ(countOf(svg, "<line x1=\"15.00\""), 1) << "the darkest threshold is code 1";
    EXPECT_NE(svg.find(">a&lt;b&gt;.png<"), std::string::npos);
    const PhotoLayers two = photoLayers(twoFurs(64, vec3(0.03f), vec3(0.9f)), {.twoColors = true});
    const std::string both = histogramSvg(two, "");
    EXPECT_EQ(countOf(both, "<line [^>]*#0072b2"), 16);
    EXPECT_EQ(countOf(both, "<line [^>]*#d55e00"), 16);
}

}  // namespace
}  // namespace pelage
