// image_error_test.cpp -- the promises of image_error.h, flip.h, ssim.h and image_filter.h.
#include "core/image_error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/flip.h"
#include "core/image_filter.h"
#include "core/srgb.h"
#include "core/ssim.h"
#include "gtest/gtest.h"
#include "reading.h"

namespace pelage {
namespace {

using test::refusal;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image picture(ivec2 size, const std::function<vec3(int, int)>& color) {
    Image image{size, {}};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) image.pixels.emplace_back(color(x, y), 1.0f);
    return image;
}

Image even(ivec2 size, vec3 color) {
    return picture(size, [&](int, int) { return color; });
}

vec3 stripes(int x, int y) {
    return vec3(0.8, 0.6, 0.3) * (0.5f + 0.5f * std::sin(0.9f * float(x) + 0.15f * float(y)));
}

// Grays of [0,1] without order.
Image grays(ivec2 size, float frequency) {
    return picture(size, [=](int x, int y) {
        return vec3(0.5f + 0.5f * std::sin(frequency * float(x * x + 3 * y)));
    });
}

double flipMean(const Image& image, const Image& reference) {
    return imageErrors(image, reference).flipMean;
}

// The means were computed with the FLIP that its authors publish.
TEST(Flip, MeansAreThoseOfTheAuthorsProgram) {
    constexpr ivec2 kSize(96, 64);
    const Image reference = picture(kSize, stripes), black = even(kSize, vec3(0));
    const Image darker = picture(kSize, [](int x, int y) { return 0.9f * stripes(x, y); });
    const Image shifted = picture(kSize, [](int x, int y) { return stripes(x + 1, y); });
    const Image swapped = picture(kSize, [](int x, int y) {
        const vec3 c = stripes(x, y);
        return vec3(c.g, c.r, c.b);
    });
    const Image halfWhite = picture(kSize, [](int x, int) { return vec3(x >= 48); });
    EXPECT_NEAR(flipMean(darker, reference), 0.179699, 2e-5);
    EXPECT_NEAR(flipMean(shifted, reference), 0.422402, 2e-5);
    EXPECT_NEAR(flipMean(swapped, reference), 0.460894, 2e-5);
    EXPECT_NEAR(flipMean(halfWhite, black), 0.513325, 5e-5);
    EXPECT_EQ(flipMean(even(kSize, vec3(0, 1, 0)), even(kSize, vec3(0, 0, 1))), 1.0);
}

TEST(Flip, IsZeroWhereNothingDiffers) {
    const Image image = grays({70, 40}, 1.7f);
    for (const float value : flip(image, image).values) ASSERT_EQ(value, 0.0f);
}

TEST(Flip, IsTheSameBothWaysAndWithinZeroAndOne) {
    const Image a = grays({70, 40}, 1.7f), b = picture({70, 40}, stripes);
    const Plane ab = flip(a, b);
    EXPECT_EQ(ab.size, ivec2(70, 40));
    EXPECT_EQ(ab.values, flip(b, a).values);
    const auto [least, most] = std::ranges::minmax_element(ab.values);
    EXPECT_GE(*least, 0.0f);
    EXPECT_LE(*most, 1.0f);
    EXPECT_GT(*most, 0.1f);
}

// One pixel has neither edges nor points: what is left is the formula of the difference of colors.
// L*, a* and b* of the colors are those that tables of sRGB (D65) print.
TEST(Flip, OfOnePixelIsTheDifferenceOfColors) {
    const auto distance = [](glm::dvec3 a, glm::dvec3 b) {
        const double da = 0.01 * (a.x * a.y - b.x * b.y), db = 0.01 * (a.x * a.z - b.x * b.z);
        return std::pow(std::abs(a.x - b.x) + std::sqrt(da * da + db * db), 0.7);
    };
    const glm::dvec3 red(53.2408, 80.0925, 67.2032), green(87.7347, -86.1827, 83.1793);
    const glm::dvec3 blue(32.2970, 79.1875, -107.8602), gray(53.5850, 0, 0), lighter(54.0, 0, 0);
    const double farthest = distance(green, blue);
    const auto flipOf = [](vec3 a, vec3 b) { return flipMean(even({1, 1}, a), even({1, 1}, b)); };
    const double far = distance(red, green), near = distance(gray, lighter);
    ASSERT_GT(far, 0.4 * farthest);
    EXPECT_NEAR(flipOf(vec3(1, 0, 0), vec3(0, 1, 0)),
                0.95 + 0.05 * (far - 0.4 * farthest) / (0.6 * farthest), 1e-4);
    const auto lightOf = [](double lightness) {
        return vec3(static_cast<float>(std::pow((lightness + 16.0) / 116.0, 3.0)));
    };
    EXPECT_NEAR(flipOf(lightOf(gray.x), lightOf(lighter.x)), 0.95 * near / (0.4 * farthest), 1e-4);
}

TEST(Flip, LightOverOneCountsAsOneAndCoverageNotAtAll) {
    const Image white = even({5, 5}, vec3(1));
    Image bright = even({5, 5}, vec3(7, 1, 2));
    for (vec4& pixel : bright.pixels) pixel.a = 0.5f;
    EXPECT_EQ(flipMean(bright, white), 0.0);
}

TEST(Flip, MovesWithThePictures) {
    const auto spot = [](int left, int top) {
        return picture({90, 90}, [=](int x, int y) {
            const bool inside = x >= left && x < left + 6 && y >= top && y < top + 4;
            return inside ? vec3(0.9, 0.5, 0.1) : vec3(0.2f);
        });
    };
    const Image plain = even({90, 90}, vec3(0.2f));
    const Plane at = flip(spot(40, 40), plain), moved = flip(spot(47, 43), plain);
    for (std::size_t y = 0; y < 80; ++y)
        for (std::size_t x = 0; x < 80; ++x)
            ASSERT_EQ(at.values[90 * y + x], moved.values[90 * (y + 3) + x + 7]) << x << " " << y;
}

TEST(ImageFilter, OverTheEdgeTheEdgesOwnPixelCounts) {
    const Plane plane{{45, 3}, [] {
                          std::vector<float> values(135);
                          for (std::size_t i = 0; i < values.size(); ++i)
                              values[i] = static_cast<float>(i);
                          return values;
                      }()};
    const std::vector<float> fromTwoAfter = {0, 0, 0, 0, 1};
    const Plane left = filterRows(plane, fromTwoAfter), up = filterColumns(plane, fromTwoAfter);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 45; ++x) {
            const auto i = static_cast<std::size_t>(45 * y + x);
            EXPECT_EQ(left.values[i], float(45 * y + std::min(x + 2, 44)));
            EXPECT_EQ(up.values[i], float(45 * std::min(y + 2, 2) + x));
        }
    }
}

TEST(ImageFilter, WeightsOfAGaussianSumToOne) {
    const std::vector<float> weights = gaussian(1.5, 5);
    ASSERT_EQ(weights.size(), 11u);
    float sum = 0.0f;
    for (const float weight : weights) sum += weight;
    EXPECT_NEAR(sum, 1.0f, 1e-6f);
    EXPECT_NEAR(weights[5] / weights[2], std::exp(2.0f), 1e-4f);
}

TEST(Ssim, IsOneForEqualPictures) {
    for (const ivec2 size : {ivec2(1, 1), ivec2(50, 20)}) {
        const Image image = grays(size, 1.3f);
        EXPECT_EQ(ssim(image, image), 1.0);
    }
}

// Without variance the means alone count.
TEST(Ssim, OfEvenPicturesIsTheTermOfTheMeans) {
    const float a = 0.2f, b = 0.6f;  // display-encoded
    const double expected = (2 * 0.2 * 0.6 + 1e-4) / (0.2 * 0.2 + 0.6 * 0.6 + 1e-4);
    for (const ivec2 size : {ivec2(1, 1), ivec2(20, 13)}) {
        EXPECT_NEAR(ssim(even(size, vec3(linearFromSrgb(a))), even(size, vec3(linearFromSrgb(b)))),
                    expected, 1e-5);
    }
    EXPECT_EQ(ssim(even({2, 2}, vec3(1)), even({2, 2}, vec3(9))), 1.0);
}

// Pixels in [0,1] whose neighbours alternate: a against 1 - a. Weights of odd and even distance
// give every moment by hand, away from the edge.
TEST(Ssim, OfACheckerboardAgainstItsNegativeIsNegative) {
    const auto board = [](int first) {
        return picture({41, 41}, [=](int x, int y) { return vec3(float((x + y + first) % 2)); });
    };
    double sums[2] = {0, 0};
    for (int x = -5; x <= 5; ++x) sums[std::abs(x) % 2] += std::exp(-0.5 * x * x / 2.25);
    const double even1d = sums[0] / (sums[0] + sums[1]), odd1d = 1 - even1d;
    const double same = even1d * even1d + odd1d * odd1d;  // share of pixels of the middle's color
    const double mean = same, other = 1 - same, variance = same * other;
    const double expected = (2 * mean * other + 1e-4) / (mean * mean + other * other + 1e-4) *
                            (-2 * variance + 9e-4) / (2 * variance + 9e-4);
    EXPECT_NEAR(expected, -0.99, 0.02);
    EXPECT_NEAR(ssim(board(0), board(1)), expected, 0.01);  // edges differ a little
}

// The definition itself, window by window, in double.
TEST(Ssim, IsTheMeanOfTheDefinitionOverAllWindows) {
    constexpr int kWidth = 17, kHeight = 9;
    const Image a = grays({kWidth, kHeight}, 0.37f), b = grays({kWidth, kHeight}, 0.41f);
    const auto luma = [](const Image& image, int x, int y) {
        const int i = std::clamp(y, 0, kHeight - 1) * kWidth + std::clamp(x, 0, kWidth - 1);
        const auto light = static_cast<double>(image.pixels[static_cast<std::size_t>(i)].g);
        return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    };
    double sum = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            double weights = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
            for (int j = -5; j <= 5; ++j) {
                for (int i = -5; i <= 5; ++i) {
                    const double weight = std::exp(-0.5 * (i * i + j * j) / (1.5 * 1.5));
                    const double p = luma(a, x + i, y + j), q = luma(b, x + i, y + j);
                    weights += weight;
                    ma += weight * p;
                    mb += weight * q;
                    aa += weight * p * p;
                    bb += weight * q * q;
                    ab += weight * p * q;
                }
            }
            ma /= weights;
            mb /= weights;
            const double covariance = ab / weights - ma * mb;
            const double variances = aa / weights - ma * ma + bb / weights - mb * mb;
            sum += (2 * ma * mb + 1e-4) * (2 * covariance + 9e-4) /
                   ((ma * ma + mb * mb + 1e-4) * (variances + 9e-4));
        }
    }
    const double expected = sum / (kWidth * kHeight);
    EXPECT_LT(expected, 0.9);
    EXPECT_NEAR(ssim(a, b), expected, 1e-5);
}

TEST(ImageErrors, RmseIsOverAllPixelsAndChannels) {
    const Image reference = even({2, 1}, vec3(0.5f));
    Image image = reference;
    image.pixels[1] = vec4(0.8, 0.1, 2.5, 1);  // differs by 0.3, 0.4 and 2
    EXPECT_NEAR(imageErrors(image, reference).rmse, std::sqrt(4.25 / 6), 1e-7);
    EXPECT_EQ(imageErrors(reference, reference).rmse, 0.0);
}

TEST(ImageErrors, LuminanceBiasIsSignedAndRelative) {
    const Image gray = even({3, 2}, vec3(0.4f)), black = even({3, 2}, vec3(0));
    EXPECT_NEAR(imageErrors(even({3, 2}, vec3(0.3f)), gray).luminanceBias, -0.25, 1e-6);
    EXPECT_NEAR(imageErrors(gray, even({3, 2}, vec3(0.3f))).luminanceBias, 1.0 / 3, 1e-6);
    // Rec. 709: white is 0.2126 red.
    EXPECT_NEAR(imageErrors(even({3, 2}, vec3(1, 0, 0)), even({3, 2}, vec3(1))).luminanceBias,
                0.2126 - 1, 1e-4);
    EXPECT_EQ(imageErrors(black, black).luminanceBias, 0.0);
    EXPECT_EQ(imageErrors(gray, black).luminanceBias, std::numeric_limits<double>::infinity());
    EXPECT_EQ(imageErrors(black, gray).luminanceBias, -1.0);
}

TEST(Image, TheMeanOfAPlaneIsThatOfItsValues) {
    EXPECT_EQ(meanOf({{2, 2}, {1.0f, 2.0f, 4.0f, 9.0f}}), 4.0);
    // A sum in single precision would stay at 2^24.
    EXPECT_EQ(meanOf({{1 << 13, 1 << 12}, std::vector<float>(std::size_t{1} << 25, 1.0f)}), 1.0);
}

TEST(ImageErrors, FlipIsGivenAsMapMeanAndPercentile) {
    const Image image = grays({27, 10}, 1.7f), reference = grays({27, 10}, 1.6f);
    const ImageErrors errors = imageErrors(image, reference);
    std::vector<float> values = flip(image, reference).values;
    EXPECT_EQ(errors.flipMap.values, values);
    double sum = 0;
    for (const float value : values) sum += static_cast<double>(value);
    EXPECT_NEAR(errors.flipMean, sum / 270, 1e-9);
    std::ranges::sort(values);
    EXPECT_EQ(errors.flip99, static_cast<double>(values[267]));  // 268 of 270 are 99.3 %
    EXPECT_NE(values[266], values[267]);                         // 267 are 98.9 %
    EXPECT_NE(values[267], values[268]);
}

Image covered(const std::vector<float>& coverage) {
    Image image{{static_cast<int>(coverage.size()), 1}, {}};
    for (const float alpha : coverage) image.pixels.emplace_back(0, 0, 0, alpha);
    return image;
}

TEST(ImageErrors, CoverageIsComparedOverTheBandOfTheSilhouette) {
    const auto errors =
        *imageErrors(covered({0.25, 0.5, 0.75, 0.5, 0}), covered({0, 0.75, 0.25, 1, 0})).coverage;
    EXPECT_EQ(errors.bandPixels, 2u);
    EXPECT_NEAR(errors.bandBias, 0.125, 1e-12);  // -0.25 and 0.5
    EXPECT_NEAR(errors.bandRmse, std::sqrt(0.3125 / 2), 1e-12);
    EXPECT_NEAR(errors.areaRatio, 1.0, 1e-12);
    EXPECT_NEAR(errors.silhouette, 1.5 / 2.75, 1e-12);
}

TEST(ImageErrors, HalfAStepOf16BitsIsOutsideTheBand) {
    const float step = 1.0f / 65535.0f;
    const Image reference = covered({0.4f * step, 0.6f * step, 1 - 0.4f * step, 1 - 0.6f * step});
    EXPECT_EQ(imageErrors(reference, reference).coverage->bandPixels, 2u);
}

TEST(ImageErrors, CoverageIsDefinedWithoutABandAndWithoutArea) {
    const Image nothing = covered({0, 0}), half = covered({1, 0});
    const CoverageErrors none = *imageErrors(nothing, nothing).coverage;
    EXPECT_EQ(none.bandPixels, 0u);
    EXPECT_EQ(none.bandBias, 0.0);
    EXPECT_EQ(none.bandRmse, 0.0);
    EXPECT_EQ(none.areaRatio, 1.0);
    EXPECT_EQ(none.silhouette, 0.0);
    const CoverageErrors tooMuch = *imageErrors(half, nothing).coverage;
    EXPECT_EQ(tooMuch.areaRatio, std::numeric_limits<double>::infinity());
    EXPECT_EQ(tooMuch.silhouette, 1.0);
    const CoverageErrors outside = *imageErrors(covered({2, -1}), half).coverage;
    EXPECT_EQ(outside.areaRatio, 1.0);
    EXPECT_EQ(outside.silhouette, 0.0);
}

TEST(ImageErrors, CoverageIsThereWhereOneHasAPixelNotFullyCovered) {
    const Image full = covered({1, 1}), half = covered({1, 0.5});
    EXPECT_FALSE(imageErrors(full, full).coverage);
    EXPECT_NEAR(imageErrors(half, full).coverage->areaRatio, 0.75, 1e-12);
    EXPECT_NEAR(imageErrors(full, half).coverage->bandBias, 0.5, 1e-12);
}

TEST(ImageErrors, WhatCannotBeComparedIsRefusedInOneLine) {
    const Image image = even({4, 3}, vec3(0.5f));
    EXPECT_EQ(refusal([&] {
                  imageErrors(image, even({3, 4}, vec3(0.5f)));
              }),
              "4x3 pixels, the reference has 3x4");
    EXPECT_EQ(refusal([&] { imageErrors({}, image); }), "the picture has no pixels");
    EXPECT_EQ(refusal([&] { imageErrors(image, {}); }), "the reference has no pixels");
    for (const float wrong : {kNan, kInfinity, -kInfinity}) {
        for (int channel = 0; channel < 4; ++channel) {
            Image broken = image;
            broken.pixels[9][channel] = wrong;
            EXPECT_EQ(refusal([&] { imageErrors(broken, image); }),
                      "pixel 1, 2 of the picture is not finite");
            EXPECT_EQ(refusal([&] { imageErrors(image, broken); }),
                      "pixel 1, 2 of the reference is not finite");
        }
    }
}

}  // namespace
}  // namespace pelage
