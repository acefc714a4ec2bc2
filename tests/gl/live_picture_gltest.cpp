// live_picture_gltest.cpp -- the picture that is measured is the one that is seen.
#include "app/measure/live_picture.h"

#include <gtest/gtest.h>

#include "app/render/frames.h"
#include "core/pixels.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

TEST(LivePicture, IsTheFinishedPictureOverBlackDrawnAFrameAStep) {
    const Document document = test::furryBall(300);
    View view;
    view.size = {48, 32};
    view.samples = 4;
    view.camera = framed(document.skin->center(), 1.6f, 0.5f, 0.3f, 1.5f);
    Renderer renderer;
    LiveDrawing drawing(view, 3);
    std::optional<LivePicture> picture;
    int frames = 0;
    for (; !picture; ++frames) picture = drawing.step(renderer, document);
    // One that uploads, three that are timed, four over white and four over black.
    EXPECT_EQ(frames, 12);
    EXPECT_EQ(picture->times.size(), 3u);
    EXPECT_EQ(picture->stats.samples, 4);

    Renderer other;
    view.background = vec3(0.0f);
    drawFinished(other, document, view);
    const Image seen = linearImage({view.size, other.pixels()});
    ASSERT_EQ(picture->image.pixels.size(), seen.pixels.size());
    std::size_t covered = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        EXPECT_EQ(vec3(picture->image.pixels[i]), vec3(seen.pixels[i]));
        covered += picture->image.pixels[i].a == 1.0f ? 1u : 0u;
    }
    EXPECT_EQ(picture->image.pixels.front().a, 0.0f) << "nothing is in the corner";
    EXPECT_GT(covered, seen.pixels.size() / 10) << "the ball is in the middle";
}

}  // namespace
}  // namespace pelage
