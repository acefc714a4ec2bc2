// region_edit_test.cpp -- what an edit of a region does, and what it leaves alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "canvas.h"
#include "core/region.h"
#include "regions.h"

namespace pelage {
namespace {

using test::Canvas;
using test::Draws;
using test::edit;
using test::sphere;
using test::weights;

TEST(RegionEdit, UntouchedVerticesAndChannelsKeepTheirBits) {
    Canvas canvas(test::ball(3));
    test::shuffle(canvas, 3);
    const Region region = sphere({0, 1, 0}, 0.3f, 0.3f);
    const std::vector<float> share = weights(canvas, region);
    for (const Channel channel : {Channel::length, Channel::density, Channel::direction}) {
        for (uint act = 0; act < 4; ++act) {
            Groom after = canvas.groom;
            RegionEdit change = edit(channel, static_cast<RegionAct>(act), 0.5f);
            change.direction = {1.0f, 0.0f, 0.2f};
            applyRegion(canvas.query, after, region, change);
            std::size_t touched = 0;
            for (uint v = 0; v < share.size(); ++v) {
                const FurVertex &a = canvas.groom.fur[v], &b = after.fur[v];
                if (share[v] == 0.0f) {
                    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
                } else
                    touched += !(a == b);
                if (channel != Channel::length) {
                    EXPECT_EQ(a.furLength, b.furLength);
                }
                if (channel != Channel::density) {
                    EXPECT_EQ(a.density, b.density);
                }
                if (channel != Channel::direction) {
                    EXPECT_EQ(a.direction, b.direction);
                }
            }
            EXPECT_GT(touched, 50u) << act;
        }
    }
}

TEST(RegionEdit, TheMaskHoldsBackAsInAFlood) {
    Canvas canvas(test::ball(3));
    test::shuffle(canvas, 4);
    Draws draws(8);
    for (uint v = 0; v < canvas.groom.mask.size(); ++v)
        canvas.groom.mask.edit(v) = static_cast<float>(draws.below(3)) / 2.0f;
    Groom flooded = canvas.groom, edited = canvas.groom;
    flood(canvas.query, flooded, test::brushOf(Tool::length, Mode::set));
    applyRegion(canvas.query, edited, Region{}, edit(Channel::length, RegionAct::set, 0.25f));
    EXPECT_LT(test::largestDifference(flooded, edited), 1e-6f);
    EXPECT_GT(test::largestDifference(canvas.groom, edited), 0.1f);
    for (uint v = 0; v < edited.fur.size(); ++v)
        if (canvas.groom.mask[v] == 1.0f) {
            EXPECT_EQ(edited.fur[v], canvas.groom.fur[v]);
        }
}

TEST(RegionEdit, SmoothIsThatOfAFlood) {
    Canvas canvas(test::ball(3));
    test::shuffle(canvas, 5);
    Groom flooded = canvas.groom, edited = canvas.groom;
    Brush brush = test::brushOf(Tool::smooth);
    brush.strength = 0.7f;
    flood(canvas.query, flooded, brush);
    for (const Channel channel : {Channel::length, Channel::density, Channel::direction}) {
        Groom after = canvas.groom;
        applyRegion(canvas.query, after, Region{}, edit(channel, RegionAct::smooth, 0.7f));
        for (uint v = 0; v < after.fur.size(); ++v) {
            FurVertex& fur = edited.fur.edit(v);
            if (channel == Channel::length) fur.furLength = after.fur[v].furLength;
            if (channel == Channel::density) fur.density = after.fur[v].density;
            if (channel == Channel::direction) fur.direction = after.fur[v].direction;
            fur.tint = flooded.fur[v].tint;  // a region edits no tint
        }
    }
    EXPECT_LT(test::largestDifference(flooded, edited), 1e-6f);
    EXPECT_GT(test::largestDifference(canvas.groom, edited), 0.1f);
}

TEST(RegionEdit, ValuesStayInTheRangeOfTheirChannel) {
    Canvas canvas(test::ball(3));
    test::shuffle(canvas, 6);
    for (const Channel channel : {Channel::length, Channel::density, Channel::direction}) {
        for (const float value :
             {-1e30f, -3.0f, 0.0f, 5.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
            for (uint act = 0; act < 4; ++act) {
                Groom after = canvas.groom;
                RegionEdit change = edit(channel, static_cast<RegionAct>(act), value);
                change.direction = vec3(value, 1.0f, 0.0f);
                applyRegion(canvas.query, after, sphere({0, 1, 0}, 0.5f, 0.5f), change);
                for (uint v = 0; v < after.fur.size(); ++v) {
                    const FurVertex& fur = after.fur[v];
                    EXPECT_TRUE(fur.furLength >= 0.0f && fur.furLength <= 1e6f);
                    EXPECT_TRUE(fur.density >= 0.0f && fur.density <= 1.0f);
                    EXPECT_LE(glm::length(fur.direction), 1.0001f);
                }
            }
        }
    }
}

TEST(RegionEdit, DirectionIsLaidOntoTheTangentPlaneAndZeroStandsUp) {
    Canvas canvas(test::ball(3));
    RegionEdit change = edit(Channel::direction, RegionAct::set, 0.0f);
    change.direction = {0.0f, 0.6f, 0.0f};
    Groom after = canvas.groom;
    applyRegion(canvas.query, after, Region{}, change);
    for (uint v = 0; v < after.fur.size(); ++v) {
        const vec3 n = canvas.skin->vertices[v].normal, d = after.fur[v].direction;
        if (std::abs(n.y) > 0.99f) continue;
        EXPECT_NEAR(glm::dot(n, d), 0.0f, 1e-5f);
        EXPECT_NEAR(glm::length(d), 0.6f, 1e-5f);
        EXPECT_GT(d.y, 0.0f);
    }
    change.direction = vec3(0.0f);
    applyRegion(canvas.query, after, Region{}, change);
    for (uint v = 0; v < after.fur.size(); ++v) EXPECT_EQ(after.fur[v].direction, vec3(0.0f));
}

TEST(RegionEdit, RandomiseKeepsWithinItsShareAndTurnsAboutTheNormal) {
    Canvas canvas(test::ball(4));
    Groom after = canvas.groom;
    applyRegion(canvas.query, after, Region{}, edit(Channel::length, RegionAct::randomise, 0.3f));
    applyRegion(canvas.query, after, Region{},
                edit(Channel::direction, RegionAct::randomise, 0.25f));
    float least = 1.0f, most = 0.0f;
    double mean = 0.0;
    for (uint v = 0; v < after.fur.size(); ++v) {
        const float factor = after.fur[v].furLength / canvas.groom.fur[v].furLength;
        least = std::min(least, factor);
        most = std::max(most, factor);
        mean += static_cast<double>(factor) / static_cast<double>(after.fur.size());
        const vec3 n = canvas.skin->vertices[v].normal;
        const vec3 a = canvas.groom.fur[v].direction, b = after.fur[v].direction;
        EXPECT_NEAR(glm::dot(n, a), glm::dot(n, b), 1e-5f);
        EXPECT_NEAR(glm::length(a), glm::length(b), 1e-5f);
        // At most an eighth of a full turn.
        const vec3 fa = a - n * glm::dot(n, a), fb = b - n * glm::dot(n, b);
        EXPECT_GE(glm::dot(fa, fb), 0.707f * glm::dot(fa, fa) - 1e-5f);
    }
    EXPECT_GE(least, 0.7f - 1e-6f);
    EXPECT_LE(most, 1.3f + 1e-6f);
    EXPECT_LT(least, 0.72f);
    EXPECT_GT(most, 1.28f);
    EXPECT_NEAR(mean, 1.0, 0.02);
}

TEST(RegionEdit, RandomiseDrawsFromThePlaceAndTheSeed) {
    // The same sheet with its vertices in another order.
    Source forward = test::sheet(10), backward = test::sheet(10);
    const uint count = static_cast<uint>(backward.positions.size());
    std::reverse(backward.positions.begin(), backward.positions.end());
    for (uvec3& t : backward.triangles) t = uvec3(count - 1) - t;
    Canvas a(std::move(forward)), b(std::move(backward));
    RegionEdit change = edit(Channel::density, RegionAct::randomise, 0.5f);
    Groom first = a.groom, second = b.groom, other = a.groom;
    applyRegion(a.query, first, Region{}, change);
    applyRegion(b.query, second, Region{}, change);
    change.seed = 1;
    applyRegion(a.query, other, Region{}, change);
    int different = 0;
    for (uint v = 0; v < count; ++v) {
        ASSERT_EQ(a.skin->vertices[v].position, b.skin->vertices[v].position);
        EXPECT_EQ(first.fur[v], second.fur[v]);
        different += !(first.fur[v] == other.fur[v]);
    }
    EXPECT_GT(different, 100);
}

}  // namespace
}  // namespace pelage
