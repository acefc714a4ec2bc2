// fidelity_gltest.cpp -- pictures keep the FLIP that is asked for.
#include <gtest/gtest.h>

#include <cstdio>

#include "app/render/frames.h"
#include "core/fidelity.h"
#include "core/flip.h"
#include "core/pixels.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

// Hair of other lengths, colors and styles on a ball.
Document stripedBall() {
    Document document = test::furryBall(8000);
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.5f, 0.0f, 0.5f), 0.4f, vec3(1.0f), 1.0f});
    for (uint v = 0; v < document.skin->vertices.size(); v += 2)
        document.groom.fur.edit(v).tint = vec3(0.1f, 0.05f, 0.0f);
    document.fur.over.style = document.fur.under.style = kStyleRibbon;
    document.fur.over.colorNoise = 1.0f;
    return document;
}

View viewOf(const Document& document, float nearer) {
    View view = test::ballView(document, 112);
    view.camera.distance *= nearer;
    view.samples = 4;
    return view;
}

Image complete(Renderer& renderer, const Document& document, View view, const Detail& detail) {
    view.detail = detail;
    drawFinished(renderer, document, view);
    return linearImage({view.size, renderer.pixels()});
}

double flipBetween(const Image& image, const Image& reference) {
    double sum = 0.0;
    for (const float value : flip(image, reference).values) sum += static_cast<double>(value);
    return sum / static_cast<double>(image.pixels.size());
}

constexpr Detail kAll{.rule = Detail::Rule::all};

Detail flipOf(float limit) { return {.rule = Detail::Rule::flip, .limit = limit}; }

TEST(Fidelity, ACompletePictureHasNoGreaterErrorThanIsAskedFor) {
    Renderer renderer;
    for (const Document& document : {test::furryBall(8000), stripedBall()})
        for (const float nearer : {0.5f, 1.0f, 6.0f}) {
            const View view = viewOf(document, nearer);
            const Image all = complete(renderer, document, view, kAll);
            const double error =
                flipBetween(complete(renderer, document, view, flipOf(0.05f)), all);
            std::printf("%g times as far: FLIP %.4f\n", static_cast<double>(nearer), error);
            EXPECT_LE(error, 0.05 + 1e-4);
            // What is asked for is used, where the fur fills the picture.
            if (nearer < 6.0f) {
                EXPECT_GT(flipBetween(complete(renderer, document, view, flipOf(0.2f)), all),
                          error);
            }
        }
}

TEST(Fidelity, TheErrorThatIsToldIsTheOneOfThePicture) {
    Renderer renderer;
    const Document document = stripedBall();
    View view = viewOf(document, 1.0f);
    const Image all = complete(renderer, document, view, kAll);
    const OverlayLine line{vec3(-1.0f), vec3(1.0f), vec4(1.0f)};
    for (const bool lined : {false, true}) {
        if (lined) view.lines = std::span(&line, 1);  // is no error
        view.detail = flipOf(0.1f);
        const FrameStats stats = drawFinished(renderer, document, view);
        EXPECT_TRUE(stats.flipMeasured);
        EXPECT_GT(stats.deviation, 0.0f);
        const Image image = complete(renderer, document, viewOf(document, 1.0f), flipOf(0.1f));
        EXPECT_NEAR(static_cast<double>(stats.flip), flipBetween(image, all), 1e-4);
    }
}

TEST(Fidelity, WithoutPatienceTheErrorIsOnlyReckoned) {
    Renderer renderer;
    const Document document = test::furryBall(2000);
    View view = viewOf(document, 1.0f);
    view.patience = 0.0;
    view.detail = flipOf(0.1f);
    const FrameStats stats = drawFinished(renderer, document, view);
    EXPECT_FALSE(stats.flipMeasured);
    EXPECT_GT(stats.flip, 0.0f);
    EXPECT_LE(stats.flip, 0.1f);
    EXPECT_EQ(stats.samples, view.samples);
}

TEST(Fidelity, APictureOfSmallFurIsMadeOfFewHairs) {
    Renderer renderer;
    const Document document = test::furryBall(20000);
    View view = viewOf(document, 12.0f);
    view.detail = kAll;
    const std::size_t all = drawFinished(renderer, document, view).hairsTried;
    view.detail = flipOf(0.05f);
    const FrameStats stats = drawFinished(renderer, document, view);
    EXPECT_LT(10 * stats.hairsTried, all);
    EXPECT_EQ(stats.deviation, kCoarsest);  // and no coarser than that
}

}  // namespace
}  // namespace pelage
