// live_gltest.cpp -- every style of hair against the reference: how much it covers, how bright it
// is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/render/reference_view.h"
#include "core/coat.h"
#include "core/image_error.h"
#include "core/pixels.h"
#include "tests/figures.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

constexpr const char* kStyles[] = {"line", "polyline", "ribbon", "nurbs-curve", "nurbs-surface"};

// Straight hair 2 pixels wide at the root and 64 long, pointed, upright on a sheet.
constexpr float kPixel = 1.5e-3f;  // m
Document uprightHair() {
    Document document = test::lyingHair(9440, test::sheet(4));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f), 64.0f * kPixel, vec3(1.0f), 1.0f});
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        coat->directionWeight = 0.0f;
        coat->taper = 1.0f;
        coat->width = 2.0f * kPixel;
    }
    return document;
}

// Without perspective, at an angle to the hair.
View viewFrom(float degrees) {
    View view = test::viewFromAbove(96);
    view.camera.pitch = glm::radians(90.0f - degrees);
    view.camera.distance = 48.0f * kPixel / std::tan(0.5f * view.camera.fieldOfView);
    view.samples = 16;
    view.showSkin = false;
    return view;
}

double referenceCoverage(const Document& document, const View& view) {
    ReferencePicture picture(
        std::make_shared<const ReferenceScene>(document, referenceOptions(view)),
        referenceView(view));
    picture.add(32);
    double sum = 0.0;
    for (const vec4& pixel : picture.pixels()) sum += static_cast<double>(pixel.a);
    return sum / static_cast<double>(view.size.x * view.size.y);
}

TEST(Live, EveryStyleCoversWhatTheReferenceDoesFromAnyAngle) {
    Document document = uprightHair();
    Renderer renderer;
    for (const float degrees : {10.0f, 20.0f, 45.0f, 70.0f}) {
        const View view = viewFrom(degrees);
        const double truth = referenceCoverage(document, view);
        for (uint style = kStyleLine; style <= kStyleTube; ++style) {
            document.fur.over.style = document.fur.under.style = style;
            const double covered =
                test::coveredPixels(renderer, document, view) / (view.size.x * view.size.y);
            const std::string what = std::string("coverage by ") + kStyles[style] + " from " +
                                     std::to_string(std::lround(degrees)) + " degrees";
            std::printf("%s: %.4f, the reference %.4f\n", what.c_str(), covered, truth);
            test::reached("I4", what.c_str(), std::abs(covered - truth),
                          degrees < 20.0f ? 0.03 : 0.01);
        }
    }
}

// A ball in so long a coat of 20,000 hairs that they are no wider than a fortieth of their length
// and still cover the skin three times over.
Document coated(const Fur& fur) {
    Document document = test::furryBall(20000);
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 0.0f, 0.5f), 0.4f, vec3(1.0f), 1.0f});
    const uint hairs = document.fur.hairs;
    document.fur = fur;
    document.fur.hairs = hairs;
    const double length = hairs / document.skin->area * 0.4;  // 1/m
    for (Coat* coat : {&document.fur.over, &document.fur.under})
        if (!(coat->width > 0.0f))
            coat->width =
                static_cast<float>(3.0 / (length * (1.0 - 0.5 * static_cast<double>(coat->taper))));
    return document;
}

Image livePicture(Renderer& renderer, const Document& document, View view) {
    view.background = vec3(0.0f);
    return linearImage({view.size, test::picture(renderer, document, view)});
}

Image tracedPicture(const std::shared_ptr<const ReferenceScene>& scene, const View& view,
                    uint style) {
    ReferenceView traced = referenceView(view);
    traced.shadows = Shadows::live;
    traced.style = style;
    ReferencePicture picture(scene, traced);
    picture.add(16);
    Image image{view.size, picture.pixels()};
    for (vec4& pixel : image.pixels)
        pixel = vec4(glm::clamp(vec3(pixel), 0.0f, 1.0f), 1.0f);  // over black
    return image;
}

// |bias| of the mean luminance, in each of these styles.
void compareLight(Renderer& renderer, const Preset& preset, std::initializer_list<uint> styles,
                  std::vector<double>& most, int side = 80) {
    Document document = coated(preset.fur);
    View view = test::ballView(document, side);
    view.camera.distance *= 1.2f;
    view.segments = 16;
    view.samples = 8;
    const auto scene = std::make_shared<const ReferenceScene>(document, referenceOptions(view));
    for (const uint style : styles) {
        document.fur.over.style = document.fur.under.style = style;
        const double bias =
            imageErrors(livePicture(renderer, document, view), tracedPicture(scene, view, style))
                .luminanceBias;
        std::printf("%s, %s: bias %+.2f %%\n", preset.name.c_str(), kStyles[style], 100.0 * bias);
        most[style] = std::max(most[style], std::abs(bias));
    }
}

TEST(Live, PicturesAreAsBrightAsTheReference) {
    Renderer renderer;
    std::vector<double> most(5, 0.0);
    for (const Preset& preset : presets()) compareLight(renderer, preset, {kStylePolyline}, most);
    test::measured("I10", "bias of the mean luminance, polylines of all presets",
                   most[kStylePolyline], 0.01);
    EXPECT_LT(most[kStylePolyline], 0.015) << "narrow hair without its front would be 2 % off";
    most.assign(5, 0.0);
    compareLight(renderer, presets().front(), {kStyleLine, kStyleRibbon, kStyleCurve, kStyleTube},
                 most);
    for (const uint style : {kStyleRibbon, kStyleCurve, kStyleTube}) {
        const std::string what = std::string("bias of the mean luminance, ") + kStyles[style];
        test::measured("I10", what.c_str(), most[style], 0.01);
        EXPECT_LT(most[style], 0.01) << kStyles[style];
    }
    // Straight hair stands where bent hair does not.
    test::measured("I10", "bias of the mean luminance, line", most[kStyleLine], 0.01);
}

// Hair wide for its length, whose round fronts and ends count.
TEST(Live, WideHairIsDrawnAsRoundAsItIs) {
    Renderer renderer;
    Preset plush = *std::ranges::find(presets(), "plush", &Preset::name);
    Document narrow = coated(plush.fur);
    plush.fur.over.width = 4.0f * narrow.fur.over.width;
    plush.fur.under.width = 4.0f * narrow.fur.under.width;
    std::vector<double> most(5, 0.0);
    compareLight(renderer, plush, {kStylePolyline}, most, 240);
    EXPECT_LT(most[kStylePolyline], 0.015) << "flat hair would be 3 % too dark";
}

}  // namespace
}  // namespace pelage
