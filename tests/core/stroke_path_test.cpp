// stroke_path_test.cpp -- where a stroke works: along the skin, at its images, as hard as pressed.
#include <gtest/gtest.h>

#include <cmath>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::Draws;
using test::kAllTools;
using test::largestDifference;
using test::straight;

// An ear and a head: a sheet folded back along x = 0, its sides 0.01 m apart, over another sheet.
Source earAndHead() {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    test::addSheet(positions, triangles, 60, 0.0f, true);
    for (vec3& p : positions)
        if (p.x > 0.0f) p = {-p.x, -0.01f, p.z};
    test::addSheet(positions, triangles, 60, -0.02f, true);
    return test::oneMesh(std::move(positions), std::move(triangles));
}

TEST(StrokePath, AStrokeOnOneEarTouchesNeitherItsOtherSideNorTheHeadBehindIt) {
    const Canvas canvas(earAndHead());
    Brush brush = brushOf(Tool::mask);
    brush.facingOnly = false;
    const auto path = straight({-0.3f, 0, -0.2f}, {-0.3f, 0, 0.2f}, 5);
    const Groom along = canvas.painted(brush, path);
    brush.alongSurface = false;
    const Groom through = canvas.painted(brush, path);
    std::size_t ear = 0, behind = 0;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const bool front = canvas.skin->vertices[v].position.y > -0.005f;
        ear += front && along.mask[v] > 0.0f;
        behind += !front && through.mask[v] > 0.0f;
        if (!front) {
            EXPECT_EQ(along.mask[v], 0.0f);
        }
    }
    EXPECT_GT(ear, 300u);
    EXPECT_GT(behind, 300u);
}

TEST(StrokePath, AStrokeGoesRoundTheRimOfAnEarByItsDistanceAlongTheSkin) {
    const Canvas canvas(earAndHead());
    Brush brush = brushOf(Tool::mask);
    brush.facingOnly = false;
    const Groom after = canvas.painted(brush, {{-0.05f, 0, -0.3f}, {-0.05f, 0, 0.3f}});
    std::size_t back = 0;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const vec3 p = canvas.skin->vertices[v].position;
        if (std::abs(p.z) > 0.25f || p.y < -0.015f || p.y > -0.005f) continue;
        // The rim is a column of cells that joins the sides: 1/60 m wide in x and 0.01 in y.
        const float rim = std::hypot(1.0f / 60.0f, 0.01f);
        const float far = 0.05f + rim + (-1.0f / 60.0f - p.x);
        EXPECT_NEAR(after.mask[v], falloffWeight(Falloff::smooth, far, 0.2f), 1e-4f);
        back += after.mask[v] > 0.0f;
    }
    EXPECT_GT(back, 200u);
}

TEST(StrokePath, StrokeAlongACurvedSkinHardlyDependsOnSampling) {
    const Canvas canvas(test::ball(4));
    for (const Tool tool : {Tool::length, Tool::comb, Tool::part, Tool::smooth}) {
        const auto stroke = [&](int parts) {
            Groom after = canvas.groom;
            Stroke made(canvas.query, canvas.groom, brushOf(tool, Mode::add, 0.3f));
            for (int i = 0; i <= parts; ++i) {
                const float s = 1.2f * static_cast<float>(i) / static_cast<float>(parts);
                const vec3 p = glm::normalize(vec3(std::cos(s), 0.3f, std::sin(s)));
                made.dab(after, p, p);
            }
            return after;
        };
        const Groom coarse = stroke(12);
        for (const int parts : {24, 60})
            EXPECT_LT(largestDifference(coarse, stroke(parts)), 0.02f)
                << toolInfo(tool).name << " in " << parts;
    }
}

TEST(StrokePath, PressureScalesTheCoverageAndChangesEvenlyBetweenPoints) {
    const Canvas canvas(test::sheet(60));
    const vec3 from(-0.4f, 0, 0), to(0.4f, 0, 0);
    for (const Falloff falloff :
         {Falloff::smooth, Falloff::linear, Falloff::sharp, Falloff::constant}) {
        Brush brush = brushOf(Tool::mask, Mode::add, 0.19f);  // no vertex is at the very edge
        brush.falloff = falloff;
        const auto stroke = [&](int parts, float first, float last) {
            Groom after = canvas.groom;
            Stroke made(canvas.query, canvas.groom, brush);
            for (int i = 0; i <= parts; ++i) {
                const float t = static_cast<float>(i) / static_cast<float>(parts);
                made.dab(after, glm::mix(from, to, t), test::kUp, glm::mix(first, last, t));
            }
            return after;
        };
        const Groom full = stroke(1, 1.0f, 1.0f), half = stroke(1, 0.5f, 0.5f);
        const Groom rising = stroke(1, 0.0f, 1.0f);
        for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
            EXPECT_NEAR(half.mask[v], 0.5f * full.mask[v], 1e-6f);
            const vec3 p = canvas.skin->vertices[v].position;
            float most = 0.0f;
            for (int i = 0; i <= 2000; ++i) {
                const float t = static_cast<float>(i) / 2000.0f;
                most = std::max(most,
                                t * falloffWeight(falloff, glm::distance(p, glm::mix(from, to, t)),
                                                  brush.radius));
            }
            EXPECT_NEAR(rising.mask[v], most, 2e-3f);
        }
        EXPECT_LT(largestDifference(rising, stroke(40, 0.0f, 1.0f)), 2e-3f);
    }
}

TEST(StrokePath, WithoutPressureNothingIsTouched) {
    const Canvas canvas(test::sheet(20));
    for (const Tool tool : kAllTools) {
        Groom after = canvas.groom;
        Stroke stroke(canvas.query, canvas.groom, brushOf(tool));
        for (const vec3 p : straight({-0.3f, 0, 0}, {0.3f, 0, 0}, 4))
            stroke.dab(after, p, test::kUp, 0.0f);
        EXPECT_EQ(after, canvas.groom) << toolInfo(tool).name;
    }
}

TEST(StrokePath, MirrorsInEverySubsetOfTheAxes) {
    const Canvas canvas(test::ball(4));
    for (int subset = 0; subset < 8; ++subset) {
        Brush brush = brushOf(Tool::mask, Mode::add, 0.3f);
        brush.mirror = {(subset & 1) != 0, (subset & 2) != 0, (subset & 4) != 0};
        const vec3 at = glm::normalize(vec3(0.8f, 0.6f, 0.7f));
        const Groom after = canvas.painted(brush, {at}, at);
        for (int octant = 0; octant < 8; ++octant) {
            const vec3 sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
            std::vector<uint> near;
            canvas.query.within(sign * at, 0.05f, near);
            ASSERT_FALSE(near.empty());
            const bool image = (octant & ~subset) == 0;
            EXPECT_EQ(after.mask[near[0]] > 0.5f, image) << subset << ' ' << octant;
        }
    }
}

TEST(StrokePath, ImagesLieOnTheNearestSkinWhereTheSidesDiffer) {
    // The half with x < 0 is pulled in by a third and has another mesh.
    Source source = test::ball(4);
    Draws draws(11);
    for (vec3& p : source.positions)
        if (p.x < -0.1f) p = 0.67f * glm::normalize(p + 0.02f * draws.inBox(1.0f));
    const Canvas canvas(std::move(source));
    Brush brush = brushOf(Tool::mask, Mode::add, 0.25f);
    brush.mirror.x = true;
    for (const bool alongSurface : {true, false}) {
        brush.alongSurface = alongSurface;
        const Groom after = canvas.painted(brush, {{1, 0, 0}}, {1, 0, 0});
        float most = 0.0f;
        for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
            if (canvas.skin->vertices[v].position.x < -0.3f) most = std::max(most, after.mask[v]);
        EXPECT_GT(most, 0.9f);
    }
}

TEST(StrokePath, MirrorsAtThePlanesOfTheMeshsOwnSpace) {
    // The mesh's x is the world's z, and it stands elsewhere.
    mat4 toWorld(1.0f);
    toWorld[0] = {0, 0, 1, 0};
    toWorld[2] = {-1, 0, 0, 0};
    toWorld[3] = {5, 2, 3, 1};
    Source source = test::ball(4);
    source.parts[0].toWorld = toWorld;
    const Canvas canvas(std::move(source));
    const vec3 middle(5, 2, 3), at = glm::normalize(vec3(0.2f, 0.3f, 0.9f));
    Brush brush = brushOf(Tool::mask, Mode::add, 0.2f);
    brush.mirror.x = true;
    const Groom after = canvas.painted(brush, {middle + at}, at);
    for (const float side : {1.0f, -1.0f}) {
        std::vector<uint> near;
        canvas.query.within(middle + at * vec3(1, 1, side), 0.06f, near);
        ASSERT_FALSE(near.empty());
        EXPECT_GT(after.mask[near[0]], 0.5f);
    }
}

TEST(StrokePath, AStrokeOverBrokenTrianglesStaysFinite) {
    // Needles, triangles without area, a corner twice, three triangles at an edge.
    Source source = test::sheet(20);
    Draws draws(12);
    const uint count = static_cast<uint>(source.positions.size());
    for (int i = 0; i < 200; ++i) {
        const uint a = draws.below(count), b = (a + 1) % count, c = draws.below(count);
        source.triangles.push_back(i % 4 == 0 ? uvec3(a, a, b)
                                              : uvec3(a, b, i % 2 ? (b + 1) % count : c));
    }
    source.parts[0].triangleCount = static_cast<uint>(source.triangles.size());
    const Canvas canvas(std::move(source));
    for (const Tool tool : kAllTools) {
        Brush brush = brushOf(tool, Mode::add, 0.3f);
        brush.mirror = glm::bvec3(true);
        const Groom after = canvas.painted(brush, straight({-0.3f, 0, 0.1f}, {0.4f, 0, 0}, 6));
        EXPECT_LT(largestDifference(after, canvas.groom), 3.0f);  // false for what is no number
    }
}

}  // namespace
}  // namespace pelage
