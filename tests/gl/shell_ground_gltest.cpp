// shell_ground_gltest.cpp -- how shells stand on skins that bend and on bumpy ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/skin_levels.h"
#include "tests/figures.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

constexpr int kSide = 160;  // pixels

// A ball under black hair of half its radius, combed down along it.
Document combedBall(Source ball, float lying) {
    Document document = test::evenDocument(std::move(ball));
    document.fur.hairs = 40000;
    document.fur.share = 1.0f;
    document.fur.gravity = 0.0f;
    Coat& coat = document.fur.over;
    coat.ambient = coat.diffuse = coat.specular = vec3(0.0f);
    coat.relativeLength = coat.directionWeight = 1.0f;
    coat.endRandomness = 0.0f;
    coat.width = 0.01f;
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const vec3 n = glm::normalize(document.skin->vertices[v].position);
        const vec3 down = vec3(0.0f, -1.0f, 0.0f) + n.y * n;
        document.groom.fur.edit(v) = {glm::normalize(n + lying * down), 0.5f, vec3(1.0f), 1.0f};
    }
    return document;
}

// Share of each pixel that the ball or its hair covers.
std::vector<float> covered(const Document& document, Shells shells) {
    Renderer renderer;
    View view = test::ballView(document, kSide);
    view.camera.distance *= 1.6f;
    view.detail.rule = Detail::Rule::all;
    view.background = vec3(1.0f);
    view.showSkin = false;
    view.samples = 8;
    view.shells = shells;
    std::vector<float> shares;
    const std::vector<float> light = test::linear(test::picture(renderer, document, view));
    for (std::size_t i = 0; i < light.size(); i += 3) shares.push_back(1.0f - light[i]);
    return shares;
}

double sum(const std::vector<float>& shares) {
    double result = 0.0;
    for (const float share : shares) result += static_cast<double>(share);
    return result;
}

TEST(ShellGround, StraightHairLeavesASkinThatBendsAway) {
    double worst = 0.0;
    for (const float lying : {0.0f, 1.0f, 2.5f}) {
        const Document document = combedBall(test::ball(5), lying);
        const double strands = sum(covered(document, Shells::none));
        const double shells = sum(covered(document, Shells::swept));
        std::printf("lying %.1f: shells cover %.4f of what strands do\n",
                    static_cast<double>(lying), shells / strands);
        worst = std::max(worst, std::abs(shells / strands - 1.0));
    }
    EXPECT_LT(worst, 0.03);
}

// Bumps a twenty-fifth as high as its hair is long, whose normals lie anywhere.
TEST(ShellGround, BumpsSmallerThanItDoNotPartTheFur) {
    Source ball = test::ball(6);
    for (std::size_t v = 0; v < ball.positions.size(); ++v)
        ball.positions[v] *= 1.0f + 0.02f * std::sin(97.0f * static_cast<float>(v));
    const Document document = combedBall(std::move(ball), 1.0f);
    const std::vector<float> strands = covered(document, Shells::none);
    const std::vector<float> shells = covered(document, Shells::swept);
    std::printf("bumpy: shells cover %.4f of what strands do\n", sum(shells) / sum(strands));
    EXPECT_NEAR(sum(shells) / sum(strands), 1.0, 0.05);
    uint holes = 0, inside = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const std::size_t i = static_cast<std::size_t>(y * kSide + x);
            if (!(strands[i] > 0.9f)) continue;
            ++inside;
            holes += shells[i] < 0.3f ? 1u : 0u;
        }
    std::printf("%u of %u pixels have no hair\n", holes, inside);
    EXPECT_LT(holes, inside / 50);
}

TEST(ShellGround, TheSurfaceOverTheFurMissesTheSkinByNoMoreThanIsAsked) {
    const Document document = test::evenDocument(test::ball(6));
    const Skin& skin = *document.skin;
    Mirror mirror;
    mirror.update(document);
    for (const float error : {0.002f, 0.01f, 0.05f}) {
        const int level = levelWithin(skin, error);
        const Mirror::Surface& surface = mirror.surfaceWithin(error, true);
        if (level == kNoLevel) {
            EXPECT_EQ(&surface, &mirror.surface());
            continue;
        }
        const SkinLevel wanted = makeSkinLevel(skin, level);
        EXPECT_LE(wanted.error, error);
        EXPECT_EQ(surface.patches.order, wanted.patches.order);
    }
    EXPECT_LT(mirror.surfaceWithin(0.05f, true).patches.order.size(),
              mirror.surface().patches.order.size() / 4);
}

TEST(ShellGround, TheUsualHairIsTheMedianOfWhatIsLongestHereAndThere) {
    Document document = test::evenDocument(test::ball(5));
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.fur.edit(v).furLength = v == 7 ? 5.0f : 0.25f;
    Mirror mirror;
    mirror.update(document);
    EXPECT_EQ(mirror.longestHair(), 5.0f);
    EXPECT_EQ(mirror.usualHair(), 0.25f);
}

}  // namespace
}  // namespace pelage
