// technique_gltest.cpp -- each coat in its own technique, and both in one picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

// A sheet seen from above, of as much red overcoat as green undercoat, which leans and is thin
// enough for the skin to be seen.
struct TwoCoats {
    Document document = test::lyingHair(6000);
    View view = test::viewFromAbove(96);

    TwoCoats() {
        document.groom = test::evenGroom(
            *document.skin, {glm::normalize(vec3(0.7f, 1.0f, 0.0f)), 0.2f, vec3(1.0f), 1.0f});
        document.fur.share = 0.5f;
        document.fur.over.rootColor = document.fur.over.tipColor = vec3(1.0f, 0.0f, 0.0f);
        document.fur.under.rootColor = document.fur.under.tipColor = vec3(0.0f, 1.0f, 0.0f);
        document.fur.over.style = document.fur.under.style = kStylePolyline;
        view.shells = Shells::swept;
        view.under = DrawnAs::strands;
    }
};

struct Pictures {
    test::Pixels both, over, under, skin;
};

Pictures picturesOf(Renderer& renderer, const TwoCoats& scene) {
    const auto shown = [&](bool over, bool under) {
        View view = scene.view;
        view.showOver = over;
        view.showUnder = under;
        return test::picture(renderer, scene.document, view);
    };
    return {shown(true, true), shown(true, false), shown(false, true), shown(false, false)};
}

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

bool alike(const test::Pixels& a, const test::Pixels& b, std::size_t at) {
    const auto from = static_cast<std::ptrdiff_t>(at);
    return std::equal(a.begin() + from, a.begin() + from + 4, b.begin() + from);
}

// Share of the pixels where both have hair that shows the overcoat's.
double overcoatInFront(const Pictures& pictures) {
    std::size_t met = 0, over = 0;
    for (std::size_t i = 0; i < pictures.both.size(); i += 4) {
        if (alike(pictures.over, pictures.skin, i) || alike(pictures.under, pictures.skin, i))
            continue;
        ++met;
        over += alike(pictures.both, pictures.over, i) ? 1 : 0;
    }
    EXPECT_GT(met, 500u);
    return static_cast<double>(over) / static_cast<double>(met);
}

TEST(Technique, EachPixelShowsOneCoatOrTheOther) {
    Renderer renderer;
    TwoCoats scene;
    for (const bool swapped : {false, true}) {
        if (swapped) std::swap(scene.view.over, scene.view.under);
        const Pictures pictures = picturesOf(renderer, scene);
        std::size_t over = 0, under = 0;
        for (std::size_t i = 0; i < pictures.both.size(); i += 4) {
            const bool noOver = alike(pictures.over, pictures.skin, i);
            const bool noUnder = alike(pictures.under, pictures.skin, i);
            const bool isOver = alike(pictures.both, pictures.over, i);
            const bool isUnder = alike(pictures.both, pictures.under, i);
            ASSERT_TRUE(noOver ? isUnder : noUnder ? isOver : isOver || isUnder) << i / 4;
            over += isOver && !isUnder ? 1 : 0;
            under += isUnder && !isOver ? 1 : 0;
        }
        EXPECT_GT(over, 500u);
        EXPECT_GT(under, 500u);
    }
}

// Of hair that leans the longer one lies above the shorter one nearly everywhere.
TEST(Technique, TheNearerHairIsSeenWhicheverTechniqueItHas) {
    Renderer renderer;
    TwoCoats scene;
    for (const bool swapped : {false, true}) {
        if (swapped) std::swap(scene.view.over, scene.view.under);
        scene.document.fur.over.relativeLength = 1.0f;
        scene.document.fur.under.relativeLength = 0.2f;
        EXPECT_GT(overcoatInFront(picturesOf(renderer, scene)), 0.75);
        std::swap(scene.document.fur.over.relativeLength, scene.document.fur.under.relativeLength);
        EXPECT_LT(overcoatInFront(picturesOf(renderer, scene)), 0.25);
    }
}

TEST(Technique, ACoatIsBuiltInItsOwnTechniqueOnly) {
    Renderer renderer;
    TwoCoats scene;
    const FrameStats mixed = renderer.draw(scene.document, scene.view);
    EXPECT_GT(mixed.shellSeconds, 0.0);
    EXPECT_GT(mixed.textureBytes, 0u);

    scene.view.over = DrawnAs::strands;
    const FrameStats strands = renderer.draw(scene.document, scene.view);
    EXPECT_EQ(strands.shellSeconds, 0.0);
    EXPECT_EQ(strands.textureBytes, 0u);
    scene.view.showOver = false;
    const FrameStats under = renderer.draw(scene.document, scene.view);
    EXPECT_GT(mixed.hairsDrawn, 0u);
    EXPECT_LE(mixed.hairsDrawn, under.hairsDrawn);  // shells hide some of them
    EXPECT_LT(under.hairsDrawn, 0.6 * static_cast<double>(strands.hairsDrawn));

    scene.view.showOver = true;
    scene.view.over = scene.view.under = DrawnAs::shells;
    const FrameStats shells = renderer.draw(scene.document, scene.view);
    EXPECT_EQ(shells.hairsTried + shells.hairsDrawn + shells.segmentsDrawn, 0u);
    EXPECT_GT(shells.shellSeconds, 0.0);
}

TEST(Technique, LinesLieOnTheSkinUnderShellsToo) {
    Renderer renderer;
    TwoCoats scene;
    scene.view.over = scene.view.under = DrawnAs::shells;
    const test::Pixels without = test::picture(renderer, scene.document, scene.view);
    const OverlayLine line{vec3(-0.4f, 1e-3f, 0.0f), vec3(0.4f, 1e-3f, 0.0f),
                           vec4(0.0f, 0.0f, 1.0f, 1.0f)};
    scene.view.lines = {&line, 1};
    const test::Pixels with = test::picture(renderer, scene.document, scene.view);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < with.size(); i += 4) changed += alike(with, without, i) ? 0 : 1;
    EXPECT_GE(changed, 60u);  // it is 64 pixels long
}

// Half as many pixels each way: where the light is changes by less than a pixel.
TEST(Technique, ShellsThatTakeTooLongHaveFewerPixels) {
    Renderer renderer;
    TwoCoats scene;
    scene.view.over = scene.view.under = DrawnAs::shells;
    const test::Pixels sharp = test::picture(renderer, scene.document, scene.view);
    scene.view.detail.milliseconds = 1e-3f;
    renderer.draw(scene.document, scene.view);
    scene.view.camera.distance *= 1.0f + 1e-6f;  // another picture
    const test::Pixels coarse = test::picture(renderer, scene.document, scene.view);
    const auto steps = [](const test::Pixels& pixels) {
        long sum = 0;
        for (std::size_t i = 4; i < pixels.size(); ++i) sum += std::abs(pixels[i] - pixels[i - 4]);
        return sum;
    };
    EXPECT_LT(2 * steps(coarse), steps(sharp) * 3 / 2);
    EXPECT_NEAR(mean(test::linear(coarse)), mean(test::linear(sharp)), 0.01);
}

// So dense that from so far away shells cost less than the strands they stand for.
TwoCoats denseCoats(float away) {
    TwoCoats scene;
    scene.document.fur.hairs = 400000;
    scene.view.over = scene.view.under = DrawnAs::automatic;
    scene.view.detail = {Detail::Rule::share, 1.0f, 0.0f};
    scene.view.samples = 16;
    scene.view.camera.distance *= away;
    return scene;
}

TEST(Technique, AutomaticIsStrandsCloseByAndShellsAfar) {
    Renderer renderer;
    TwoCoats scene = denseCoats(1.0f);
    const float framed = scene.view.camera.distance;
    float before = 0.0f;
    for (float step = 0.0f; step < 5.0f; step += 0.1f) {
        scene.view.camera.distance = framed * std::exp2(step - 3.0f);
        const vec2 shares = renderer.draw(scene.document, scene.view).inShells;
        if (step == 0.0f) {
            EXPECT_EQ(shares, vec2(0.0f));
        }
        EXPECT_GE(shares.y, before - 0.04f);
        EXPECT_LE(shares.y, before + 0.35f);
        before = shares.y;
    }
    EXPECT_EQ(before, 1.0f);
    scene.view.detail.rule = Detail::Rule::all;
    EXPECT_EQ(renderer.draw(scene.document, scene.view).inShells, vec2(0.0f));
}

// Each sample is of one technique, so a part of them is a part of the mean.
TEST(Technique, APictureInPartInShellsIsTheMeanOfBoth) {
    Renderer renderer;
    TwoCoats scene = denseCoats(1.0f);
    const float framed = scene.view.camera.distance;
    scene.view.showOver = false;
    float share = 0.0f;
    for (float step = 0.0f; step < 4.0f && !(share > 0.3f && share < 0.7f); step += 0.05f) {
        scene.view.camera.distance = framed * std::exp2(step - 3.0f);
        share = renderer.draw(scene.document, scene.view).inShells.y;
    }
    ASSERT_GT(share, 0.3f);
    ASSERT_LT(share, 0.7f);
    const auto light = [&](DrawnAs as) {
        scene.view.under = as;
        return test::linear(test::picture(renderer, scene.document, scene.view));
    };
    const double shells = mean(light(DrawnAs::shells)), strands = mean(light(DrawnAs::strands));
    const auto part = static_cast<double>(share);
    EXPECT_GT(std::abs(shells - strands), 1e-3);
    EXPECT_NEAR(mean(light(DrawnAs::automatic)), part * shells + (1.0 - part) * strands,
                0.1 * std::abs(shells - strands) + 1e-4);
}

// What is measured has the last word: shells that break the FLIP that is asked for are given up.
TEST(Technique, AutomaticKeepsTheFlipThatIsAskedFor) {
    Renderer renderer;
    TwoCoats scene = denseCoats(2.0f);
    scene.document.fur.hairs = 2000000;
    scene.view.samples = 1;  // in shells entirely from a half on
    float most = 0.0f;
    for (const float asked : {0.2f, 0.125f}) {
        scene.view.detail = {Detail::Rule::flip, asked, 0.0f};
        const FrameStats stats = drawFinished(renderer, scene.document, scene.view);
        std::printf("FLIP %.2f asked, %.4f reached, %.2f and %.2f in shells\n",
                    static_cast<double>(asked), static_cast<double>(stats.flip),
                    static_cast<double>(stats.inShells.x), static_cast<double>(stats.inShells.y));
        EXPECT_TRUE(stats.flipMeasured);
        EXPECT_LE(stats.flip, asked);
        most = std::max(most, stats.inShells.y);
    }
    EXPECT_GT(most, 0.3f);
}

}  // namespace
}  // namespace pelage
