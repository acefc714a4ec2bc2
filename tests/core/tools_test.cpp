// tools_test.cpp -- the promises of tools.h: each tool at one vertex.
#include "core/tools.h"

#include <gtest/gtest.h>

#include <cmath>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::kAllTools;
using test::kUp;

constexpr uint kVertex = 7;

// A sheet that faces up, and what a tool makes of one of its vertices.
struct OneVertex : Canvas {
    explicit OneVertex(mat4 toWorld = mat4(1.0f)) : Canvas(test::sheet(4, toWorld)) {}

    vec3 offset{0.0f};  // from the path

    FurVertex& fur() { return groom.fur.edit(kVertex); }
    FurVertex after(const Brush& brush, float coverage, vec3 path = vec3(0.0f),
                    FurVertex around = {}) const {
        return brushedFur(*skin, groom, brush, kVertex, {coverage, coverage, path, offset, around});
    }
    float maskAfter(const Brush& brush, float coverage) const {
        return brushedMask(groom, brush, kVertex, {coverage, coverage, {}, {}, {}});
    }
};

Brush halfBrush(Tool tool, Mode mode = Mode::add) { return brushOf(tool, mode, 0.2f, 0.5f); }

TEST(Tools, LengthGrowsOrShrinksByTheShareOfFourPercentOfTheSize) {
    OneVertex one;
    const float before = one.fur().furLength, step = 0.5f * 0.8f * 0.04f * one.skin->size();
    EXPECT_FLOAT_EQ(one.after(halfBrush(Tool::length), 0.8f).furLength, before + step);
    EXPECT_FLOAT_EQ(one.after(halfBrush(Tool::length, Mode::subtract), 0.8f).furLength,
                    before - step);
}

TEST(Tools, SetTendsToTheValueByTheShare) {
    OneVertex one;
    one.fur().furLength = 0.05f;
    one.fur().density = 1.0f;
    one.groom.mask.edit(kVertex) = 0.0f;
    EXPECT_FLOAT_EQ(one.after(halfBrush(Tool::length, Mode::set), 0.8f).furLength,
                    0.6f * 0.05f + 0.4f * 0.25f);
    EXPECT_FLOAT_EQ(one.after(halfBrush(Tool::density, Mode::set), 0.8f).density,
                    0.6f * 1.0f + 0.4f * 0.25f);
    EXPECT_FLOAT_EQ(one.maskAfter(halfBrush(Tool::mask, Mode::set), 0.8f), 0.4f * 0.25f);
}

TEST(Tools, DensityAndMaskGoUpOrDownByTheShareAndStayInRange) {
    OneVertex one;
    one.fur().density = 0.5f;
    EXPECT_FLOAT_EQ(one.after(halfBrush(Tool::density), 0.8f).density, 0.9f);
    EXPECT_FLOAT_EQ(one.after(halfBrush(Tool::density, Mode::subtract), 0.8f).density, 0.1f);
    EXPECT_EQ(one.after(brushOf(Tool::density), 0.8f).density, 1.0f);
    EXPECT_EQ(one.after(brushOf(Tool::density, Mode::subtract), 0.8f).density, 0.0f);
    one.groom.mask.edit(kVertex) = 0.5f;
    EXPECT_FLOAT_EQ(one.maskAfter(halfBrush(Tool::mask), 0.8f), 0.9f);
    EXPECT_FLOAT_EQ(one.maskAfter(halfBrush(Tool::mask, Mode::subtract), 0.8f), 0.1f);
    EXPECT_EQ(one.maskAfter(brushOf(Tool::mask), 0.8f), 1.0f);
    EXPECT_EQ(one.maskAfter(brushOf(Tool::mask, Mode::subtract), 0.8f), 0.0f);
}

TEST(Tools, CombTendsToThePathOnTheTangentPlaneAndKeepsTheLength) {
    OneVertex one;
    one.fur().direction = vec3(0.0f, 0.0f, 0.5f);
    // The length of the path does not count, nor its part along the normal.
    const vec3 path(300.0f, 400.0f, 0.0f), along(1.0f, 0.0f, 0.0f);
    for (const float coverage : {0.25f, 1.0f}) {
        const FurVertex with = one.after(brushOf(Tool::comb), coverage, path);
        const FurVertex against = one.after(brushOf(Tool::comb, Mode::subtract), coverage, path);
        const vec3 rest = (1.0f - coverage) * one.fur().direction;
        EXPECT_LT(glm::distance(with.direction, rest + coverage * along), 1e-6f);
        EXPECT_LT(glm::distance(against.direction, rest - coverage * along), 1e-6f);
        EXPECT_EQ(with.furLength, one.fur().furLength);
    }
}

TEST(Tools, CombDoesNothingWithoutAPathOnTheTangentPlane) {
    OneVertex one;
    for (const vec3 path : {vec3(0.0f), 3.0f * kUp, vec3(NAN), vec3(INFINITY)})
        EXPECT_EQ(one.after(brushOf(Tool::comb), 1.0f, path), one.fur());
}

TEST(Tools, SmoothTendsToTheMeanByTheShare) {
    OneVertex one;
    const FurVertex before = one.fur(), mean{vec3(0.3f, 0.0f, 0.1f), 0.2f, vec3(1.0f), 0.9f};
    const FurVertex after = one.after(halfBrush(Tool::smooth), 0.5f, vec3(0.0f), mean);
    EXPECT_FLOAT_EQ(after.furLength, glm::mix(before.furLength, mean.furLength, 0.25f));
    EXPECT_FLOAT_EQ(after.density, glm::mix(before.density, mean.density, 0.25f));
    EXPECT_LT(glm::distance(after.direction, glm::mix(before.direction, mean.direction, 0.25f)),
              1e-6f);
}

// A sheet that is 2, 2 and 3 times as large as its mesh.
mat4 scaled() {
    mat4 matrix(1.0f);
    matrix[0].x = matrix[1].y = 2.0f;
    matrix[2].z = 3.0f;
    return matrix;
}

TEST(Tools, CutShortensByTheShareAndNeverLengthens) {
    for (const mat4& toWorld : {mat4(1.0f), scaled()}) {
        OneVertex one(toWorld);
        const float scale = one.skin->frames[0].scale;
        Brush brush = halfBrush(Tool::cut, Mode::set);
        brush.value = 0.1f;
        one.fur().furLength = 0.5f / scale;
        EXPECT_FLOAT_EQ(one.after(brush, 0.8f).furLength * scale, 0.6f * 0.5f + 0.4f * 0.1f);
        one.fur().furLength = 0.1f / scale;
        EXPECT_FLOAT_EQ(one.after(brush, 1.0f).furLength * scale, 0.1f);
        one.fur().furLength = 0.09f / scale;
        EXPECT_EQ(one.after(brush, 1.0f), one.fur());
    }
}

TEST(Tools, PuffStandsTheHairUpByTheShareAndSubtractLaysItDown) {
    OneVertex one;
    one.fur().direction = vec3(0.3f, 0.4f, 0.0f);
    EXPECT_LT(glm::distance(one.after(halfBrush(Tool::puff), 0.5f).direction,
                            0.75f * one.fur().direction),
              1e-6f);
    EXPECT_EQ(one.after(brushOf(Tool::puff), 1.0f).direction, vec3(0.0f));
    const vec3 down = one.after(brushOf(Tool::puff, Mode::subtract), 1.0f).direction;
    EXPECT_LT(glm::distance(down, vec3(1.0f, 0.0f, 0.0f)), 1e-6f);
}

TEST(Tools, FlattenKeepsTheHeadingAndSubtractStandsTheHairUp) {
    for (const mat4& toWorld : {mat4(1.0f), scaled()}) {
        OneVertex one(toWorld);
        one.fur().direction = vec3(0.1f, 0.2f, -0.1f);
        const vec3 heading = glm::normalize(vec3(0.1f, 0.0f, -0.1f) * glm::mat3(toWorld));
        const FurVertex flat =
            furToWorld(*one.skin, kVertex, one.after(brushOf(Tool::flatten), 1.0f));
        EXPECT_LT(glm::length(glm::cross(flat.direction, heading)), 1e-6f);
        EXPECT_GT(glm::dot(flat.direction, heading), 0.6f);
        if (toWorld == mat4(1.0f)) {
            EXPECT_NEAR(glm::length(flat.direction), 1.0f, 1e-6f);
            const vec3 half = one.after(halfBrush(Tool::flatten), 1.0f).direction;
            EXPECT_LT(glm::distance(half, glm::mix(one.fur().direction, heading, 0.5f)), 1e-6f);
        }
        EXPECT_EQ(one.after(brushOf(Tool::flatten, Mode::subtract), 1.0f).direction, vec3(0.0f));
    }
    OneVertex upright;
    upright.fur().direction = vec3(0.0f);
    EXPECT_EQ(upright.after(brushOf(Tool::flatten), 1.0f), upright.fur());
}

TEST(Tools, PartPointsAwayFromThePathInTheTangentPlane) {
    OneVertex one;
    one.fur().direction = vec3(0.0f, 0.0f, 0.5f);
    one.offset = vec3(-0.05f, 0.3f, 0.0f);  // the part along the normal does not count
    const vec3 away(-1.0f, 0.0f, 0.0f);
    for (const float share : {0.25f, 1.0f}) {
        const vec3 rest = (1.0f - share) * one.fur().direction;
        EXPECT_LT(
            glm::distance(one.after(brushOf(Tool::part), share).direction, rest + share * away),
            1e-6f);
        EXPECT_LT(glm::distance(one.after(brushOf(Tool::part, Mode::subtract), share).direction,
                                rest - share * away),
                  1e-6f);
    }
    // Within a tenth of the radius, 0.02 m, it stands up the more.
    one.offset = vec3(-0.005f, 0.0f, 0.0f);
    EXPECT_LT(glm::distance(one.after(brushOf(Tool::part), 1.0f).direction, 0.25f * away), 1e-6f);
    one.offset = vec3(0.0f);
    EXPECT_EQ(one.after(brushOf(Tool::part), 1.0f).direction, vec3(0.0f));
}

TEST(Tools, TwistTurnsAboutTheNormalByTheShareOfAQuarterTurn) {
    OneVertex one;
    one.fur().direction = vec3(0.5f, 0.2f, 0.0f);
    // Seen from outside, from above, the left of +x is -z.
    EXPECT_LT(
        glm::distance(one.after(brushOf(Tool::twist), 1.0f).direction, vec3(0.0f, 0.2f, -0.5f)),
        1e-6f);
    EXPECT_LT(glm::distance(one.after(brushOf(Tool::twist, Mode::subtract), 1.0f).direction,
                            vec3(0.0f, 0.2f, 0.5f)),
              1e-6f);
    const float angle = 0.25f * 1.57079633f, half = 0.5f;
    EXPECT_LT(glm::distance(one.after(halfBrush(Tool::twist), half).direction,
                            vec3(0.5f * std::cos(angle), 0.2f, -0.5f * std::sin(angle))),
              1e-6f);
    const FurVertex mirrored =
        brushedFur(*one.skin, one.groom, brushOf(Tool::twist), kVertex, {1.0f, -1.0f, {}, {}, {}});
    EXPECT_LT(glm::distance(mirrored.direction, vec3(0.0f, 0.2f, 0.5f)), 1e-6f);
}

TEST(Tools, ClumpLeansTowardsThePathByDistanceOverLength) {
    OneVertex one;
    one.fur().direction = vec3(0.4f, 0.0f, 0.5f);
    one.fur().furLength = 0.2f;
    one.offset = vec3(0.05f, 0.0f, 0.0f);
    EXPECT_LT(
        glm::distance(one.after(brushOf(Tool::clump), 1.0f).direction, vec3(-0.25f, 0.0f, 0.5f)),
        1e-6f);
    EXPECT_LT(glm::distance(one.after(brushOf(Tool::clump, Mode::subtract), 1.0f).direction,
                            vec3(0.25f, 0.0f, 0.5f)),
              1e-6f);
    EXPECT_LT(
        glm::distance(one.after(halfBrush(Tool::clump), 1.0f).direction, vec3(0.075f, 0.0f, 0.5f)),
        1e-6f);
    one.fur().furLength = 0.01f;  // too short to meet: leans in full
    EXPECT_NEAR(one.after(brushOf(Tool::clump), 1.0f).direction.x, -1.0f / std::sqrt(1.25f), 1e-6f);
    one.offset = vec3(0.0f);
    EXPECT_EQ(one.after(brushOf(Tool::clump), 1.0f), one.fur());
}

TEST(Tools, TintTendsToTheColorAndBackToOne) {
    OneVertex one;
    one.fur().tint = vec3(0.5f, 1.0f, 0.0f);
    const vec3 color(0.75f, 0.5f, 0.25f);
    EXPECT_LT(glm::distance(one.after(halfBrush(Tool::tint), 0.5f).tint,
                            glm::mix(one.fur().tint, color, 0.25f)),
              1e-6f);
    EXPECT_LT(glm::distance(one.after(halfBrush(Tool::tint, Mode::subtract), 0.5f).tint,
                            glm::mix(one.fur().tint, vec3(1.0f), 0.25f)),
              1e-6f);
    EXPECT_EQ(one.after(brushOf(Tool::tint, Mode::subtract), 1.0f).tint, vec3(1.0f));
}

TEST(Tools, SmoothTendsToTheMeanTint) {
    OneVertex one;
    FurVertex around = one.fur();
    around.tint = vec3(0.2f, 0.4f, 0.6f);
    EXPECT_LT(glm::distance(one.after(halfBrush(Tool::smooth), 0.5f, {}, around).tint,
                            glm::mix(one.fur().tint, around.tint, 0.25f)),
              1e-6f);
}

TEST(Tools, TheMaskHoldsBackAllButTheMaskTool) {
    OneVertex one;
    const FurVertex around{vec3(0.3f, 0.0f, 0.1f), 0.2f, vec3(1.0f), 0.9f};
    const vec3 path(1.0f, 0.0f, 0.0f);
    one.fur().direction = vec3(0.2f, 0.1f, 0.4f);
    one.fur().tint = vec3(0.3f);
    one.offset = vec3(0.1f, 0.0f, 0.0f);
    const FurVertex before = one.fur();
    for (const Tool tool : kAllTools) {
        if (tool == Tool::mask || tool == Tool::segment) continue;
        const Brush brush = brushOf(tool, Mode::subtract);
        one.groom.mask.edit(kVertex) = 0.0f;
        const FurVertex bare = one.after(brush, 1.0f, path, around);
        EXPECT_FALSE(bare == before) << toolInfo(tool).name;
        one.groom.mask.edit(kVertex) = 0.75f;
        const FurVertex held = one.after(brush, 1.0f, path, around);
        EXPECT_FLOAT_EQ(held.furLength, glm::mix(bare.furLength, before.furLength, 0.75f));
        EXPECT_FLOAT_EQ(held.density, glm::mix(bare.density, before.density, 0.75f));
        EXPECT_LT(glm::distance(held.direction, glm::mix(bare.direction, before.direction, 0.75f)),
                  1e-6f);
        EXPECT_LT(glm::distance(held.tint, glm::mix(bare.tint, before.tint, 0.75f)), 1e-6f);
        one.groom.mask.edit(kVertex) = 1.0f;
        EXPECT_EQ(one.after(brush, 1.0f, path, around), before);
    }
    EXPECT_EQ(one.maskAfter(brushOf(Tool::mask, Mode::subtract), 0.75f), 0.25f);
}

TEST(Tools, OnlyTheMaskToolChangesTheMaskAndItNothingElse) {
    OneVertex one;
    one.groom.mask.edit(kVertex) = 0.25f;
    for (const Tool tool : kAllTools)
        EXPECT_EQ(one.maskAfter(brushOf(tool), 0.5f), tool == Tool::mask ? 0.75f : 0.25f);
    EXPECT_EQ(one.after(brushOf(Tool::mask), 1.0f), one.fur());
}

}  // namespace
}  // namespace pelage
