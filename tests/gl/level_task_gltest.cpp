// level_task_gltest.cpp -- coarser skins that are made beside the main thread.
#include "app/render/level_task.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/render/mirror.h"
#include "core/subdivide.h"
#include "tests/core/sights.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

Sight farSight() { return test::sightFrom(vec3(0.0f, 0.0f, 40.0f)); }

constexpr float kDeviation = 2.0f;

std::vector<uvec3> indicesOf(const Mirror::Surface& surface) {
    return test::valuesOf<uvec3>(surface.indices.name(), surface.patches.order.size());
}

std::vector<uvec3> wantedOf(const Skin& skin) {
    return makeSkinLevel(skin, levelWithin(skin, farSight(), kDeviation)).triangles;
}

const Mirror::Surface& surfaceNow(Mirror& mirror) {
    return mirror.surface(farSight(), kDeviation, false);
}

// As frames do that ask again and again.
const Mirror::Surface& surfaceInTheEnd(Mirror& mirror) {
    while (&surfaceNow(mirror) == &mirror.surface())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return surfaceNow(mirror);
}

TEST(LevelTask, TheSkinIsDrawnAsItIsUntilACoarserOneIsReady) {
    const Document document = test::evenDocument(test::ball(6));
    Mirror mirror;
    mirror.update(document);
    EXPECT_EQ(&surfaceNow(mirror), &mirror.surface());
    EXPECT_EQ(indicesOf(surfaceInTheEnd(mirror)), wantedOf(*document.skin));
}

TEST(LevelTask, WhoWaitsHasTheCoarserSkinAtOnce) {
    const Document document = test::evenDocument(test::ball(5));
    const auto wanted = wantedOf(*document.skin);
    for (const bool begun : {false, true}) {
        Mirror mirror;
        mirror.update(document);
        if (begun) surfaceNow(mirror);
        EXPECT_EQ(indicesOf(mirror.surface(farSight(), kDeviation, true)), wanted);
    }
}

TEST(LevelTask, AFinerLevelServesWhileACoarserOneIsMade) {
    const Document document = test::evenDocument(test::ball(6));
    Mirror mirror;
    mirror.update(document);
    const Mirror::Surface& finer = mirror.surface(farSight(), 0.25f * kDeviation, true);
    ASSERT_NE(&finer, &mirror.surface());
    EXPECT_EQ(&surfaceNow(mirror), &finer);
}

TEST(LevelTask, ThereIsNoneOfASkinThatIsNoLongerThere) {
    const Document coarse = test::evenDocument(test::ball(5));
    const Document fine = subdivided(coarse, 1), other = test::evenDocument(test::ball(4));
    Mirror mirror;
    // Subdivided, undone and made anew, another mesh: each while a level of the last is made.
    for (const Document& document : {coarse, fine, coarse, fine, other}) {
        mirror.update(document);
        EXPECT_EQ(&surfaceNow(mirror), &mirror.surface());
    }
    mirror.update(coarse);
    EXPECT_EQ(indicesOf(surfaceInTheEnd(mirror)), wantedOf(*coarse.skin));
    // Also of one that is ready and was not asked for any more.
    mirror.update(fine);
    surfaceNow(mirror);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    mirror.update(coarse);
    EXPECT_EQ(indicesOf(surfaceInTheEnd(mirror)), wantedOf(*coarse.skin));
}

TEST(LevelTask, CancelledLevelsAreNotFinished) {
    const auto skin = makeSkin(test::ball(4));
    Progress progress;
    progress.cancel = true;
    EXPECT_THROW(makeSkinLevel(*skin, 1, &progress), Cancelled);
    LevelTask(skin, 1);  // given up at once
}

TEST(LevelTask, PicturesAgreeWithThoseThatWaitOnceItIsReady) {
    const Document document = test::evenDocument(test::ball(6));
    View view = test::ballView(document, 160);
    view.camera.distance = 12.0f;
    view.samples = 2;
    view.detail = {.rule = Detail::Rule::pixels, .limit = 1.0f};
    Renderer waiting, other;
    const auto expected = test::picture(waiting, document, view);
    view.waits = false;
    View moving = view;
    const std::size_t all = document.skin->triangles.size();
    EXPECT_EQ(other.draw(document, moving).trianglesDrawn, all);
    do moving.camera.yaw += 1e-3f;
    while (other.draw(document, moving).trianglesDrawn == all);
    EXPECT_EQ(test::picture(other, document, view), expected);
}

}  // namespace
}  // namespace pelage
