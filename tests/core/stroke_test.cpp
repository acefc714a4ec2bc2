// stroke_test.cpp -- what a stroke promises, whatever the tool.
#include "core/brush.h"

#include <gtest/gtest.h>

#include <cmath>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::Draws;
using test::equalValues;
using test::kAllTools;
using test::kUp;
using test::largestDifference;
using test::shuffle;
using test::straight;

TEST(Stroke, StrokeDoesNotDependOnSampling) {
    Canvas canvas(test::sheet(40));
    shuffle(canvas, 3);
    for (const Tool tool : kAllTools) {
        if (tool == Tool::segment) continue;  // no hair; see body_test.cpp
        const Brush brush = brushOf(tool);
        const vec3 a(-0.3f, 0.0f, -0.1f), b(0.31f, 0.0f, 0.17f), c(0.1f, 0.0f, 0.4f);
        auto path = [&](int parts) {
            std::vector<vec3> points = straight(a, b, parts);
            for (const vec3 p : straight(b, c, parts)) points.push_back(p);
            return points;
        };
        const Groom coarse = canvas.painted(brush, path(1));
        EXPECT_GT(largestDifference(coarse, canvas.groom), 0.01f);
        for (const int parts : {2, 7, 60})
            EXPECT_LT(largestDifference(coarse, canvas.painted(brush, path(parts))), 2e-4f)
                << toolInfo(tool).name << " in " << parts;
    }
}

TEST(Stroke, OverlapsDoNotAddUp) {
    const Canvas canvas(test::sheet(30));
    for (const Tool tool : kAllTools) {
        if (tool == Tool::comb) continue;  // sums the directions of the path
        const std::vector<vec3> once = straight({-0.3f, 0, 0}, {0.3f, 0, 0}, 5);
        std::vector<vec3> often = once;
        for (int i = 0; i < 6; ++i)
            for (const vec3 p :
                 straight({i % 2 ? -0.3f : 0.3f, 0, 0}, {i % 2 ? 0.3f : -0.3f, 0, 0}, 5))
                often.push_back(p);
        EXPECT_LT(largestDifference(canvas.painted(brushOf(tool), once),
                                    canvas.painted(brushOf(tool), often)),
                  1e-6f)
            << toolInfo(tool).name;
    }
}

TEST(Stroke, CoverageIsTheFalloffOfTheDistanceToThePath) {
    const Canvas canvas(test::sheet(30));
    const Groom after = canvas.painted(brushOf(Tool::mask), {{-0.3f, 0, 0}, {0.3f, 0, 0}});
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const vec3 p = canvas.skin->vertices[v].position;
        const float distance = glm::length(p - vec3(glm::clamp(p.x, -0.3f, 0.3f), 0, 0));
        EXPECT_NEAR(after.mask[v], falloffWeight(Falloff::smooth, distance, 0.2f), 1e-5f);
    }
}

TEST(Stroke, MaskProtects) {
    Canvas canvas(test::sheet(30));
    shuffle(canvas, 4);
    Groom half = canvas.groom;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        half.mask.edit(v) = v % 3 == 0 ? 1.0f : v % 3 == 1 ? 0.5f : 0.0f;
    for (const Tool tool : kAllTools) {
        if (tool == Tool::mask) continue;
        const std::vector<vec3> path = straight({-0.3f, 0, 0}, {0.3f, 0, 0}, 4);
        const Groom free = canvas.painted(brushOf(tool), path);
        Groom after = half;
        Stroke stroke(canvas.query, half, brushOf(tool));
        for (const vec3 p : path) stroke.dab(after, p, kUp);
        Groom flooded = half;
        flood(canvas.query, flooded, brushOf(tool), vec3(1, 0, 0));
        for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
            if (v % 3 == 0) {
                EXPECT_EQ(after.fur[v], half.fur[v]);
                EXPECT_EQ(flooded.fur[v], half.fur[v]);
            } else if (v % 3 == 1) {
                EXPECT_NEAR(after.fur[v].furLength,
                            0.5f * (half.fur[v].furLength + free.fur[v].furLength), 1e-6f);
                EXPECT_LT(glm::distance(after.fur[v].direction,
                                        0.5f * (half.fur[v].direction + free.fur[v].direction)),
                          1e-5f);
            } else {
                EXPECT_EQ(after.fur[v], free.fur[v]);
            }
        }
    }
}

TEST(Stroke, MirrorIsSymmetric) {
    Canvas canvas(test::ball(4));
    const Skin& skin = *canvas.skin;
    std::vector<uint> twin(skin.vertices.size());
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const vec3 p = skin.vertices[v].position;
        std::vector<uint> found;
        canvas.query.within({-p.x, p.y, p.z}, 1e-4f, found);
        ASSERT_EQ(found.size(), 1u);
        twin[v] = found[0];
        canvas.groom.fur.edit(v).furLength =
            0.05f + 0.02f * std::sin(9.0f * p.y + 5.0f * p.x * p.x);
        canvas.groom.fur.edit(v).direction = vec3(0.3f * p.x * p.z, 0.4f * p.y, -0.5f);
    }
    for (const Tool tool : kAllTools) {
        if (tool == Tool::segment) continue;
        Brush brush = brushOf(tool, Mode::add, 0.4f);
        brush.mirror.x = true;
        Groom after = canvas.groom;
        Stroke stroke(canvas.query, canvas.groom, brush);
        for (int i = 0; i < 8; ++i) {  // crosses the plane of symmetry
            const float s = 0.3f * static_cast<float>(i);
            const vec3 p = glm::normalize(vec3(std::cos(s), 0.4f, std::sin(s)));
            stroke.dab(after, p, p);
        }
        for (uint v = 0; v < skin.vertices.size(); ++v) {
            const FurVertex &here = after.fur[v], &there = after.fur[twin[v]];
            EXPECT_NEAR(here.furLength, there.furLength, 1e-5f);
            EXPECT_NEAR(here.density, there.density, 1e-5f);
            EXPECT_NEAR(after.mask[v], after.mask[twin[v]], 1e-5f);
            EXPECT_LT(glm::distance(here.tint, there.tint), 1e-5f);
            EXPECT_LT(glm::distance(here.direction * vec3(-1, 1, 1), there.direction), 1e-4f)
                << toolInfo(tool).name;
        }
        EXPECT_FALSE(equalValues(after, canvas.groom));
    }
}

TEST(Stroke, OtherSideOfThinSheetIsUntouched) {
    Canvas canvas(test::twoSheets(30, 0.004f));
    shuffle(canvas, 5);
    for (const Tool tool : kAllTools) {
        if (tool == Tool::segment) continue;
        const Groom after =
            canvas.painted(brushOf(tool), straight({-0.3f, 0.002f, 0}, {0.3f, 0.002f, 0}, 3));
        Brush through = brushOf(tool);
        through.facingOnly = false;
        through.alongSurface = false;
        const Groom both =
            canvas.painted(through, straight({-0.3f, 0.002f, 0}, {0.3f, 0.002f, 0}, 3));
        std::size_t top = 0, bottom = 0;
        for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
            const bool same = after.fur[v] == canvas.groom.fur[v] && after.mask[v] == 0.0f;
            const bool sameBoth = both.fur[v] == canvas.groom.fur[v] && both.mask[v] == 0.0f;
            if (canvas.skin->vertices[v].position.y > 0.0f)
                top += !same;
            else
                EXPECT_TRUE(same);
            if (canvas.skin->vertices[v].position.y < 0.0f) bottom += !sameBoth;
        }
        EXPECT_GT(top, 50u);
        EXPECT_GT(bottom, 50u);
    }
}

TEST(Stroke, DabRewritesOnlyItsFootprint) {
    const Canvas canvas(test::sheet(200));  // 40401 vertices, 158 chunks
    for (const Tool tool : {Tool::length, Tool::density, Tool::mask}) {
        Groom after = canvas.groom;
        Stroke stroke(canvas.query, canvas.groom, brushOf(tool, Mode::add, 0.03f));
        stroke.dab(after, vec3(0.2f, 0.0f, 0.2f), kUp);
        std::size_t copied = 0;
        for (std::size_t c = 0; c < after.fur.chunkCount(); ++c)
            copied += !after.fur.sharesChunk(canvas.groom.fur, c) ||
                      !after.mask.sharesChunk(canvas.groom.mask, c);
        EXPECT_GE(copied, 1u);
        EXPECT_LE(copied, 10u);
        // A second dab at the same place covers nothing new and writes nothing.
        const Groom once = after;
        stroke.dab(after, vec3(0.2f, 0.0f, 0.2f), kUp);
        EXPECT_EQ(after, once);
    }
}

TEST(Stroke, NoStrengthWritesNothing) {
    const Canvas canvas(test::sheet(20));
    for (const Tool tool : kAllTools)
        EXPECT_EQ(canvas.painted(brushOf(tool, Mode::add, 0.3f, 0.0f),
                                 straight(vec3(-0.2f, 0, 0), vec3(0.2f, 0, 0), 3)),
                  canvas.groom);
}

TEST(Stroke, NonsensePointsAreNoPartOfThePath) {
    const Canvas canvas(test::sheet(20));
    const Brush brush = brushOf(Tool::comb);
    const Groom clean = canvas.painted(brush, {{-0.1f, 0, 0}, {0.1f, 0, 0}});
    const Groom dirty = canvas.painted(
        brush, {vec3(NAN), {-0.1f, 0, 0}, vec3(1e30f), vec3(0, INFINITY, 0), {0.1f, 0, 0}});
    EXPECT_TRUE(equalValues(clean, dirty));
}

TEST(Stroke, ValuesStayInRangeWhateverIsPainted) {
    Canvas canvas(test::ball(3));
    Draws draws(8);
    for (int i = 0; i < 200; ++i) {
        Brush brush = brushOf(kAllTools[draws.below(kToolCount)], static_cast<Mode>(draws.below(4)),
                              draws.in(1e-8f, i % 7 ? 0.8f : 5e5f), draws.in(0.0f, 1.0f));
        brush.falloff = static_cast<Falloff>(draws.below(4));
        brush.color = 0.5f + draws.inBox(0.5f);
        brush.value = i % 5 ? draws.in(0.0f, 1.0f) : 1e6f;
        brush.mirror = {draws.below(2), draws.below(2), draws.below(2)};
        brush.factor = draws.in(0.0f, 10.0f);
        brush.alongSurface = draws.below(2);
        brush.facingOnly = draws.below(2);
        Stroke stroke(canvas.query, canvas.groom, brush);
        for (int k = 0; k < 4; ++k) stroke.dab(canvas.groom, draws.inBox(1.1f), draws.inBox(1.0f));
    }
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const FurVertex& fur = canvas.groom.fur[v];
        EXPECT_TRUE(fur.furLength >= 0.0f && fur.furLength <= 1e6f);
        EXPECT_TRUE(fur.density >= 0.0f && fur.density <= 1.0f);
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(fur.tint[k] >= 0.0f && fur.tint[k] <= 1.0f);
        EXPECT_TRUE(glm::length(fur.direction) <= 1.0f + 1e-5f);
        EXPECT_TRUE(canvas.groom.mask[v] >= 0.0f && canvas.groom.mask[v] <= 1.0f);
    }
}

}  // namespace
}  // namespace pelage
