// patches_test.cpp -- the skin in patches: nothing is lost, and nothing that is seen is left out.
#include "core/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/sights.h"
#include "core/test_skins.h"

namespace pelage {
namespace {

std::size_t trianglesOf(const std::vector<Range>& ranges) {
    std::size_t count = 0;
    for (const Range& range : ranges) count += range.count;
    return count;
}

TEST(Patches, HoldEveryTriangleOnceInItsPart) {
    const auto skin = makeSkin(test::twoSheets(40, 0.1f));
    const Patches patches = makePatches(*skin);
    EXPECT_EQ(std::set<uint>(patches.order.begin(), patches.order.end()).size(),
              skin->triangles.size());
    EXPECT_EQ(patches.order.size(), skin->triangles.size());
    for (const Patch& patch : patches.patches) {
        const SourcePart& part = skin->source->parts[patch.triangles.part];
        EXPECT_LE(patch.triangles.count, Patches::kMost);
        for (uint k = 0; k < patch.triangles.count; ++k) {
            const uint t = patches.order[patch.triangles.first + k];
            EXPECT_GE(t, part.firstTriangle);
            EXPECT_LT(t, part.firstTriangle + part.triangleCount);
        }
    }
}

TEST(Patches, AreDrawnInOneRangeForEachPart) {
    const auto skin = makeSkin(test::twoSheets(40, 0.1f));
    const std::vector<Range> all = allOf(makePatches(*skin));
    EXPECT_EQ(all.size(), skin->source->parts.size());
    EXPECT_EQ(trianglesOf(all), skin->triangles.size());
}

// True if the bounds of a triangle in the window reach into it.
bool reachesIn(const Skin& skin, uint triangle, const Sight& sight) {
    vec2 lower(INFINITY), upper(-INFINITY);
    for (int k = 0; k < 3; ++k) {
        const vec4 clip =
            sight.viewProjection * vec4(skin.vertices[skin.triangles[triangle][k]].position, 1.0f);
        const vec2 at = (0.5f + 0.5f * vec2(clip) / clip.w) * vec2(sight.size);
        lower = glm::min(lower, at);
        upper = glm::max(upper, at);
    }
    return upper.x >= 0.0f && upper.y >= 0.0f && lower.x <= static_cast<float>(sight.size.x) &&
           lower.y <= static_cast<float>(sight.size.y);
}

TEST(Patches, NothingInTheWindowIsLeftOut) {
    const auto skin = makeSkin(test::ball(5));
    const Patches patches = makePatches(*skin);
    std::size_t leftOut = 0;
    for (const float distance : {1.3f, 2.0f, 6.0f})
        for (const bool perspective : {false, true}) {
            Sight sight =
                test::sightFrom(distance * vec3(0.8f, 0.3f, 0.5f), {300, 200}, perspective);
            if (!perspective) sight.size = {300, 200};
            std::set<uint> drawn;
            for (const Range& range : inView(patches, sight))
                for (uint k = 0; k < range.count; ++k) drawn.insert(patches.order[range.first + k]);
            leftOut += skin->triangles.size() - drawn.size();
            for (uint t = 0; t < skin->triangles.size(); ++t)
                if (reachesIn(*skin, t, sight)) {
                    EXPECT_TRUE(drawn.contains(t)) << t;
                }
        }
    EXPECT_GT(leftOut, 0u);  // there was something to leave out
}

TEST(Patches, BoundsFollowThePose) {
    Skin skin = *makeSkin(test::ball(3));
    Patches patches = makePatches(skin);
    const Sight sight = test::sightFrom(vec3(0, 0, 4));
    EXPECT_GT(trianglesOf(inView(patches, sight)), 0u);
    for (SkinVertex& v : skin.vertices) v.position.x += 50.0f;
    boundPatches(patches, skin);
    EXPECT_EQ(trianglesOf(inView(patches, sight)), 0u);
}

}  // namespace
}  // namespace pelage
