// brush_test.cpp -- what each tool does to the hair under it.
#include "core/brush.h"

#include <gtest/gtest.h>

#include <cmath>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::kAllTools;
using test::kUp;
using test::shuffle;
using test::straight;

TEST(Falloff, IsOneInTheMiddleAndZeroFromTheRadiusOn) {
    for (const Falloff falloff :
         {Falloff::smooth, Falloff::linear, Falloff::sharp, Falloff::constant}) {
        EXPECT_EQ(falloffWeight(falloff, 0.0f, 0.3f), 1.0f);
        EXPECT_EQ(falloffWeight(falloff, 0.3f, 0.3f), 0.0f);
        EXPECT_EQ(falloffWeight(falloff, 9.0f, 0.3f), 0.0f);
        float last = 1.0f;
        for (int i = 0; i <= 100; ++i) {
            const float weight = falloffWeight(falloff, 0.003f * static_cast<float>(i), 0.3f);
            EXPECT_LE(weight, last);
            EXPECT_GE(weight, 0.0f);
            last = weight;
        }
    }
}

TEST(Tools, TableIsInTheOrderOfTheTools) {
    ASSERT_EQ(tools().size(), kAllTools.size());
    for (const Tool tool : kAllTools) EXPECT_EQ(toolInfo(tool).tool, tool);
    EXPECT_EQ(modeNames().size(), 4u);
    EXPECT_EQ(falloffNames().size(), 4u);
}

TEST(Brush, LengthGrowsByFourPercentOfTheSizeAtFullStrength) {
    const Canvas canvas(test::sheet(30));
    const Groom longer = canvas.painted(brushOf(Tool::length), {vec3(0.0f)});
    const Groom shorter = canvas.painted(brushOf(Tool::length, Mode::subtract), {vec3(0.0f)});
    std::vector<uint> middle;
    canvas.query.within(vec3(0.0f), 1e-5f, middle);
    ASSERT_EQ(middle.size(), 1u);
    EXPECT_NEAR(longer.fur[middle[0]].furLength, 0.04f + 0.04f * canvas.skin->size(), 1e-6f);
    EXPECT_EQ(shorter.fur[middle[0]].furLength, 0.0f);
}

TEST(Brush, SetReachesTheValue) {
    const Canvas canvas(test::sheet(30));
    for (const Tool tool : {Tool::length, Tool::density, Tool::mask}) {
        Brush brush = brushOf(tool, Mode::set);
        brush.falloff = Falloff::constant;
        const Groom after = canvas.painted(brush, {vec3(0.0f)});
        std::vector<uint> found;
        canvas.query.within(vec3(0.0f), 0.19f, found);
        ASSERT_FALSE(found.empty());
        for (const uint v : found) {
            const float value = tool == Tool::length    ? after.fur[v].furLength
                                : tool == Tool::density ? after.fur[v].density
                                                        : after.mask[v];
            EXPECT_EQ(value, 0.25f);
        }
    }
}

TEST(Brush, LengthsAreWorldLengthsWhateverTheMeshSpace) {
    // The mesh is stored ten times as large and turned.
    mat4 toWorld(0.1f);
    toWorld[0] = {0, 0, -0.1f, 0};
    toWorld[2] = {0.1f, 0, 0, 0};
    toWorld[3] = {0, 0, 0, 1};
    const Canvas canvas(test::sheet(20, toWorld));
    Brush brush = brushOf(Tool::length, Mode::set, 0.02f);
    brush.value = 0.03f;
    brush.falloff = Falloff::constant;
    const Groom after = canvas.painted(brush, {vec3(0.0f)});
    std::vector<uint> found;
    canvas.query.within(vec3(0.0f), 0.019f, found);
    ASSERT_FALSE(found.empty());
    for (const uint v : found) EXPECT_NEAR(after.fur[v].furLength, 0.3f, 1e-6f);

    brush = brushOf(Tool::comb, Mode::add, 0.02f);
    const Groom combed = canvas.painted(brush, straight({0, 0, 0}, {0.02f, 0, 0}, 3));
    std::size_t changed = 0;
    for (const uint v : found) {
        if (combed.fur[v] == canvas.groom.fur[v]) continue;
        ++changed;
        const vec3 direction = furToWorld(*canvas.skin, v, combed.fur[v]).direction;
        const vec3 before = furToWorld(*canvas.skin, v, canvas.groom.fur[v]).direction;
        EXPECT_GT(direction.x, before.x);
    }
    EXPECT_GT(changed, 0u);
}

TEST(Brush, CombKeepsLength) {
    Canvas canvas(test::ball(4));
    shuffle(canvas, 6);
    Groom after = canvas.groom;
    Stroke stroke(canvas.query, canvas.groom, brushOf(Tool::comb, Mode::add, 0.5f));
    for (int i = 0; i < 20; ++i) {
        const vec3 p(std::cos(0.05f * static_cast<float>(i)),
                     std::sin(0.05f * static_cast<float>(i)), 0.0f);
        stroke.dab(after, p, p);
    }
    std::size_t changed = 0;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        EXPECT_EQ(after.fur[v].furLength, canvas.groom.fur[v].furLength);
        EXPECT_EQ(after.fur[v].density, canvas.groom.fur[v].density);
        EXPECT_LE(glm::length(after.fur[v].direction), 1.0f + 1e-6f);
        changed += !(after.fur[v] == canvas.groom.fur[v]);
    }
    EXPECT_GT(changed, 50u);
}

TEST(Brush, CombLaysHairAlongTheStrokeAndAgainstItWhenSubtracted) {
    const Canvas canvas(test::sheet(30));
    const std::vector<vec3> path = straight({-0.3f, 0, 0}, {0.3f, 0, 0}, 9);
    const Groom along = canvas.painted(brushOf(Tool::comb), path);
    const Groom against = canvas.painted(brushOf(Tool::comb, Mode::subtract), path);
    std::vector<uint> middle;
    canvas.query.within(vec3(0.0f), 1e-5f, middle);
    EXPECT_LT(glm::distance(along.fur[middle[0]].direction, vec3(1, 0, 0)), 1e-3f);
    EXPECT_LT(glm::distance(against.fur[middle[0]].direction, vec3(-1, 0, 0)), 1e-3f);
}

TEST(Brush, CombWithoutMotionDoesNothing) {
    const Canvas canvas(test::sheet(30));
    EXPECT_EQ(canvas.painted(brushOf(Tool::comb), {vec3(0.0f), vec3(0.0f)}), canvas.groom);
}

TEST(Brush, SmoothLeavesConstantFieldsAlone) {
    const Canvas canvas(test::ball(3));
    Groom after = canvas.groom;
    Stroke stroke(canvas.query, canvas.groom, brushOf(Tool::smooth, Mode::add, 0.7f));
    for (int i = 0; i < 5; ++i) stroke.dab(after, {0.2f * static_cast<float>(i), 1.0f, 0.0f}, kUp);
    flood(canvas.query, after, brushOf(Tool::smooth));
    EXPECT_EQ(after, canvas.groom);  // not even a chunk was copied
}

TEST(Brush, SmoothEvensOut) {
    Canvas canvas(test::sheet(30));
    shuffle(canvas, 7);
    Groom after = canvas.groom;
    flood(canvas.query, after, brushOf(Tool::smooth));
    auto roughness = [&](const Groom& groom) {
        double sum = 0.0;
        for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
            for (const uint u : canvas.skin->ring(v)) {
                const FurVertex &p = groom.fur[v], &q = groom.fur[u];
                sum += std::abs(p.furLength - q.furLength) + std::abs(p.density - q.density) +
                       glm::distance(p.direction, q.direction);
            }
        }
        return sum;
    };
    EXPECT_LT(roughness(after), 0.6 * roughness(canvas.groom));
}

TEST(Brush, SmoothEvensOutADenseMeshBeyondTheRing) {
    Canvas canvas(test::sheet(200));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        canvas.groom.fur.edit(v).furLength =
            canvas.skin->vertices[v].position.x < 0.0f ? 0.1f : 0.0f;
    const Groom after = canvas.painted(brushOf(Tool::smooth), {vec3(0.0f)});
    std::vector<uint> found;
    canvas.query.within({0.0301f, 0.0f, 0.0f}, 1e-3f, found);  // six edges from the step
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(after.fur[found[0]].furLength, 0.01f);
    EXPECT_LT(after.fur[found[0]].furLength, 0.05f);
}

TEST(Brush, SmoothDoesNotMixTheSidesOfAThinSheet) {
    Canvas canvas(test::twoSheets(60, 0.004f));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        canvas.groom.fur.edit(v).furLength =
            canvas.skin->vertices[v].position.y < 0.0f ? 0.1f : 0.3f;
    Brush brush = brushOf(Tool::smooth);
    brush.facingOnly = false;
    EXPECT_EQ(canvas.painted(brush, {vec3(0.0f), vec3(0.1f, 0.0f, 0.0f)}), canvas.groom);
}

TEST(Flood, ReachesEveryVertexInFull) {
    const Canvas canvas(test::ball(3));
    Groom after = canvas.groom;
    Brush brush = brushOf(Tool::length, Mode::set);
    flood(canvas.query, after, brush);
    brush = brushOf(Tool::density, Mode::subtract);
    flood(canvas.query, after, brush);
    flood(canvas.query, after, brushOf(Tool::comb), vec3(0, -1, 0));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        EXPECT_EQ(after.fur[v].furLength, 0.25f);
        EXPECT_EQ(after.fur[v].density, 0.0f);
        const vec3 n = canvas.skin->vertices[v].normal;
        if (std::abs(n.y) > 0.99f) continue;
        EXPECT_NEAR(glm::dot(after.fur[v].direction, n), 0.0f, 1e-4f);
        EXPECT_NEAR(glm::length(after.fur[v].direction), 1.0f, 1e-4f);
        EXPECT_LT(after.fur[v].direction.y, 0.0f);
    }
}

}  // namespace
}  // namespace pelage
