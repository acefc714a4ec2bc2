// wind_gltest.cpp -- strands and shells bend alike in the wind.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

constexpr int kSide = 96;        // pixels
constexpr float kPixel = 2e-3f;  // m

// Upright hair, red where x < 0 and green elsewhere, in wind along x that swells everywhere at
// once.
Document twoFields() {
    Document document = test::evenDocument(test::sheet(128));
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.1f, vec3(1.0f), 1.0f});
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const bool left = document.skin->vertices[v].position.x < 0.0f;
        document.groom.fur.edit(v).tint = left ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    }
    Fur& fur = document.fur;
    fur.hairs = 60000;
    fur.share = 1.0f;
    fur.gravity = 0.0f;
    fur.wind = 0.6f;
    fur.windDirection = vec3(1.0f, 0.0f, 0.0f);
    fur.gusts = 1.0f;
    fur.gustSize = 1000.0f;
    fur.gustRate = 0.3f;
    Coat& coat = fur.over;
    coat.diffuse = coat.specular = vec3(0.0f);
    coat.ambient = vec3(0.3f);
    coat.rootColor = coat.tipColor = vec3(1.0f);
    coat.stiffness = 0.3f;
    coat.directionWeight = coat.endRandomness = coat.taper = coat.colorNoise = 0.0f;
    coat.relativeLength = 1.0f;
    coat.width = 3e-3f;
    return document;
}

// m, how far red hair reaches over the border of the skin's colors, as seen from above.
float reachOf(Renderer& renderer, const Document& document, Shells shells, float seconds) {
    View view = test::viewFromAbove(kSide);
    view.camera.distance *= 0.5f * kSide * kPixel / test::kHalfSide;
    view.background = vec3(0.0f);
    view.showSkin = false;
    view.shells = shells;
    view.layers = shells == Shells::swept ? 0u : 96u;
    view.seconds = seconds;
    view.samples = 4;
    const std::vector<float> light = test::linear(test::picture(renderer, document, view));
    double red = 0.0;
    for (int x = 0; x < kSide; ++x) {
        vec2 sum(1e-9f);
        for (int y = 0; y < kSide; ++y) {
            const auto pixel = 3 * static_cast<std::size_t>(y * kSide + x);
            sum += vec2(light[pixel], light[pixel + 1]);
        }
        red += static_cast<double>(sum.x / (sum.x + sum.y));
    }
    return kPixel * (static_cast<float>(red) - 0.5f * kSide);
}

TEST(Wind, MovesStrandsAndShellsAlike) {
    const Document document = twoFields();
    Renderer renderer;
    float calm = 0.0f, blown = 0.0f;  // s, when the wind is at its least and its strongest
    const auto wind = [&](float at) { return pullAt(document.fur, vec3(0.0f), at).x; };
    for (float at = 0.0f; at < 20.0f; at += 0.5f) {
        if (wind(at) < wind(calm)) calm = at;
        if (wind(at) > wind(blown)) blown = at;
    }
    const auto moved = [&](Shells shells) {
        const float before = reachOf(renderer, document, shells, calm);
        const float after = reachOf(renderer, document, shells, blown);
        std::printf("way %d: from %.4f to %.4f m\n", static_cast<int>(shells),
                    static_cast<double>(before), static_cast<double>(after));
        return after - before;
    };
    const float strands = moved(Shells::none);
    EXPECT_GT(strands, 0.01f);
    for (const Shells shells : {Shells::swept, Shells::plain, Shells::instanced})
        EXPECT_NEAR(moved(shells), strands, 0.1f * strands);
}

}  // namespace
}  // namespace pelage
