// wind_gltest.cpp -- strands and shells bend alike in the wind: the tip most, the root not at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

constexpr int kSide = 128;         // pixels
constexpr float kPixel = 1.5e-3f;  // m
constexpr float kLength = 0.12f;

// A row of upright hair across the wind, which blows along x and swells as a whole.
Document hedge() {
    Document document = test::evenDocument(test::sheet(64));
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), kLength, vec3(1.0f), 1.0f});
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const vec3 p = document.skin->vertices[v].position;
        document.groom.fur.edit(v).density = std::abs(p.x) < 0.02f && std::abs(p.z) < 0.1f;
    }
    Fur& fur = document.fur;
    fur.hairs = 200000;
    fur.share = 1.0f;
    fur.gravity = 0.0f;
    fur.wind = 0.6f;
    fur.windDirection = vec3(1.0f, 0.0f, 0.0f);
    fur.gusts = 1.0f;
    fur.gustSize = 1000.0f;
    fur.gustRate = 0.3f;
    Coat& coat = fur.over;
    coat.ambient = coat.diffuse = coat.specular = vec3(0.0f);
    coat.stiffness = 0.3f;
    coat.directionWeight = coat.endRandomness = coat.taper = 0.0f;
    coat.relativeLength = 1.0f;
    coat.width = 1.5e-3f;
    return document;
}

// From the side, the skin along the middle of the picture.
View fromTheSide(Shells shells) {
    View view;
    view.size = ivec2(kSide);
    view.camera.orthographic = true;
    view.camera.pitch = view.camera.yaw = 0.0f;
    view.camera.distance = 0.5f * kSide * kPixel / std::tan(0.5f * view.camera.fieldOfView);
    view.detail.rule = Detail::Rule::all;
    view.background = vec3(1.0f);
    view.showSkin = false;
    view.shells = shells;
    view.samples = 4;
    return view;
}

// x of the middle of the hair at so many pixels over the skin, m.
float middleAt(const std::vector<float>& light, int height) {
    double sum = 0.0, weights = 0.0;
    for (int x = 0; x < kSide; ++x) {
        const auto pixel = static_cast<std::size_t>((kSide / 2 - 1 - height) * kSide + x);
        const double covered = 1.0 - static_cast<double>(light[3 * pixel]);
        sum += covered * x;
        weights += covered;
    }
    EXPECT_GT(weights, 1.0) << height;
    return kPixel * static_cast<float>(sum / weights);
}

TEST(Wind, MovesTheTipAndLeavesTheRootInStrandsAndShellsAlike) {
    const Document document = hedge();
    Renderer renderer;
    const std::vector<int> heights = {1, 10, 20, 30, 40, 50};
    std::vector<std::vector<float>> moved;
    for (const Shells shells : {Shells::none, Shells::swept, Shells::plain, Shells::instanced}) {
        View view = fromTheSide(shells);
        view.layers = shells == Shells::swept ? 0u : 128u;
        view.seconds = 2.0f;
        const std::vector<float> before = test::linear(test::picture(renderer, document, view));
        view.seconds = 5.0f;
        const std::vector<float> after = test::linear(test::picture(renderer, document, view));
        moved.emplace_back();
        for (const int height : heights)
            moved.back().push_back(middleAt(after, height) - middleAt(before, height));
        for (const float each : moved.back()) std::printf("%8.4f", static_cast<double>(each));
        std::printf(" m in way %d\n", static_cast<int>(shells));
    }
    const float tip = moved[0].back();
    EXPECT_GT(std::abs(tip), 0.005f);
    for (const std::vector<float>& way : moved) {
        EXPECT_LT(std::abs(way.front()), 0.03f * std::abs(tip));
        for (std::size_t i = 0; i + 1 < heights.size(); ++i)
            EXPECT_LE(std::abs(way[i]), std::abs(way[i + 1]) + 0.2f * kPixel);
        for (std::size_t i = 0; i < heights.size(); ++i)
            EXPECT_NEAR(way[i], moved[0][i], 0.08f * std::abs(tip) + 0.3f * kPixel) << i;
    }
}

}  // namespace
}  // namespace pelage
