// live_picture_gltest.cpp -- the picture that is measured is the one that is seen.
#include "app/measure/live_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "app/render/frames.h"
#include "core/pixels.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

View ballView(const Document& document, int samples) {
    View view;
    view.size = {48, 32};
    view.samples = samples;
    view.camera = framed(document.skin->center(), 1.6f, 0.5f, 0.3f, 1.5f);
    return view;
}

LivePicture drawn(Renderer& renderer, const Document& document, LiveDrawing drawing, int& frames) {
    std::optional<LivePicture> picture;
    for (frames = 0; !picture; ++frames) picture = drawing.step(renderer, document);
    return std::move(*picture);
}

TEST(LivePicture, IsTheFinishedPictureOverBlackDrawnAFrameAStep) {
    const Document document = test::furryBall(300);
    View view = ballView(document, 4);
    Renderer renderer;
    int frames = 0;
    const LivePicture picture = drawn(renderer, document, {view, 3}, frames);
    EXPECT_EQ(frames, 4);
    EXPECT_EQ(picture.stats.samples, 4);

    Renderer other;
    view.background = vec3(0.0f);
    drawFinished(other, document, view);
    const Image seen = linearImage({view.size, other.pixels()});
    ASSERT_EQ(picture.image.pixels.size(), seen.pixels.size());
    // Half a step of 8 bits of both pictures in linear light, and of the coverage.
    const float bound = 0.5f / 255.0f * (2.28f + 2.28f + 1.0f);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(picture.image.pixels[i][c], seen.pixels[i][c], bound);
        covered += picture.image.pixels[i].a == 1.0f ? 1u : 0u;
    }
    EXPECT_EQ(picture.image.pixels.front().a, 0.0f) << "nothing is in the corner";
    EXPECT_GT(covered, seen.pixels.size() / 10) << "the ball is in the middle";
}

TEST(LivePicture, AtLeastSoManyFramesAreTimed) {
    const Document document = test::furryBall(300);
    Renderer renderer;
    View apart;
    apart.size = ivec2(8);
    for (const auto& [samples, timed] : {std::pair(4, 3u), {4, 0u}, {1, 3u}, {1, 0u}, {2, 5u}}) {
        renderer.draw(document, apart);  // no picture goes on with the one before
        int frames = 0;
        const LivePicture picture =
            drawn(renderer, document, {ballView(document, samples), timed}, frames);
        const std::size_t ofPicture = static_cast<std::size_t>(samples) - 1;
        EXPECT_EQ(picture.times.size(), std::max<std::size_t>(ofPicture, timed));
        EXPECT_EQ(static_cast<std::size_t>(frames), picture.times.size() + 1);
        for (const double ms : picture.times) EXPECT_GT(ms, 0.0);
    }
}

}  // namespace
}  // namespace pelage
