// lod_sight_test.cpp -- what cannot be seen is left out, and nothing else.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/lod.h"
#include "core/sights.h"
#include "core/test_skins.h"

namespace pelage {
namespace {

using test::kNoSkin, test::oneCluster, test::plainPelt, test::seenOf, test::sightFrom;

TEST(LodSight, ClustersOutsideTheViewAreLeftOut) {
    const Sight sight = sightFrom(vec3(0, 0, 1));
    const float half = std::tan(0.5f * test::kFieldOfView);  // m seen to each side of the origin
    const auto seen = [&](vec3 center, float reach) {
        return seenOf(oneCluster(center), sight, reach).clusters.size();
    };
    for (const vec3 side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0)}) {
        EXPECT_EQ(seen(0.99f * half * side, 1e-3f), 1u);
        EXPECT_EQ(seen(half * side + 0.005f * side, 1e-3f), 1u);  // its ball reaches in
        EXPECT_EQ(seen(half * side + 0.02f * side, 1e-3f), 0u);
        EXPECT_EQ(seen(half * side + 0.02f * side, 0.1f), 1u);  // its hair reaches in
    }
}

vec3 windowOf(const Sight& sight, vec3 p) {
    const vec4 clip = sight.viewProjection * vec4(p, 1.0f);
    return (0.5f + 0.5f * vec3(clip) / clip.w) * vec3(sight.size, 1.0f);
}

TEST(LodSight, TheOutlineHoldsTheBall) {
    test::Draws draws(3);
    for (int i = 0; i < 300; ++i) {
        const Sight sight =
            sightFrom(vec3(draws.in(-2, 2), draws.in(-1, 1), draws.in(0.5f, 2)), {320, 200}, i % 2);
        const vec3 center = draws.inBox(0.5f);
        const float radius = draws.in(0.001f, 0.3f);
        const Outline outline = outlineOf(sight, center, radius);
        if (!outline.known) continue;
        vec2 lower(INFINITY), upper(-INFINITY);
        for (int k = 0; k < 400; ++k) {
            const vec3 p = center + radius * glm::normalize(draws.inBox(1.0f) + vec3(1e-6f));
            const vec2 at(windowOf(sight, p));
            lower = glm::min(lower, at);
            upper = glm::max(upper, at);
        }
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_LE(outline.lower[axis], lower[axis] + 1e-3f);
            EXPECT_GE(outline.upper[axis], upper[axis] - 1e-3f);
        }
    }
    EXPECT_FALSE(outlineOf(sightFrom(vec3(0, 0, 1)), vec3(0, 0, 0.9f), 0.2f).known);
}

TEST(LodSight, TheSkinHidesARectangleOnlyIfItIsNearerInEveryPixel) {
    constexpr int kWide = 45, kHigh = 30;
    const ivec2 corner(16, 8);
    test::Draws draws(7);
    std::size_t hidden = 0;
    for (int round = 0; round < 20; ++round) {
        // A near skin with holes.
        std::vector<float> depth(kWide * kHigh, 0.3f);
        for (uint hole = draws.below(6); hole > 0; --hole)
            depth[draws.below(kWide * kHigh)] = draws.in(0.3f, 1.0f);
        constexpr int kRows = (kHigh + SkinDepth::kTile - 1) / SkinDepth::kTile;
        std::vector<float> strips(kWide * kRows, 0.0f);
        for (int y = 0; y < kHigh; ++y)
            for (int x = 0; x < kWide; ++x) {
                float& strip = strips[static_cast<std::size_t>(y / SkinDepth::kTile * kWide + x)];
                strip = std::max(strip, depth[static_cast<std::size_t>(y * kWide + x)]);
            }
        const SkinDepth skin(corner, kWide, strips);
        for (int i = 0; i < 500; ++i) {
            const vec2 lower(draws.in(0.0f, 70.0f), draws.in(0.0f, 45.0f));
            const vec2 upper = lower + vec2(draws.in(0.0f, 40.0f), draws.in(0.0f, 25.0f));
            const float at = draws.in(0.2f, 1.0f);
            if (!skin.hides(lower, upper, at)) continue;
            ++hidden;
            for (int y = 0; y < kHigh; ++y)
                for (int x = 0; x < kWide; ++x) {
                    const vec2 pixel = vec2(corner) + vec2(x, y);
                    const bool inside = glm::all(glm::lessThanEqual(glm::floor(lower), pixel)) &&
                                        glm::all(glm::lessThanEqual(pixel, upper));
                    EXPECT_TRUE(!inside || depth[static_cast<std::size_t>(y * kWide + x)] < at);
                }
        }
        EXPECT_FALSE(skin.hides({20, 12}, {40, 30}, 0.2f));
        EXPECT_FALSE(SkinDepth().hides({20, 12}, {40, 30}, 1.0f));
    }
    EXPECT_GT(hidden, 1000u);
}

// The hair of a ball seen from +z, behind a wall that stands in every pixel.
std::vector<uint> seenBehind(const Document& document, const Roots& roots, const Sight& sight,
                             float wall) {
    std::vector<Tuft> tufts;
    for (const Cluster& cluster : roots.clusters)
        tufts.push_back(tuftOf(cluster, *document.skin, document.groom.fur, document.fur));
    const std::vector<float> strips(
        static_cast<std::size_t>(sight.size.x * sight.size.y / SkinDepth::kTile),
        windowOf(sight, vec3(0, 0, wall)).z);
    std::vector<uint> seen;
    const SkinDepth skin(ivec2(0), sight.size.x, strips);
    for (const auto& one : lookAt(roots, tufts, plainPelt(), sight, &skin).clusters)
        seen.push_back(one.cluster);
    return seen;
}

TEST(LodSight, HairBehindTheSkinIsLeftOutUnlessItReachesBeforeIt) {
    Document document = test::evenDocument(test::ball(3));
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.2f, vec3(1.0f), 1.0f});
    const Roots roots = scatterRoots(*document.skin, 20000, 1);
    const Sight sight = sightFrom(vec3(0, 0, 6), ivec2(64));
    EXPECT_EQ(seenBehind(document, roots, sight, -2.0f).size(), roots.clusters.size());
    EXPECT_TRUE(seenBehind(document, roots, sight, 1.9f).empty());
    // Hair on the far side of a ball points away from the eye: the wall hides it where it hides its
    // roots, while that of the near side reaches through.
    const std::vector<uint> seen = seenBehind(document, roots, sight, 0.1f);
    std::vector<bool> isSeen(roots.clusters.size());
    for (const uint c : seen) isSeen[c] = true;
    for (uint c = 0; c < roots.clusters.size(); ++c) {
        const Cluster& cluster = roots.clusters[c];
        const float front = cluster.center.z + cluster.radius;
        if (front > 0.1f) {
            EXPECT_TRUE(isSeen[c]) << front;
        }
        if (cluster.center.z < -0.7f) {
            EXPECT_FALSE(isSeen[c]) << front;
        }
    }
}

TEST(LodSight, ATuftKnowsItsLongestHairItsDensityAndItsNormals) {
    Document document = test::evenDocument(test::ball(3));
    test::Draws draws(5);
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.fur.edit(v) = {vec3(0.0f), draws.in(0, 0.2f), vec3(1.0f), draws.in(-1, 2)};
    const Skin& skin = *document.skin;
    const Roots roots = scatterRoots(skin, 20000, 1);
    for (const Cluster& cluster : roots.clusters) {
        const Tuft tuft = tuftOf(cluster, skin, document.groom.fur, document.fur);
        float longest = 0.0f, densest = 0.0f;
        for (uint i = 0; i < cluster.count; ++i) {
            const Root& root = roots.roots[cluster.first + i];
            const uvec3 t = skin.triangles[root.triangle];
            const vec3 w = baryWeights(root.bary);
            vec3 normal(0.0f);
            for (int c = 0; c < 3; ++c) {
                normal += w[c] * skin.vertices[t[c]].normal;
                longest = std::max(longest, document.groom.fur[t[c]].furLength);
                densest = std::max(densest, document.groom.fur[t[c]].density);
            }
            EXPECT_GE(glm::dot(glm::normalize(normal), tuft.normals.axis), tuft.normals.cosine);
        }
        EXPECT_GE(tuft.longest, longest);
        EXPECT_GE(tuft.densest, std::min(densest, 1.0f));
        EXPECT_LE(tuft.densest, 1.0f);
        EXPECT_GT(tuft.normals.cosine, 0.0f);
    }
}

TEST(LodSight, NoHairReachesFartherThanItsTuftSays) {
    test::Draws draws(11);
    double used = 0.0, clusters = 0.0;  // of combed hair
    for (uint round = 0; round < 40; ++round) {
        Document document = test::evenDocument(test::ball(3));
        Fur& fur = document.fur;
        const bool rough = round % 2;
        for (uint v = 0; v < document.skin->vertices.size(); ++v) {
            const vec3 combed = rough ? draws.inBox(0.57f) : vec3(0.0f, -0.5f, 0.6f);
            document.groom.fur.edit(v) = {combed, draws.in(0.02f, 0.2f), vec3(1.0f), 1.0f};
        }
        for (Coat* coat : {&fur.over, &fur.under}) {
            coat->stiffness = draws.in(-0.2f, 1.0f);
            coat->directionWeight = std::min(draws.in(0.0f, 1.2f), 1.0f);
            coat->endRandomness = std::max(draws.in(-0.3f, 0.6f), 0.0f);
            coat->relativeLength = draws.in(0.3f, 1.0f);
            coat->frizz = std::max(draws.in(-0.5f, 0.3f), 0.0f);
            coat->curlRadius = std::max(draws.in(-0.5f, 0.3f), 0.0f);
            coat->style = draws.below(5);
        }
        fur.gravityDirection = glm::normalize(draws.inBox(1.0f));
        fur.gravity = draws.in(0.0f, 1.0f);
        fur.wind = std::max(draws.in(-1.0f, 1.0f), 0.0f);
        fur.gusts = 1.0f;
        const Skin& skin = *document.skin;
        const Roots roots = scatterRoots(skin, 10000, round);
        const Pelt pelt = peltOf(fur, 3, 1e-4f, 1e-4f, skin.area, 0.2f);
        const vec3 direction = glm::normalize(draws.inBox(1.0f));
        for (const Cluster& cluster : roots.clusters) {
            const Tuft tuft = tuftOf(cluster, skin, document.groom.fur, fur);
            const float most = reachAlong(tuft, pelt, direction);
            float farthest = 0.0f;
            for (uint i = 0; i < cluster.count; ++i) {
                const Root& root = roots.roots[cluster.first + i];
                const uvec3 t = skin.triangles[root.triangle];
                const auto& painted = document.groom.fur;
                const Strand s =
                    growStrand(root, skin.vertices[t.x], skin.vertices[t.y], skin.vertices[t.z],
                               painted[t.x], painted[t.y], painted[t.z], fur, 1e-4f, 0.5f);
                for (const float at : {0.3f, 0.7f, 1.0f})
                    farthest =
                        std::max(farthest, glm::dot(strandPoint(s, at) - s.origin, direction));
            }
            EXPECT_LE(farthest, most + 1e-5f) << round;
            if (rough) continue;
            used += static_cast<double>(most / (pelt.reach() * tuft.longest));
            clusters += 1.0;
        }
    }
    EXPECT_LT(used / clusters, 0.95);  // that it leans is made use of
}

TEST(LodSight, BaldClustersAreLeftOut) {
    const Roots roots = oneCluster();
    const Sight sight = sightFrom(vec3(0, 0, 1));
    for (const Tuft& tuft :
         {Tuft{.longest = 0.0f, .densest = 1.0f}, Tuft{.longest = 1.0f, .densest = 0.0f}}) {
        const InSight seen = lookAt(roots, {&tuft, 1}, plainPelt(), sight, &kNoSkin);
        EXPECT_TRUE(seen.clusters.empty());
        EXPECT_EQ(seen.bald, 1u);
    }
}

}  // namespace
}  // namespace pelage
