// renderer_gltest.cpp -- what the renderer promises about samples, counts and odd documents.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/scatter.h"
#include "core/srgb.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

using test::ballView;
using test::furryBall;
using test::picture;
using test::Pixels;

std::size_t distinct(const std::vector<Pixels>& pictures) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        count += std::count(pictures.begin(), pictures.begin() + static_cast<std::ptrdiff_t>(i),
                            pictures[i]) == 0;
    return count;
}

TEST(Renderer, SamplesAreAveragedUntilThePictureIsFinished) {
    Renderer renderer;
    const Document document = furryBall(2000);
    View view = ballView(document, 64);
    view.samples = 5;
    std::vector<Pixels> pictures;
    for (int i = 1; i <= 5; ++i) {
        const FrameStats stats = renderer.draw(document, view);
        EXPECT_EQ(stats.samples, i);
        EXPECT_EQ(stats.finished, i == 5);
        EXPECT_GT(stats.seconds, 0.0);
        pictures.push_back(renderer.pixels());
    }
    EXPECT_EQ(distinct(pictures), 5u);  // each sample adds something
    const Pixels last = renderer.pixels();
    for (int i = 0; i < 3; ++i) {
        const FrameStats stats = renderer.draw(document, view);
        EXPECT_EQ(stats.samples, 5);
        EXPECT_TRUE(stats.finished);
        EXPECT_EQ(renderer.pixels(), last);
    }
}

TEST(Renderer, AnotherDocumentOrViewBeginsThePictureAnew) {
    Renderer renderer;
    Document document = furryBall(1000);
    View view = ballView(document, 32);
    view.samples = 4;
    const auto expectAnew = [&](const char* what) {
        EXPECT_EQ(renderer.draw(document, view).samples, 1) << what;
        EXPECT_EQ(drawFinished(renderer, document, view).samples, 4) << what;
    };
    expectAnew("first");
    view.camera.yaw += 0.1f;
    expectAnew("camera");
    view.size = ivec2(33, 32);
    expectAnew("size");
    view.overlay = Overlay::density;
    expectAnew("overlay");
    view.background.x += 0.1f;
    expectAnew("background");
    view.showSkin = false;
    expectAnew("skin");
    document.groom.fur.edit(3).furLength *= 2.0f;
    expectAnew("groom");
    document.fur.over.stiffness *= 0.5f;
    expectAnew("coat");
    document.fur.hairs = 900;
    expectAnew("hairs");
    document = furryBall(1000);
    expectAnew("document");
    EXPECT_EQ(renderer.draw(document, view).samples, 4);
}

TEST(Renderer, ThePictureIsTheSameOnEveryRun) {
    const Document document = furryBall(4000);
    View view = ballView(document, 128);
    view.samples = 3;
    Renderer first, second;
    const Pixels one = picture(first, document, view);
    EXPECT_EQ(picture(second, document, view), one);
    // Also after something else was drawn.
    picture(first, furryBall(100), ballView(document, 77));
    EXPECT_EQ(picture(first, document, view), one);
}

TEST(Renderer, LinesAreDrawnWithoutANewSampleAndVanish) {
    Renderer renderer;
    const Document document = furryBall(500);
    View view = ballView(document, 64);
    for (const int samples : {1, 3}) {
        view.samples = samples;
        view.lines = {};
        const Pixels bare = picture(renderer, document, view);
        // Before the ball, and through its middle where the skin hides it.
        const vec3 right = view.camera.right(), before = -1.5f * view.camera.forward();
        const OverlayLine near{before - right, before + right, vec4(1, 0, 0, 1)};
        const OverlayLine hidden{-0.5f * right, 0.5f * right, vec4(1, 0, 0, 1)};
        const auto difference = [&](const OverlayLine& line) {
            view.lines = {&line, 1};
            const FrameStats stats = renderer.draw(document, view);
            EXPECT_EQ(stats.samples, samples);
            EXPECT_TRUE(stats.finished);
            return test::distanceOf(test::linear(renderer.pixels()), test::linear(bare));
        };
        const double visible = difference(near), faint = difference(hidden);
        EXPECT_GT(faint, 0.0);
        EXPECT_GT(visible, 3.0 * faint);
        view.lines = {};
        EXPECT_EQ(renderer.draw(document, view).samples, samples);
        EXPECT_EQ(renderer.pixels(), bare);
    }
}

TEST(Renderer, HairsAreCountedByCoat) {
    Renderer renderer;
    Document document = furryBall(3000);
    document.fur.share = 0.3f;
    View view = ballView(document, 64);
    const FrameStats both = renderer.draw(document, view);
    EXPECT_EQ(both.hairsTotal,
              scatterRoots(*document.skin, document.fur.hairs, document.fur.seed).roots.size());
    const Pixels all = renderer.pixels();
    view.showUnder = false;
    const std::size_t over = renderer.draw(document, view).hairsDrawn;
    EXPECT_NE(renderer.pixels(), all);
    view.showUnder = true;
    view.showOver = false;
    const std::size_t under = renderer.draw(document, view).hairsDrawn;
    EXPECT_NE(renderer.pixels(), all);
    EXPECT_EQ(over + under, both.hairsDrawn);
    EXPECT_NEAR(static_cast<double>(over) / static_cast<double>(both.hairsDrawn), 0.3, 0.05);
    view.showUnder = false;
    EXPECT_EQ(renderer.draw(document, view).hairsDrawn, 0u);
}

TEST(Renderer, ABudgetLowersTheHairsDrawn) {
    const Document document = furryBall(10000);
    View view = ballView(document, 32);
    Renderer renderer;
    const std::size_t all = renderer.draw(document, view).hairsDrawn;
    view.detail.milliseconds = 1e-3f;
    const std::size_t few = renderer.draw(document, view).hairsDrawn;
    EXPECT_GT(few, 0u);
    EXPECT_LT(few, all / 4);
    view.detail.milliseconds = 1e9f;
    EXPECT_EQ(renderer.draw(document, view).hairsDrawn, all);
}

TEST(Renderer, DensityZeroDrawsNoHair) {
    Document document = furryBall(2000);
    View view = ballView(document, 32);
    Renderer renderer;
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.1f, vec3(1.0f), 1.0f});
    const std::size_t full = renderer.draw(document, view).hairsDrawn;
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.1f, vec3(1.0f), 0.5f});
    const double half = static_cast<double>(renderer.draw(document, view).hairsDrawn);
    EXPECT_NEAR(half / static_cast<double>(full), 0.5, 0.05);
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.1f, vec3(1.0f), 0.0f});
    EXPECT_EQ(renderer.draw(document, view).hairsDrawn, 0u);
    const Pixels bald = renderer.pixels();
    // Nor does length 0, and the bare skin is lit as if there was no fur.
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.0f, vec3(1.0f), 1.0f});
    EXPECT_EQ(renderer.draw(document, view).hairsDrawn, 0u);
    EXPECT_EQ(renderer.pixels(), bald);
}

TEST(Renderer, OverlaysChangeThePicture) {
    Document document = furryBall(1000);
    document.fur.over.width = document.fur.under.width = 0.01f;  // so that skin shows
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.1f, vec3(1.0f), 0.5f});
    View view = ballView(document, 32);
    Renderer renderer;
    std::vector<Pixels> pictures;
    const std::vector<Overlay> overlays{Overlay::none,      Overlay::length, Overlay::density,
                                        Overlay::direction, Overlay::mask,   Overlay::segment};
    for (const Overlay overlay : overlays) {
        view.overlay = overlay;
        pictures.push_back(picture(renderer, document, view));
    }
    EXPECT_EQ(distinct(pictures), overlays.size());
}

// Mean linear color of a part of the picture.
vec3 meanColor(const Pixels& pixels, ivec2 size, ivec2 from, ivec2 to) {
    const std::vector<float> values = test::linear(pixels);
    vec3 sum(0.0f);
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x)
            for (int c = 0; c < 3; ++c)
                sum[c] += values[static_cast<std::size_t>(3 * (y * size.x + x) + c)];
    return sum / static_cast<float>((to.x - from.x) * (to.y - from.y));
}

TEST(Renderer, LinesOutsideTheFurAreDrawn) {
    Document document = furryBall(0);
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.0f, vec3(1.0f), 1.0f});
    View view = ballView(document, 64);
    Renderer renderer;
    const Pixels bare = picture(renderer, document, view);
    for (const float along : {-1.01f, -2.0f, 3.0f}) {  // m from the middle of a ball of 1 m
        const vec3 at = along * view.camera.forward(), right = 4.0f * view.camera.right();
        const OverlayLine line{at - right, at + right, vec4(1, 0, 0, 1)};
        view.lines = {&line, 1};
        EXPECT_NE(picture(renderer, document, view), bare) << along;
        view.lines = {};
    }
}

// What overlays show on hair alone, left and right half.
TEST(Renderer, OverlaysColorTheHairByTheirOwnField) {
    for (const Overlay overlay : {Overlay::length, Overlay::density, Overlay::mask}) {
        Document document = test::lyingHair(3000);
        for (uint v = 0; v < document.skin->vertices.size(); ++v) {
            const bool right = document.skin->vertices[v].position.x > 0.0f;
            if (overlay == Overlay::length)
                document.groom.fur.edit(v).furLength = right ? 0.1f : 0.02f;
            if (overlay == Overlay::density)
                document.groom.fur.edit(v).density = right ? 1.0f : 0.2f;
            document.groom.mask.edit(v) = (overlay == Overlay::mask) && right ? 1.0f : 0.0f;
        }
        View view = test::viewFromAbove(64);
        view.showSkin = false;
        view.overlay = overlay;
        view.background = vec3(0.0f);
        Renderer renderer;
        const Pixels pixels = picture(renderer, document, view);
        const vec3 left = meanColor(pixels, view.size, ivec2(8, 8), ivec2(24, 56));
        const vec3 right = meanColor(pixels, view.size, ivec2(40, 8), ivec2(56, 56));
        EXPECT_GT(left.z, 2.0f * left.x) << static_cast<int>(overlay);    // cold is blue
        EXPECT_GT(right.x, 2.0f * right.z) << static_cast<int>(overlay);  // hot is red
    }
}

// The first segment is shown orange, the second blue; what belongs to none is grey.
TEST(Renderer, SegmentsAreToldApartByTheirColors) {
    Document document = test::lyingHair(3000);
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.segmentOf.edit(v) = document.skin->vertices[v].position.x > 0.0f ? 0 : 1;
    View view = test::viewFromAbove(64);
    view.overlay = Overlay::segment;
    view.background = vec3(0.0f);
    Renderer renderer;
    for (const bool skin : {true, false}) {
        view.showSkin = skin;
        view.showOver = view.showUnder = !skin;
        const Pixels pixels = picture(renderer, document, view);
        const vec3 left = meanColor(pixels, view.size, ivec2(8, 8), ivec2(24, 56));
        const vec3 right = meanColor(pixels, view.size, ivec2(40, 8), ivec2(56, 56));
        EXPECT_GT(left.z, 1.5f * left.x) << skin;
        EXPECT_GT(right.x, 1.5f * right.z) << skin;
    }
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.segmentOf.edit(v) = kNoSegment;
    view.showSkin = true;
    view.showOver = view.showUnder = false;
    const vec3 none = meanColor(picture(renderer, document, view), view.size, ivec2(8), ivec2(56));
    EXPECT_NEAR(none.x / none.y, 1.0f, 0.25f);
    EXPECT_GT(none.x, 0.0f);
}

TEST(Renderer, OddSizesWork) {
    const Document document = furryBall(500);
    Renderer renderer;
    for (const ivec2 size : {ivec2(1, 1), ivec2(3, 7), ivec2(257, 2), ivec2(1, 300)}) {
        View view = ballView(document, 1);
        view.size = size;
        view.samples = 2;
        const Pixels pixels = picture(renderer, document, view);
        ASSERT_EQ(pixels.size(), static_cast<std::size_t>(4 * size.x * size.y));
        // The ball is in the middle.
        const std::size_t middle = static_cast<std::size_t>((size.y / 2) * size.x + size.x / 2);
        EXPECT_EQ(pixels[4 * middle + 3], 255);
    }
}

TEST(Renderer, SizeZeroIsRefused) {
    const Document document = furryBall(10);
    Renderer renderer;
    for (const ivec2 size : {ivec2(0, 5), ivec2(5, 0), ivec2(-1, 5)}) {
        View view = ballView(document, 1);
        view.size = size;
        try {
            renderer.draw(document, view);
            ADD_FAILURE() << size.x << "x" << size.y;
        } catch (const std::runtime_error& error) {
            const std::string wanted = std::to_string(size.x) + " x " + std::to_string(size.y);
            EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
        }
    }
}

TEST(Renderer, SmallDocumentsAreDrawn) {
    const std::vector<vec3> corners{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    struct {
        const char* name;
        std::vector<uvec3> triangles;
        uint hairs;
        bool hairy, anything;
    } cases[] = {
        {"no hairs", {{0, 1, 2}}, 0, false, true},
        {"no triangles", {}, 1000, false, false},
        {"one triangle", {{0, 1, 2}}, 1000, true, true},
        {"one hair", {{0, 1, 2}}, 1, true, true},
        {"a triangle without area", {{0, 1, 1}}, 1000, false, false},
    };
    for (const auto& c : cases) {
        SCOPED_TRACE(c.name);
        Document document = test::evenDocument(test::oneMesh(corners, c.triangles));
        document.groom = test::evenGroom(*document.skin, {vec3(0.0f), 0.1f, vec3(1.0f), 1.0f});
        document.fur.hairs = c.hairs;
        View view = ballView(document, 48);
        view.samples = 2;
        Renderer renderer;
        const FrameStats stats = drawFinished(renderer, document, view);
        EXPECT_TRUE(stats.finished);
        EXPECT_EQ(stats.hairsDrawn > 0, c.hairy);
        const Pixels pixels = renderer.pixels();
        bool empty = true;
        for (std::size_t i = 4; i < pixels.size(); ++i) empty = empty && pixels[i] == pixels[i % 4];
        EXPECT_EQ(empty, !c.anything);
    }
}

TEST(Renderer, TheBackgroundIsDisplayEncoded) {
    Document document = furryBall(0);
    View view = ballView(document, 4);
    view.showSkin = false;
    view.background = vec3(0.0f, 0.21404114f, 1.0f);  // linear of 0, 0.5, 1
    Renderer renderer;
    const Pixels pixels = picture(renderer, document, view);
    EXPECT_EQ(pixels[0], 0);
    EXPECT_NEAR(pixels[1], 127.5, 1.0);
    EXPECT_EQ(pixels[2], 255);
    EXPECT_EQ(pixels[3], 255);
}

TEST(Renderer, ATransparentPictureLaidOverTheBackgroundIsTheOpaqueOne) {
    const Document document = furryBall(2000);
    Renderer renderer;
    for (const int samples : {1, 7, 16}) {
        View view = ballView(document, 48);
        view.samples = samples;
        const Pixels opaque = picture(renderer, document, view);
        view.transparent = true;
        const Pixels seen = picture(renderer, document, view);
        std::size_t between = 0;
        int worst = 0;
        for (std::size_t p = 0; p < seen.size(); p += 4) {
            const float alpha = static_cast<float>(seen[p + 3]) / 255.0f;
            // So many samples covered the pixel.
            EXPECT_NEAR(alpha * static_cast<float>(samples),
                        std::round(alpha * static_cast<float>(samples)), 0.04f);
            between += alpha > 0.0f && alpha < 1.0f;
            EXPECT_EQ(opaque[p + 3], 255);
            for (std::size_t c = 0; c < 3; ++c) {
                if (seen[p + c] == 255) continue;  // light over 1 is cut off
                const float own = linearFromSrgb(static_cast<float>(seen[p + c]) / 255.0f);
                const float over =
                    alpha * own + (1.0f - alpha) * view.background[static_cast<int>(c)];
                const auto byte = static_cast<int>(std::lround(255.0f * srgbFromLinear(over)));
                worst = std::max(worst, std::abs(byte - opaque[p + c]));
            }
        }
        EXPECT_LE(worst, 1) << samples;
        EXPECT_EQ(between > 0, samples > 1);
        EXPECT_EQ(seen[3], 0) << "nothing is in the corner";
    }
}

TEST(Renderer, TextureColorArrivesAtTheHairTheRightWayUp) {
    Source source = test::sheet(8);
    for (const vec3& p : source.positions) source.uvs.emplace_back(p.x + 0.5f, p.z + 0.5f);
    source.images.push_back({"quarters", test::quartersPng(16)});  // red, blue; green, black
    SourceMaterial material;
    material.image = 0;
    source.materials.push_back(material);
    source.parts[0].material = 0;
    const Document document = test::lyingHair(8000, std::move(source));
    View view = test::viewFromAbove(96);  // x to the right, -z up
    view.background = vec3(0.0f);
    Renderer renderer;
    for (const bool showSkin : {false, true}) {
        view.showSkin = showSkin;
        const Pixels pixels = picture(renderer, document, view);
        const auto quarter = [&](int x, int y) {
            return meanColor(pixels, view.size, ivec2(14 + 48 * x, 14 + 48 * y),
                             ivec2(34 + 48 * x, 34 + 48 * y));
        };
        const vec3 red = quarter(0, 0), blue = quarter(1, 0), green = quarter(0, 1);
        EXPECT_GT(red.x, 0.05f);
        EXPECT_GT(red.x, 5.0f * std::max(red.y, red.z));
        EXPECT_GT(blue.z, 0.05f);
        EXPECT_GT(blue.z, 5.0f * std::max(blue.x, blue.y));
        EXPECT_GT(green.y, 0.05f);
        EXPECT_GT(green.y, 5.0f * std::max(green.x, green.z));
        EXPECT_LT(glm::length(quarter(1, 1)), 0.02f);
    }
}

TEST(Renderer, VertexColorArrivesAtTheHair) {
    Source source = test::sheet(8);
    for (const vec3& p : source.positions)
        source.colors.push_back(p.x < 0.0f ? vec4(1, 0, 0, 1) : vec4(0, 0, 1, 1));
    const Document document = test::lyingHair(4000, std::move(source));
    View view = test::viewFromAbove(64);
    view.showSkin = false;
    view.background = vec3(0.0f);
    Renderer renderer;
    const Pixels pixels = picture(renderer, document, view);
    const vec3 left = meanColor(pixels, view.size, ivec2(8, 8), ivec2(22, 56));
    const vec3 right = meanColor(pixels, view.size, ivec2(42, 8), ivec2(56, 56));
    EXPECT_GT(left.x, 5.0f * left.z);
    EXPECT_GT(right.z, 5.0f * right.x);
}

TEST(Renderer, NothingPerHairIsStoredButItsRoot) {
    Renderer renderer;
    const Document few = furryBall(1000), many = furryBall(101000);
    View view = ballView(few, 16);
    view.detail = {.rule = Detail::Rule::share, .limit = 0.02f};
    renderer.draw(few, view);
    const std::size_t before = renderer.bytes();
    renderer.draw(many, view);
    EXPECT_EQ(renderer.bytesPerHair(), 16u);
    const double perHair = static_cast<double>(renderer.bytes() - before) / 100000.0;
    EXPECT_NEAR(perHair, 16.0, 2.0);  // the rest is the plan of the frame
}

}  // namespace
}  // namespace pelage
