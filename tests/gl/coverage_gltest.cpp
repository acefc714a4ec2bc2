// coverage_gltest.cpp -- averaged over samples, hair covers what it should: no bias from thinning,
// from thin hairs, or from too few samples.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "core/scatter.h"
#include "core/strand.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

// A ball in hair darker than white.
Document darkBall(float width) {
    Document document = test::furryBall(20000);
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        coat->width = width;
        coat->ambient = coat->diffuse = vec3(0.2f);
        coat->specular = vec3(0.0f);
    }
    return document;
}

struct Line {  // a straight hair from above, m
    vec2 root, tip;
    float width = 0.0f;  // at the root
    float taper = 0.0f;
};

std::vector<Line> hairsFromAbove(const Document& document) {
    const Skin& skin = *document.skin;
    std::vector<Line> lines;
    for (const Root& root : scatterRoots(skin, document.fur.hairs, document.fur.seed).roots) {
        const uvec3 t = skin.triangles[root.triangle];
        const auto fur = [&](uint v) { return furToWorld(skin, v, document.groom.fur[v]); };
        const Strand s =
            growStrand(root, skin.vertices[t.x], skin.vertices[t.y], skin.vertices[t.z], fur(t.x),
                       fur(t.y), fur(t.z), document.fur, 0.0f, 0.0f);
        const vec3 tip = strandPoint(s, 1.0f);
        lines.push_back(
            {vec2(s.origin.x, s.origin.z), vec2(tip.x, tip.z), s.width, document.fur.over.taper});
    }
    return lines;
}

// True if no two of them come nearer than `distance`, m.
bool farApart(const std::vector<Line>& lines, float distance) {
    constexpr int kSteps = 40;
    const auto at = [](const Line& line, int i) {
        return glm::mix(line.root, line.tip, static_cast<float>(i) / kSteps);
    };
    for (std::size_t a = 0; a < lines.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (int i = 0; i <= kSteps; ++i)
                for (int j = 0; j <= kSteps; ++j)
                    if (glm::distance(at(lines[a], i), at(lines[b], j)) < distance) return false;
    return true;
}

TEST(Coverage, HairsOfAnyWidthCoverTheirArea) {
    constexpr float kPixel = 2.0f * test::kHalfSide / 256.0f;  // m
    Document document = test::lyingHair(10);
    while (!farApart(hairsFromAbove(document), 4.0f * kPixel)) ++document.fur.seed;
    View view = test::viewFromAbove(256);
    view.samples = 128;
    Renderer renderer;
    for (const float width : {0.1f, 0.35f, 1.0f, 2.5f}) {  // pixels
        document.fur.over.width = document.fur.under.width = width * kPixel;
        double area = 0.0;  // pixels
        for (const Line& line : hairsFromAbove(document)) {
            // A trapezoid and two half discs.
            const float tip = line.width * (1.0f - line.taper);
            area += static_cast<double>(
                (0.5f * glm::distance(line.root, line.tip) * (line.width + tip) +
                 0.39269908f * (line.width * line.width + tip * tip)) /
                (kPixel * kPixel));
        }
        const double covered = test::coveredPixels(renderer, document, view);
        std::printf("hairs %.2f pixels wide cover %.4f of their area\n", static_cast<double>(width),
                    covered / area);
        EXPECT_NEAR(covered / area, 1.0, 0.01) << width;
    }
}

// Hairs so thin that they do not overlap: the pixels they cover add up.
Document sparseHair() {
    Document document = test::lyingHair(4000);
    document.fur.over.width = document.fur.under.width = 5e-5f;
    return document;
}

TEST(Coverage, ASmallerShareHasNoBias) {
    const Document document = sparseHair();
    View view = test::viewFromAbove(384);
    view.samples = 48;
    Renderer renderer;
    const double full = test::coveredPixels(renderer, document, view);
    for (const float share : {0.5f, 0.25f, 0.125f}) {
        view.detail = {.rule = Detail::Rule::share, .limit = share};
        const double covered = test::coveredPixels(renderer, document, view);
        std::printf("share %.3f covers %.4f of the full coat\n", static_cast<double>(share),
                    covered / full);
        EXPECT_NEAR(covered / full, 1.0, 0.015) << share;
    }
}

TEST(Coverage, CullingByDistanceHasNoBias) {
    const Document document = sparseHair();
    View view = test::viewFromAbove(512);
    view.camera.orthographic = false;
    view.samples = 24;
    Renderer renderer;
    const double full = test::coveredPixels(renderer, document, view);
    const std::size_t all = renderer.draw(document, view).hairsDrawn;
    view.detail.rule = Detail::Rule::distance;
    const double covered = test::coveredPixels(renderer, document, view);
    const std::size_t some = renderer.draw(document, view).hairsDrawn;
    std::printf("%zu of %zu hairs cover %.4f of all\n", some, all, covered / full);
    EXPECT_LT(some, all / 20);
    EXPECT_NEAR(covered / full, 1.0, 0.05);
}

// Where hairs overlap, a smaller share covers a little more than the full coat: its roots are
// spread more evenly over the skin than chance would spread them, so fewer of them overlap.
TEST(Coverage, ASmallerShareOfACoatCoversAsMuch) {
    struct {
        const char* name;
        float width;  // m; 0 = chosen by the program, an opaque coat
    } cases[] = {{"opaque", 0.0f}, {"thin", 3e-3f}};
    for (const auto& c : cases) {
        const Document document = darkBall(c.width);
        View view = test::ballView(document, 128);
        view.samples = 12;
        Renderer renderer;
        const double full = test::coveredPixels(renderer, document, view);
        EXPECT_GT(full, 0.2 * 128 * 128);
        for (const float share : {0.5f, 0.25f, 0.125f}) {
            view.detail = {.rule = Detail::Rule::share, .limit = share};
            const double covered = test::coveredPixels(renderer, document, view);
            std::printf("%s: share %.3f covers %.4f of the full coat\n", c.name,
                        static_cast<double>(share), covered / full);
            EXPECT_NEAR(covered / full, 1.0, 0.05) << c.name << " " << share;
        }
    }
}

TEST(Coverage, ThePictureConverges) {
    Document document = darkBall(3e-3f);
    document.fur.hairs = 5000;
    View view = test::ballView(document, 96);
    const auto values = [&](int samples) {
        Renderer renderer;
        view.samples = samples;
        return test::linear(test::picture(renderer, document, view));
    };
    const std::vector<float> truth = values(256);
    double last = 1e9;
    for (const int samples : {1, 4, 16, 64}) {
        const double error = test::distanceOf(values(samples), truth);
        std::printf("%d samples: error %.5f\n", samples, error);
        EXPECT_LT(error, 0.7 * last) << samples;
        last = error;
    }
    EXPECT_LT(last, 0.02);
}

TEST(Coverage, AnyNumberOfSegmentsGivesTheSameStraightHair) {
    Document document = test::lyingHair(400);
    View view = test::viewFromAbove(128);
    view.samples = 16;
    view.showSkin = false;
    Renderer renderer;
    view.segments = 16;
    const auto fine = test::linear(test::picture(renderer, document, view));
    for (const uint segments : {1u, 2u, 3u, 5u, 8u, 15u}) {
        view.segments = segments;
        const auto coarse = test::linear(test::picture(renderer, document, view));
        EXPECT_LT(test::distanceOf(coarse, fine), 0.02) << segments;
    }
    // Numbers outside [1, 16] count as the nearest in it.
    view.segments = 100;
    // Flat hairs lie at one depth, and where two of them also share the last bits of their ids
    // either may win a pixel.
    EXPECT_LT(test::distanceOf(test::linear(test::picture(renderer, document, view)), fine), 0.003);
    view.segments = 1;
    const auto least = test::linear(test::picture(renderer, document, view));
    view.segments = 0;
    EXPECT_LT(test::distanceOf(test::linear(test::picture(renderer, document, view)), least),
              0.003);
}

}  // namespace
}  // namespace pelage
