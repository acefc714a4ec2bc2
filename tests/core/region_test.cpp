// region_test.cpp -- which vertices a region holds, and how much of each.
#include "core/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "canvas.h"
#include "core/narrow.h"
#include "reading.h"
#include "regions.h"

namespace pelage {
namespace {

using test::Canvas;
using test::edit;
using test::regionOf;
using test::segmentedBall;
using test::sphere;
using test::viewFromFront;
using test::weights;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Region narrow(float width, float falloff = 0.0f) {
    Region region = regionOf(Where::narrow, falloff);
    region.width = width;
    return region;
}

double sum(const std::vector<float>& numbers) {
    double total = 0.0;
    for (const float number : numbers) total += static_cast<double>(number);
    return total;
}

// Every weight in [0,1], none of them no number.
void expectWeights(const Canvas& canvas, const Region& region) {
    const std::vector<float> found = weights(canvas, region);
    ASSERT_EQ(found.size(), canvas.skin->vertices.size());
    for (const float weight : found) ASSERT_TRUE(weight >= 0.0f && weight <= 1.0f) << weight;
}

Region lasso(std::vector<vec2> polygon, float falloff = 0.0f) {
    Region region = regionOf(Where::lasso, falloff);
    region.polygon = std::move(polygon);
    region.viewProjection = viewFromFront();
    region.eye = {0.0f, 0.0f, 5.0f};
    return region;
}

TEST(Region, WeightIsOneInsideAndFallsSmoothlyToZeroOverTheFalloff) {
    const Canvas canvas(test::sheet(100));
    Region box = regionOf(Where::box, 0.2f);
    box.half = vec3(0.1f);
    for (const Region& region : {sphere({}, 0.1f, 0.2f), box}) {
        const std::vector<float> found = weights(canvas, region);
        int between = 0;
        for (uint v = 0; v < found.size(); ++v) {
            const vec3 p = canvas.skin->vertices[v].position;
            const float far = region.where == Where::sphere
                                  ? glm::length(p) - 0.1f
                                  : glm::length(glm::max(glm::abs(p) - 0.1f, vec3(0.0f)));
            if (far <= 0.0f) {
                EXPECT_EQ(found[v], 1.0f);
            }
            if (far >= 0.2f) {
                EXPECT_EQ(found[v], 0.0f);
            }
            between += found[v] > 0.0f && found[v] < 1.0f;
            for (const uint u : canvas.skin->ring(v))  // steepest: 1.5 over the falloff
                EXPECT_LE(std::abs(found[u] - found[v]), 1.6f * 0.0142f / 0.2f);
        }
        EXPECT_GT(between, 1000);
    }
}

TEST(Region, WithoutFalloffWeightsAreZeroOrOne) {
    const Canvas canvas(segmentedBall());
    Region head = regionOf(Where::segment);
    head.segment = "head";
    Region curved = regionOf(Where::curved);
    curved.curvature = 0.9f;
    for (const Region& region : {sphere({0, 1, 0}, 0.5f), head, narrow(2.5f), curved})
        for (const float weight : weights(canvas, region))
            EXPECT_TRUE(weight == 0.0f || weight == 1.0f);
}

TEST(Region, SizesAreMultiplesOfTheSkins) {
    const Canvas canvas(test::ball(3));
    const float size = canvas.skin->size();
    Region metres = sphere({0, 1, 0}, 0.1f * size, 0.05f * size);
    Region multiples = sphere({0, 1, 0}, 0.1f, 0.05f);
    multiples.sizes = true;
    EXPECT_EQ(weights(canvas, metres), weights(canvas, multiples));
    EXPECT_GT(sum(weights(canvas, metres)), 1.0);
    Region round = regionOf(Where::curved);
    round.sizes = true;
    round.curvature = 0.9f * size;
    EXPECT_EQ(sum(weights(canvas, round)), static_cast<double>(canvas.skin->vertices.size()));
}

TEST(Region, BoxIsTurnedAboutItsAxis) {
    const Canvas canvas(test::sheet(60));
    Region box = regionOf(Where::box);
    box.half = {0.4f, 0.1f, 0.02f};
    box.turn = {0.0f, 0.25f * 3.14159265f, 0.0f};  // x turns towards -z
    const std::vector<float> found = weights(canvas, box);
    int inside = 0;
    for (uint v = 0; v < found.size(); ++v) {
        const vec3 p = canvas.skin->vertices[v].position;
        if (found[v] > 0.0f) {
            EXPECT_LT(std::abs(p.x + p.z), 0.03f) << p.x << ' ' << p.z;
        }
        inside += found[v] > 0.0f;
    }
    EXPECT_GT(inside, 30);
}

TEST(Region, SegmentIsFoundByNameAndByNumberAndFadesOverItsBorder) {
    const Canvas canvas(segmentedBall());
    Region region = regionOf(Where::segment);
    region.segment = "left ear";
    const std::vector<float> named = weights(canvas, region);
    region.segment = "1";
    EXPECT_EQ(weights(canvas, region), named);
    for (uint v = 0; v < named.size(); ++v)
        EXPECT_EQ(named[v] > 0.0f, canvas.skin->vertices[v].position.x >= 0.0f);
    region.falloff = 0.5f;
    const std::vector<float> faded = weights(canvas, region);
    int between = 0;
    for (uint v = 0; v < faded.size(); ++v) {
        const float x = canvas.skin->vertices[v].position.x;
        if (x >= 0.0f) {
            EXPECT_EQ(faded[v], 1.0f);
        }
        if (x < -0.5f) {
            EXPECT_EQ(faded[v], 0.0f);
        }
        between += faded[v] > 0.0f && faded[v] < 1.0f;
    }
    EXPECT_GT(between, 100);
}

TEST(Region, AnUnknownSegmentIsRefusedWithItsName) {
    const Canvas canvas(segmentedBall());
    Region region = regionOf(Where::segment);
    for (const char* name : {"tail", "2", "-1", "", "0x"}) {
        region.segment = name;
        EXPECT_EQ(
            test::refusal([&] { weights(canvas, region); }),
            "no body segment \"" + std::string(name) + "\"; there are \"head\", \"left ear\"");
    }
    region.segment = "0";
    const Canvas bare(test::ball(1));
    EXPECT_EQ(test::refusal([&] { weights(bare, region); }), "the mesh has no body segments");
}

TEST(Region, MaskIsItsOwnWeightAndIsEditedWhereItIsPainted) {
    Canvas canvas(test::sheet(20));
    canvas.groom.mask.edit(7) = 1.0f;
    canvas.groom.mask.edit(90) = 0.25f;
    std::vector<float> expected(canvas.skin->vertices.size(), 0.0f);
    expected[7] = 1.0f;
    expected[90] = 0.25f;
    EXPECT_EQ(weights(canvas, regionOf(Where::mask)), expected);
    EXPECT_GT(sum(weights(canvas, regionOf(Where::mask, 0.2f))), 2.0);
    Groom after = canvas.groom;
    applyRegion(canvas.query, after, regionOf(Where::mask),
                edit(Channel::density, RegionAct::set, 1.0f));
    EXPECT_EQ(after.fur[7].density, 1.0f);
    EXPECT_EQ(after.fur[90].density, 0.625f);
    EXPECT_EQ(after.fur[8], canvas.groom.fur[8]);
}

// A ray along the rim of a sheet of 1 m may or may not meet another.
bool onRim(const Canvas& canvas, uint v) {
    const vec3 p = glm::abs(canvas.skin->vertices[v].position);
    return std::max(p.x, p.z) > 0.49f;
}

TEST(Region, NarrowHoldsAThinPlateAndNotABall) {
    const Canvas plate(test::twoSheets(30, 0.004f));
    const std::vector<float> found = weights(plate, narrow(0.005f));
    for (uint v = 0; v < found.size(); ++v) {
        if (!onRim(plate, v)) {
            EXPECT_EQ(found[v], 1.0f);
        }
    }
    EXPECT_EQ(sum(weights(plate, narrow(0.003f))), 0.0);
    const Canvas ball(test::ball(4));
    EXPECT_EQ(sum(weights(ball, narrow(1.9f))), 0.0);
    EXPECT_EQ(sum(weights(ball, narrow(2.1f))), static_cast<double>(ball.skin->vertices.size()));
    for (const float weight : weights(ball, narrow(1.9f, 0.2f))) EXPECT_NEAR(weight, 0.5f, 0.05f);
}

TEST(Region, AnOpenSheetIsNotNarrow) {
    const Canvas sheet(test::sheet(10));
    EXPECT_EQ(sum(weights(sheet, narrow(1e6f))), 0.0);
    // Not even above a body, here with its face at y = -0.1.
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    test::addSheet(positions, triangles, 10, 0.0f, true);
    test::addSheet(positions, triangles, 10, -0.1f, true);
    test::addSheet(positions, triangles, 10, -0.3f, false);
    const Canvas above(test::oneMesh(positions, triangles));
    const std::vector<float> found = weights(above, narrow(0.25f));
    for (uint v = 0; v < found.size(); ++v) {
        const bool inBody = above.skin->vertices[v].position.y < -0.05f;
        if (!inBody || !onRim(above, v)) {
            EXPECT_EQ(found[v], inBody ? 1.0f : 0.0f);
        }
    }
}

TEST(Region, PartsInOneAnotherCountAsOneBody) {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    test::addSheet(positions, triangles, 8, 0.0f, true);
    test::addSheet(positions, triangles, 8, -0.2f, false);
    test::addSheet(positions, triangles, 8, -0.1f, true);
    test::addSheet(positions, triangles, 8, -0.3f, false);
    const Canvas canvas(test::oneMesh(positions, triangles));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        if (canvas.skin->vertices[v].position.y == 0.0f && !onRim(canvas, v)) {
            EXPECT_NEAR(thicknessAt(canvas.query, v, 1.0f), 0.3f, 1e-5f);
        }
    }
}

TEST(Region, AMirroredPartIsAsThick) {
    Source mirrored = test::twoSheets(10, 0.1f);
    mirrored.parts[0].toWorld[0][0] = -1.0f;
    const Canvas canvas(std::move(mirrored));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        if (!onRim(canvas, v)) {
            EXPECT_NEAR(thicknessAt(canvas.query, v, 1.0f), 0.1f, 1e-5f);
        }
    }
}

TEST(Region, CurvatureOfABallIsOneOverItsRadius) {
    const Canvas ball(test::ball(4));
    for (uint v = 0; v < ball.skin->vertices.size(); ++v)
        EXPECT_NEAR(curvatureAt(*ball.skin, v), 1.0f, 0.03f);
}

TEST(Region, CurvatureIsZeroOnAPlaneUpToItsBorder) {
    const float c = std::cos(0.5f), s = std::sin(0.5f);
    const mat4 tilted({c, s, 0, 0}, {-s, c, 0, 0}, {0, 0, 1, 0}, {3, 4, 5, 1});
    const Canvas sheet(test::sheet(30, tilted));
    for (uint v = 0; v < sheet.skin->vertices.size(); ++v)
        EXPECT_NEAR(curvatureAt(*sheet.skin, v), 0.0f, 1e-3f);
}

// A tube about the z axis of radius 1: long needles, `around` of them, one ring at each end.
Source needleTube(uint around, float length) {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    for (uint i = 0; i < around; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(around);
        positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        positions.emplace_back(std::cos(angle), std::sin(angle), length);
    }
    for (uint i = 0; i < around; ++i) {
        const uint a = 2 * i, b = a + 1, c = 2 * ((i + 1) % around), d = c + 1;
        triangles.push_back({a, c, b});
        triangles.push_back({b, c, d});
    }
    return test::oneMesh(std::move(positions), std::move(triangles));
}

TEST(Region, NeedlesAreNoMoreCurvedThanTheTubeTheyMake) {
    const Canvas tube(needleTube(64, 30.0f));  // 0.1 x 30 m
    for (uint v = 0; v < tube.skin->vertices.size(); ++v)
        EXPECT_LE(curvatureAt(*tube.skin, v), 0.6f);  // 1/2 of a cylinder
    const Canvas stout(needleTube(64, 0.1f));
    for (uint v = 0; v < stout.skin->vertices.size(); ++v)
        EXPECT_NEAR(curvatureAt(*stout.skin, v), 0.5f, 0.05f);
}

TEST(Region, LassoHoldsWhatIsInsideItsPolygonAndFacesTheEye) {
    const Canvas ball(test::ball(4));
    const std::vector<float> right =
        weights(ball, lasso({{0.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}));
    for (uint v = 0; v < right.size(); ++v) {
        const vec3 p = ball.skin->vertices[v].position;
        if (p.x < 0.0f || p.z < 0.0f) {
            EXPECT_EQ(right[v], 0.0f);
        }
        if (p.x > 0.01f && p.z > 0.5f) {
            EXPECT_EQ(right[v], 1.0f);
        }
    }
}

TEST(Region, LassoHoldsAllItWindsAroundEvenWhereItCrossesItself) {
    const Canvas ball(test::ball(3));
    const std::vector<vec2> once{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    std::vector<vec2> twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    EXPECT_GT(sum(weights(ball, lasso(once))), 50.0);
    EXPECT_EQ(weights(ball, lasso(once)), weights(ball, lasso(twice)));
}

TEST(Region, LassoFalloffIsInHalvesOfThePicturesHeight) {
    // A picture twice as wide as high: half its height is half as much of x as of y.
    const Canvas sheet(test::sheet(50));
    Region region = lasso({{-0.1f, -0.1f}, {0.1f, -0.1f}, {0.1f, 0.1f}, {-0.1f, 0.1f}}, 0.2f);
    region.viewProjection = mat4(0.0f);  // from above, parallel: 2 m high and 4 m wide
    region.viewProjection[0][0] = 0.5f;
    region.viewProjection[2][1] = -1.0f;
    region.viewProjection[1][2] = -1.0f;
    region.viewProjection[3][3] = 1.0f;
    const std::vector<float> found = weights(sheet, region);
    for (uint v = 0; v < found.size(); ++v) {
        const vec3 p = glm::abs(sheet.skin->vertices[v].position);
        const vec2 beyond = glm::max(vec2(p.x - 0.2f, p.z - 0.1f), vec2(0.0f));
        if (glm::length(beyond) > 0.201f) {
            EXPECT_EQ(found[v], 0.0f);
        } else if (glm::length(beyond) < 0.199f) {
            EXPECT_GT(found[v], 0.0f);
        }
    }
    // The same from below: nothing faces the eye.
    region.viewProjection[1][2] = 1.0f;
    EXPECT_EQ(sum(weights(sheet, region)), 0.0);
}

TEST(Region, AFieldThatIsNoNumberSelectsNothing) {
    Canvas canvas(segmentedBall());
    Region box = regionOf(Where::box);
    box.half = {kNan, 1.0f, 1.0f};
    Region turned = regionOf(Where::box);
    turned.half = vec3(9.0f);
    turned.turn.x = kNan;
    Region curved = regionOf(Where::curved);
    curved.curvature = kNan;
    Region view = lasso({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    view.viewProjection[3][3] = kNan;
    for (const Region& region :
         {sphere({kNan, 0, 0}, 9.0f), sphere({}, kNan), box, turned, curved, narrow(kNan), view,
          lasso({{-1, -1}, {1, kNan}, {1, 1}, {-1, 1}}), lasso({{-1, -1}, {1, 1}}), lasso({})})
        EXPECT_EQ(sum(weights(canvas, region)), 0.0) << static_cast<int>(region.where);
    EXPECT_EQ(weights(canvas, sphere({0, 1, 0}, 0.5f, kNan)),
              weights(canvas, sphere({0, 1, 0}, 0.5f)));
    Groom after = canvas.groom;
    for (const Channel channel : {Channel::length, Channel::density, Channel::direction})
        for (uint act = 0; act < 4; ++act) {
            RegionEdit change = edit(channel, static_cast<RegionAct>(act), kNan);
            change.direction = vec3(kNan, 1.0f, 0.0f);
            applyRegion(canvas.query, after, Region{}, change);
        }
    EXPECT_TRUE(test::equalValues(after, canvas.groom));
}

TEST(Region, ZeroRadiusIsItsCentreAndFalloff) {
    const Canvas canvas(test::sheet(10));
    EXPECT_EQ(sum(weights(canvas, sphere({}, 0.0f))), 1.0);
    EXPECT_EQ(sum(weights(canvas, sphere({0.01f, 0, 0}, 0.0f))), 0.0);
    EXPECT_GT(sum(weights(canvas, sphere({0.01f, 0, 0}, 0.0f, 0.3f))), 5.0);
}

TEST(Region, HardSkinsHaveWeightsToo) {
    std::vector<Source> sources;
    sources.push_back(test::oneMesh({}, {}));
    sources.push_back(test::oneMesh({{1, 2, 3}}, {}));
    sources.push_back(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));  // no area
    sources.push_back(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}));
    sources.push_back(needleTube(50, 1e6f));
    sources.push_back(needleTube(50, 1e-6f));
    for (Source& source : sources) {
        Canvas canvas(std::move(source));
        for (uint where = 0; where < 8; ++where) {
            Region region = lasso({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0.1f);
            region.where = static_cast<Where>(where);
            if (region.where == Where::segment) continue;
            expectWeights(canvas, region);
            Groom after = canvas.groom;
            for (uint act = 0; act < 4; ++act)
                applyRegion(canvas.query, after, region,
                            edit(Channel::direction, static_cast<RegionAct>(act), 1.0f));
            for (uint v = 0; v < after.fur.size(); ++v)
                EXPECT_LE(glm::length(after.fur[v].direction), 1.0001f);
        }
    }
}

}  // namespace
}  // namespace pelage
