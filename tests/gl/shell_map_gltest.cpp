// shell_map_gltest.cpp -- shells cut from a picture show what is in it, wherever the skin faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/shell_pictures.h"
#include "core/photo_regions.h"
#include "core/pixels.h"
#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

// Soft spots of light that dies away with the depth, in 8 bits; white, and brown to the left.
Image furPhoto(int side, bool brown = false) {
    const Plane spots = noisePicture({.side = side, .mask = 7});
    Image photo{ivec2(side), {}};
    for (std::size_t i = 0; i < spots.values.size(); ++i) {
        const bool left = 2 * (i % static_cast<std::size_t>(side)) < static_cast<std::size_t>(side);
        const vec3 color = brown && left ? vec3(0.3f, 0.08f, 0.02f) : vec3(1.0f);
        photo.pixels.emplace_back(color * 0.02f * std::exp(std::log(40.0f) * spots.values[i]),
                                  1.0f);
    }
    return drawnPhoto(photo);
}

struct Photo {
    PhotoLayers layers;
    ShellSource source;
};

Photo photoOf(const Image& image, int layers, bool twoColors = false) {
    ShellRecipe recipe{.from = ShellRecipe::From::photo};
    recipe.photo.layers = layers;
    recipe.photo.twoColors = twoColors;
    const ShellPicture picture = photoPicture(std::make_shared<ShellTexture>(
        photoTexture(image, twoColors ? colorRegions(image) : std::vector<unsigned char>())));
    Photo photo{photoLayers(picture, recipe.photo), {}};
    photo.source = shellSource(picture, recipe, photo.layers, 1.0f);
    return photo;
}

ShellSource noiseOf(float coverage, uint layers) {
    ShellRecipe recipe{.from = ShellRecipe::From::noise, .cut = {.coverage = coverage}};
    recipe.photo.layers = static_cast<int>(layers);
    return shellSource(shellPicture(recipe), recipe, 1.0f);
}

// What the shader says of so many places, in the words of its last part.
std::vector<uint> asked(const ShellSource& source, const std::string& code, uint places) {
    const gl::ProgramName program =
        test::computeProgram(test::shaderHead({"types.glsl", "strand.glsl", "shell_data.glsl",
                                               "shell_hair.glsl", "shell_map.glsl"}) +
                             "layout(local_size_x = 64) in;\n"
                             "layout(std430, binding = 0) buffer Results { uint results[]; };\n" +
                             code);
    ShellPictures pictures;
    glBindTextureUnit(binding::shellPicture, pictures.textureOf(source.texture).name());
    const ShellMapData data = mapData(source);
    gl::Buffer block, results;
    block.upload(std::span<const ShellMapData>(&data, 1));
    block.bindUniform(binding::shellMap);
    results.resize(places * sizeof(uint));
    results.bindStorage(0);
    glUseProgram(program.name());
    glDispatchCompute(places / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return test::valuesOf<uint>(results.name(), places);
}

TEST(ShellsOfAPicture, ALayerIsThePixelsThatThePhotographHasInItAndOutside) {
    constexpr int kSide = 64;
    for (const bool twoColors : {false, true}) {
        const Photo photo = photoOf(furPhoto(kSide, twoColors), 16, twoColors);
        ASSERT_EQ(photo.layers.regions.size(), twoColors ? 2u : 1u);
        // The first layer of each pixel; 0 where a layer that is deeper than one with it lacks it.
        const std::vector<uint> first = asked(photo.source, R"(
void main() {
    uint i = gl_GlobalInvocationID.x;
    vec2 size = mapSize();
    MapPlace at = MapPlace((vec2(i % uint(size.x), i / uint(size.x)) + 0.5) / size, 0.0);
    uint found = 0u;
    bool columns = true;
    for (uint k = 1u; k <= mapLayers; ++k) {
        bool there = mapCut(at, 0.0, k, 1.0).there;
        if (there && found == 0u) found = k;
        columns = columns && (there || found == 0u);
    }
    results[i] = columns ? found : 0u;
})",
                                              kSide * kSide);
        std::size_t others = 0;
        for (std::size_t i = 0; i < first.size(); ++i)
            others += first[i] != photo.layers.layerOfPixel[i];
        double apart = 0.0;  // of the shares that layers cover
        for (uint k = 1; k <= 16; ++k) {
            const auto within = [&](auto layer) { return layer > 0 && layer <= k; };
            const auto shown = std::ranges::count_if(first, within);
            const auto held = std::ranges::count_if(photo.layers.layerOfPixel, within);
            apart = std::max(apart, std::abs(static_cast<double>(shown - held)) / (kSide * kSide));
        }
        std::printf("%zu of %zu pixels are in another layer, coverage is off by %.4f at most\n",
                    others, first.size(), apart);
        EXPECT_LT(others, first.size() / 200);  // where a threshold is a tone but for its rounding
        EXPECT_LT(apart, 0.002);
        EXPECT_GT(std::ranges::max(first), 15u);
    }
}

// Coverage of layer 4 in each of 54 parts of a ball, and what mixing the three projections makes
// of it.
struct Coverages {
    std::vector<double> chosen = std::vector<double>(54), mixed = chosen;
};

Coverages onABall(const ShellSource& source) {
    constexpr uint kPlaces = 8192;
    const std::vector<uint> hits = asked(source, R"(
void main() {
    uint i = gl_GlobalInvocationID.x;
    uint part = i / 8192u;
    vec2 across = (vec2(part % 3u, part / 3u % 3u) + vec2(rand01(2u * i), rand01(2u * i + 1u))) / 1.5 - 1.0;
    uint axis = part / 18u;
    vec3 n = normalize(alongAxis(vec3(across, part / 9u % 2u == 0u ? 1.0 : -1.0), (3u - axis) % 3u));
    MapPlace at = mapPlace(n, n, vec3(0.3, -0.5, 0.2));
    at.level = 0.0;
    bool there = mapCut(at, 0.0, 4u, 1.0).there;
    vec3 shares = axisShares(n);
    float mixed = 0.0;
    for (uint k = 0u; k < 3u; ++k) {
        vec4 texel = mapTexel(MapPlace(alongAxis(n, k).xy / mapSide + 0.37 * float(k), 0.0), 0.0);
        mixed += shares[k] * (mapPhoto == 1u ? mapLight(texel.rgb).g : texel.r);
    }
    bool mean = mixed >= (mapPhoto == 1u
        ? mapThreshold(mapTones.xy, 4.0 / float(mapLayers))
        : 1.0 - sqrt(mapCoverage) * (1.0 - mapTaper * (1.0 - 4.0 / float(mapLayers))));
    results[i] = uint(there) + 2u * uint(mean);
})",
                                         54 * kPlaces);
    Coverages covered;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        covered.chosen[i / kPlaces] += (hits[i] & 1u) / static_cast<double>(kPlaces);
        covered.mixed[i / kPlaces] += (hits[i] >> 1u) / static_cast<double>(kPlaces);
    }
    return covered;
}

double farthest(const std::vector<double>& values, double from) {
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::abs(value - from));
    return most;
}

TEST(ShellsOfAPicture, ALayerCoversAsMuchAsInThePictureWhereverTheSkinFaces) {
    Photo photo = photoOf(furPhoto(256), 16);
    photo.source.side = 0.02f;
    const auto& counts = photo.layers.populations;
    const double inPhoto =
        static_cast<double>(std::accumulate(counts.begin(), counts.begin() + 4, std::size_t{0})) /
        (256.0 * 256.0);
    ShellSource noise = noiseOf(0.8f, 16);
    noise.side = 0.02f;
    // (1 - t)^2 of what they cover at the root, three quarters of the way up.
    for (const auto& [source, share] : {std::pair(photo.source, inPhoto), {noise, 0.8 * 0.0625}}) {
        const Coverages covered = onABall(source);
        const double chosen = farthest(covered.chosen, share),
                     mixed = farthest(covered.mixed, share);
        std::printf("%s: layer 4 covers %.3f; off by %.3f at most, mixed by %.3f\n",
                    source.texture->photo ? "photograph" : "noise", share, chosen, mixed);
        EXPECT_LT(chosen, 0.025);
        EXPECT_GT(mixed, chosen);
    }
}

// A flat patch of upright hair that fills the picture, from so many degrees over its plane.
Document patch() {
    Document document = test::evenDocument(test::sheet(2));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 1.0f, 0.0f), 0.02f, vec3(1.0f), 1.0f});
    document.fur.gravity = 0.0f;
    document.fur.share = 1.0f;
    document.fur.hairs = 1000;
    Coat& coat = document.fur.over;
    coat.stiffness = coat.directionWeight = coat.relativeLength = 1.0f;
    return document;
}

View over(float degrees) {
    View view = test::viewFromAbove(128);
    view.camera.pitch = glm::radians(degrees);
    view.camera.distance *= 0.5f;
    view.samples = 4;
    return view;
}

TEST(ShellsOfAPicture, FromAboveLayersShowWhatThePictureCovers) {
    const Document document = patch();
    Renderer renderer;
    View view = over(90.0f);
    view.shells = Shells::swept;
    for (const float coverage : {0.3f, 0.7f}) {
        view.maps[0] = noiseOf(coverage, 8);
        view.maps[0].side = 0.4f;
        const double covered = test::coveredPixels(renderer, document, view) / (128.0 * 128.0);
        std::printf("%.3f of %.3f\n", covered, static_cast<double>(coverage));
        EXPECT_NEAR(covered, coverage, 0.02);
    }
}

TEST(ShellsOfAPicture, APhotographTakesOneTextureHoweverManyLayersAreDrawn) {
    const Document document = test::furryBall(500);
    Renderer renderer;
    View view = test::ballView(document, 24);
    view.shells = Shells::swept;
    view.maps[0] = view.maps[1] = photoOf(furPhoto(256), 16).source;
    for (const uint layers : {16u, 64u}) {
        view.maps[0].layers = view.maps[1].layers = layers;
        const FrameStats stats = renderer.draw(document, view);
        EXPECT_EQ(stats.layers, layers);
        EXPECT_EQ(stats.textureBytes, 349524u);
    }
}

// A ball without flat sides.
Document fineBall() {
    Document document = test::evenDocument(test::ball(4));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 0.0f, 0.5f), 0.2f, vec3(1.0f), 1.0f});
    return document;
}

// As far as single texels go where hair leans; the same picture on other places of the skin is the
// measure.
TEST(ShellsOfAPicture, OnePassShowsWhatTheSkinDrawnForEachLayerShows) {
    const Document document = fineBall();
    Renderer renderer;
    View view = test::ballView(document, 128);
    view.samples = 4;
    const auto shown = [&](ShellSource source, Shells shells, float side) {
        source.side = side;
        view.shells = shells;
        view.maps[0] = view.maps[1] = source;
        return test::linear(test::picture(renderer, document, view));
    };
    for (const int layers : {1, 16}) {
        const ShellSource photo = photoOf(furPhoto(64, true), layers, true).source;
        const ShellSource noise = noiseOf(0.7f, static_cast<uint>(layers));
        for (const ShellSource* source : {&photo, &noise}) {
            const std::vector<float> layered = shown(*source, Shells::instanced, 0.8f);
            const double apart = test::distanceOf(layered, shown(*source, Shells::instanced, 0.7f));
            const double error = test::distanceOf(layered, shown(*source, Shells::swept, 0.8f));
            std::printf("%d layers: RMSE %.4f, of other places %.4f\n", layers, error, apart);
            EXPECT_LT(error, (layers == 1 ? 0.4 : 0.65) * apart);
        }
        view.shells = Shells::instanced;
        view.maps[0] = view.maps[1] = photo;  // has no holes
        const double layered = test::coveredPixels(renderer, document, view);
        view.shells = Shells::swept;
        const double one = test::coveredPixels(renderer, document, view);
        std::printf("covers %.3f times as much\n", one / layered);
        if (layers > 1) {
            EXPECT_NEAR(one / layered, 1.0, 0.03);
        }
    }
}

// Of what is covered where all of the picture grows.
TEST(ShellsOfAPicture, PaintedDensityThinsEveryLayer) {
    Document document = patch();
    Renderer renderer;
    View view = over(90.0f);
    Photo photo = photoOf(furPhoto(256), 16);
    photo.source.side = 0.2f;
    const auto& counts = photo.layers.populations;
    ShellSource noise = noiseOf(0.8f, 8);
    noise.side = 0.1f;
    const auto seenOf = [&](const ShellSource& source, float density) {
        document.groom =
            test::evenGroom(*document.skin, {vec3(0.0f, 1.0f, 0.0f), 0.02f, vec3(1.0f), density});
        view.maps[0] = source;
        return test::coveredPixels(renderer, document, view);
    };
    for (const float density : {0.0f, 0.25f, 0.75f, 1.0f}) {
        // Of a photograph those that reach so far up are left.
        const auto standing = static_cast<std::ptrdiff_t>(16.0f * density);
        const double ofPhoto = static_cast<double>(std::accumulate(
                                   counts.begin(), counts.begin() + standing, std::size_t{0})) /
                               (256.0 * 256.0);
        for (const Shells shells : {Shells::swept, Shells::instanced}) {
            view.shells = shells;
            const double all = seenOf(photo.source, 1.0f);
            const double ofHairs = seenOf(noise, density) / all;
            const double seen = seenOf(photo.source, density) / all;
            std::printf("density %.2f: noise covers %.3f, the photograph %.3f of %.3f\n",
                        static_cast<double>(density), ofHairs, seen, ofPhoto);
            EXPECT_NEAR(ofHairs, 0.8 * static_cast<double>(density), 0.03);
            EXPECT_NEAR(seen, ofPhoto, 0.04);
        }
    }
}

// A ball with upright fur is a disc in the picture, so much greater than the ball.
TEST(ShellsOfAPicture, PaintedLengthIsHowFarLayersStandOff) {
    Document document = fineBall();
    document.fur.gravity = 0.0f;
    document.fur.share = 1.0f;
    document.fur.over.stiffness = document.fur.over.directionWeight = 1.0f;
    document.fur.over.relativeLength = 1.0f;
    Renderer renderer;
    View view = test::ballView(document, 128);
    view.camera.orthographic = true;
    view.samples = 4;
    const float tone = 0.5f;  // a photograph of one tone is all in the outermost layer
    const ShellSource even =
        photoOf(Image{ivec2(8), std::vector<vec4>(64, vec4(vec3(tone), 1.0f))}, 4).source;
    for (const Shells shells : {Shells::swept, Shells::instanced}) {
        view.shells = shells;
        view.maps[0] = even;
        const auto radius = [&](float furLength) {
            document.groom =
                test::evenGroom(*document.skin, {vec3(0.0f), furLength, vec3(1.0f), 1.0f});
            return std::sqrt(test::coveredPixels(renderer, document, view));
        };
        EXPECT_EQ(radius(0.0f), 0.0);
        const double none = radius(1e-3f), half = radius(0.1f), whole = radius(0.2f);
        std::printf("radius %.3f, %.3f of it with half and %.3f with all of the fur\n", none,
                    half / none, whole / none);
        // Layer 1 of 4 lies at three quarters.
        EXPECT_NEAR(half / none, 1.075, 0.02);
        EXPECT_NEAR(whole / none, 1.15, 0.02);
    }
}

TEST(ShellsOfAPicture, OddBodiesAreDrawn) {
    const Document ball = test::furryBall(500);
    Renderer renderer;
    View view = test::ballView(ball, 24);
    const auto draws = [&](const Document& document) {
        const double covered = test::coveredPixels(renderer, document, view);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return covered;
    };
    for (const ShellSource& source : {photoOf(furPhoto(32), 16).source, noiseOf(1.0f, 16)})
        for (const Shells shells : {Shells::swept, Shells::instanced}) {
            view = test::ballView(ball, 24);
            view.shells = shells;
            view.maps[0] = view.maps[1] = source;
            view.maps[0].side = view.maps[1].side = 0.3f;
            Document longer = ball;  // than the body
            longer.groom =
                test::evenGroom(*ball.skin, {vec3(0.0f, 0.5f, 0.5f), 4.0f, vec3(1.0f), 1.0f});
            EXPECT_GT(draws(longer), 100.0);
            const Document needle = test::evenDocument(test::oneMesh(
                {{-1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {1.0f, 1e-6f, 0.0f}}, {{0, 1, 2}}));
            draws(needle);
            view.camera.target = vec3(0.0f);  // from inside
            view.camera.distance = 0.2f;
            draws(ball);
        }
}

TEST(ShellsOfAPicture, OddPicturesAreDrawn) {
    const Document document = test::furryBall(500);
    Renderer renderer;
    View view = test::ballView(document, 24);
    view.showSkin = false;
    const auto drawn = [&](const ShellSource& source) {
        view.maps[0] = source;
        view.maps[0].side = 0.3f;
        const double covered = test::coveredPixels(renderer, document, view);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return covered;
    };
    const Image fur = furPhoto(32);
    Image holes = fur;
    for (std::size_t i = 0; i < holes.pixels.size(); i += 2) holes.pixels[i] = vec4(0.0f);
    view.shells = Shells::swept;
    for (const int layers : {1, 256}) {
        EXPECT_GT(drawn(photoOf(fur, layers).source), 200.0);
        EXPECT_GT(drawn(photoOf(holes, layers).source), 100.0);
        for (const float tone : {0.0f, 0.2f, 1.0f})
            for (const ivec2 size : {ivec2(1), ivec2(3, 1), ivec2(8)}) {
                const Image even{size, std::vector<vec4>(pixelCount(size), vec4(vec3(tone), 1.0f))};
                EXPECT_GT(drawn(photoOf(even, layers).source), 200.0) << tone;
            }
        EXPECT_GT(drawn(noiseOf(1.0f, static_cast<uint>(layers))), 200.0);
    }
}

}  // namespace
}  // namespace pelage
