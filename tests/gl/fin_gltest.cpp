// fin_gltest.cpp -- fins stand on the silhouette, are of the hair of shells, and cost nothing until
// they are asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

// A ball of radius 1 m seen without perspective, in shells.
View shellView(const Document& ball, int side) {
    View view = test::ballView(ball, side);
    view.camera.orthographic = true;
    view.shells = Shells::swept;
    return view;
}

View finned(View view) {
    view.over = view.under = DrawnAs::fins;
    return view;
}

Document furryBall(int times, uint hairs) {
    Document document = test::evenDocument(test::ball(times));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 0.0f, 0.5f), 0.2f, vec3(1.0f), 1.0f});
    document.fur.hairs = hairs;
    return document;
}

std::vector<float> light(Renderer& renderer, const Document& document, const View& view) {
    return test::linear(test::picture(renderer, document, view));
}

float pixelsPerMetre(const View& view) {
    return 0.5f * static_cast<float>(view.size.y) /
           (view.camera.distance * std::tan(0.5f * view.camera.fieldOfView));
}

// m in the picture from its middle, of a pixel.
float fromMiddle(const View& view, std::size_t pixel) {
    const auto side = static_cast<std::size_t>(view.size.x);
    const vec2 at(pixel % side, pixel / side);
    return glm::length(at + 0.5f - 0.5f * vec2(view.size)) / pixelsPerMetre(view);
}

// An edge has a fin where its normal's cosine with the view is less than 0.35: further than
// sqrt(1 - 0.35^2) = 0.94 m from the middle, from where hair of 0.2 m reaches inwards by as much.
TEST(Fins, ChangeThePictureNearTheSilhouetteOnly) {
    const Document ball = furryBall(3, 20000);
    Renderer renderer;
    const View view = shellView(ball, 128);
    const std::vector<float> without = light(renderer, ball, view);
    const std::vector<float> with = light(renderer, ball, finned(view));
    std::size_t changed = 0;
    for (std::size_t i = 0; i < with.size() / 3; ++i) {
        if (with[3 * i] == without[3 * i]) continue;
        ++changed;
        EXPECT_GT(fromMiddle(view, i), 0.7f);
    }
    EXPECT_GT(changed, 100u);
}

TEST(Fins, OfASkinThatFacesTheEyeAreNone) {
    Document sheet = test::lyingHair(2000);
    Renderer renderer;
    View view = finned(test::viewFromAbove(160));
    view.shells = Shells::swept;
    EXPECT_EQ(renderer.draw(sheet, view).fins, 0u);
    view.camera.pitch = 0.1f;  // a sheet of 8 x 8 cells has 208 edges, and two coats
    EXPECT_EQ(renderer.draw(sheet, view).fins, 416u);
}

struct Weighed {
    float weight, width;
};

// At 4096 cosines from -0.5 to 0.5, for hair of rank 0.5.
std::vector<Weighed> weights() {
    constexpr uint kCount = 4096;
    const gl::ProgramName program =
        test::computeProgram(test::shaderHead({"frame.glsl", "fin.glsl"}) + R"(
layout(local_size_x = 64) in;
layout(std430, binding = 8) buffer Results { vec2 results[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    float weight = finWeight(float(i) / 4095.0 - 0.5);
    results[i] = vec2(weight, finWidth(weight, 0.5));
})");
    gl::Buffer results;
    results.resize(kCount * sizeof(Weighed));
    results.bindStorage(8);
    glUseProgram(program.name());
    glDispatchCompute(kCount / 64, 1, 1);
    return test::valuesOf<Weighed>(results.name(), kCount);
}

TEST(Fins, WeightIsContinuousInTheAngle) {
    const std::vector<Weighed> all = weights();
    EXPECT_EQ(all.front().weight, 0.0f);
    EXPECT_EQ(all.back().weight, 0.0f);
    EXPECT_EQ(all[614].weight, 0.0f);  // cosine -0.35
    EXPECT_GT(all[616].weight, 0.0f);
    EXPECT_NEAR(all[2048].weight, 1.0f, 1e-6f);
    EXPECT_EQ(all[2048].width, 1.0f);
    for (std::size_t i = 1; i < all.size(); ++i) {
        const float step = 1.0f / 4095.0f;
        const float slope = 1.5f / 0.35f;  // the greatest of smoothstep
        EXPECT_LE(std::abs(all[i].weight - all[i - 1].weight), 1.01f * slope * step);
        EXPECT_LE(std::abs(all[i].width - all[i - 1].width), 1.01f * 5.0f * slope * step);
    }
}

// Hairs come and go one by one: while the eye goes around a ball of few triangles, no step changes
// much more than the others.
TEST(Fins, ComeAndGoWithoutAJump) {
    const Document ball = furryBall(1, 8000);
    Renderer renderer;
    View view = finned(shellView(ball, 96));
    view.samples = 4;
    std::vector<double> steps;
    std::vector<float> before;
    for (int i = 0; i < 40; ++i) {
        view.camera.yaw = 0.004f * static_cast<float>(i);
        std::vector<float> now = light(renderer, ball, view);
        if (i > 0) steps.push_back(test::distanceOf(now, before));
        before = std::move(now);
    }
    std::ranges::sort(steps);
    std::printf("change from step to step: median %.4f, greatest %.4f\n", steps[steps.size() / 2],
                steps.back());
    EXPECT_LT(steps.back(), 1.5 * steps[steps.size() / 2]);
}

double rmse(Renderer& renderer, const Document& document, View view, const View& other) {
    const std::vector<float> one = light(renderer, document, view);
    return test::distanceOf(one, light(renderer, document, other));
}

// 80 triangles, each bent from the next by 18 to 23 degrees: what strands cover beyond the skin.
TEST(Fins, BringTheSilhouetteOfFewTrianglesNearerToStrands) {
    Document ball = furryBall(1, 30000);
    Renderer renderer;
    View view = shellView(ball, 160);
    View strands = view;
    strands.shells = Shells::none;
    const double whole = test::coveredPixels(renderer, ball, strands);
    const double without = test::coveredPixels(renderer, ball, view) / whole;
    const double with = test::coveredPixels(renderer, ball, finned(view)) / whole;
    view.samples = strands.samples = 4;
    const double errorWithout = rmse(renderer, ball, view, strands);
    const double errorWith = rmse(renderer, ball, finned(view), strands);
    std::printf("of what strands cover: shells %.4f, with fins %.4f; RMSE %.4f, %.4f\n", without,
                with, errorWithout, errorWith);
    EXPECT_LT(std::abs(with - 1.0), std::abs(without - 1.0));
    // Its hairs stand elsewhere than those of strands, so pixel by pixel it is hardly nearer.
    EXPECT_LT(errorWith, 1.02 * errorWithout);
}

// Where both show fur, a fin over a shell is the same fur.
TEST(Fins, KeepTheBrightnessInsideTheSilhouette) {
    const Document ball = furryBall(3, 60000);
    Renderer renderer;
    View view = shellView(ball, 160);
    view.samples = 4;
    const std::vector<float> without = light(renderer, ball, view);
    const std::vector<float> with = light(renderer, ball, finned(view));
    double before = 0.0, after = 0.0, ring = 0.0, ringAfter = 0.0;
    for (std::size_t i = 0; i < with.size() / 3; ++i) {
        const float far = fromMiddle(view, i);
        if (far > 0.98f) continue;  // the skin lies behind
        before += static_cast<double>(without[3 * i + 1]);
        after += static_cast<double>(with[3 * i + 1]);
        if (far < 0.85f) continue;
        ring += static_cast<double>(without[3 * i + 1]);
        ringAfter += static_cast<double>(with[3 * i + 1]);
    }
    std::printf("brightness with fins: %.4f of that without, %.4f near the silhouette\n",
                after / before, ringAfter / ring);
    EXPECT_NEAR(after / before, 1.0, 0.005);
    EXPECT_NEAR(ringAfter / ring, 1.0, 0.01);
}

TEST(Fins, CostNothingUntilTheyAreAskedFor) {
    const Document ball = furryBall(2, 2000);
    Renderer renderer;
    const View view = shellView(ball, 32);
    EXPECT_EQ(renderer.draw(ball, view).fins, 0u);
    const std::size_t bytes = renderer.bytes();
    EXPECT_GT(renderer.draw(ball, finned(view)).fins, 0u);
    // 480 edges; 8 bytes each, and 16 for a fin of each coat
    EXPECT_EQ(renderer.bytes(), bytes + 480 * 8 + 16 + 480 * 2 * 16);
    EXPECT_EQ(renderer.draw(ball, view).fins, 0u);
    View strands = finned(view);
    strands.shells = Shells::none;
    EXPECT_EQ(renderer.draw(ball, strands).fins, 0u);
}

TEST(Fins, OfOneCoatAreItsOwn) {
    const Document ball = furryBall(2, 2000);
    Renderer renderer;
    View view = shellView(ball, 32);
    const uint both = renderer.draw(ball, finned(view)).fins;
    view.under = DrawnAs::fins;
    EXPECT_EQ(2 * renderer.draw(ball, view).fins, both);
    view.over = DrawnAs::strands;
    EXPECT_EQ(2 * renderer.draw(ball, view).fins, both);
    view.showUnder = false;
    EXPECT_EQ(renderer.draw(ball, view).fins, 0u);
}

TEST(Fins, OddCasesAreDrawn) {
    Renderer renderer;
    const auto fins = [&](const Document& document, const View& view) {
        const FrameStats stats = renderer.draw(document, finned(view));
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return stats.fins;
    };
    Document ball = furryBall(2, 500);
    View view = shellView(ball, 24);
    Document bald = ball;
    bald.groom = test::evenGroom(*ball.skin, {vec3(0.0f), 0.0f, vec3(1.0f), 1.0f});
    EXPECT_EQ(fins(bald, view), 0u);
    bald.groom = test::evenGroom(*ball.skin, {vec3(0.0f), 0.2f, vec3(1.0f), 0.0f});
    EXPECT_EQ(fins(bald, view), 0u);
    ball.groom = test::evenGroom(*ball.skin, {vec3(0.0f, 0.5f, 0.5f), 4.0f, vec3(1.0f), 1.0f});
    EXPECT_GT(fins(ball, view), 0u);  // longer than the body
    view.camera.orthographic = false;
    view.camera.target = vec3(0.0f);  // from inside
    view.camera.distance = 0.2f;
    fins(ball, view);
    const vec3 a(-0.5f, 0.0f, 0.0f), b(0.5f, 0.0f, 0.0f), c(0.0f, 0.0f, -0.5f);
    View low = test::viewFromAbove(24);
    low.shells = Shells::swept;
    low.camera.pitch = 0.0f;
    EXPECT_EQ(fins(test::evenDocument(test::oneMesh({a, b, c}, {{0, 1, 2}})), low), 6u);
    // A needle, a point, three triangles at an edge, one of them twice, and a flipped one.
    fins(test::evenDocument(test::oneMesh({a, b, b + vec3(0.0f, 1e-6f, 0.0f)}, {{0, 1, 2}})), low);
    fins(test::evenDocument(test::oneMesh({a, a, a}, {{0, 1, 2}})), low);
    fins(test::evenDocument(test::oneMesh({a, b, c, -c, vec3(0.0f, 0.3f, 0.0f), a},
                                          {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 4}, {0, 5, 1}})),
         low);
}

}  // namespace
}  // namespace pelage
