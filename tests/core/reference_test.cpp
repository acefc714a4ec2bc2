// reference_test.cpp -- the traced picture against what can be reckoned without tracing.
#include "core/reference.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/scatter.h"
#include "core/strands_out.h"
#include "test_skins.h"

namespace pelage {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStraightShare = 0.45;  // of fiber.glsl

// A sheet of 1 m with upright white hair.
Document upright(uint hairs, float length, float width, float taper) {
    Document document = test::evenDocument(test::sheet(1));
    document.groom = test::evenGroom(*document.skin, {vec3(0.0f), length, vec3(1.0f), 1.0f});
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        *coat = Coat{};
        coat->ambient = coat->diffuse = coat->rootColor = coat->tipColor = vec3(1.0f);
        coat->stiffness = coat->relativeLength = coat->shininess = 1.0f;
        coat->clumpShape = 1.0f;
        coat->style = kStylePolyline;
        coat->width = width;
        coat->taper = taper;
    }
    document.fur.gravity = document.fur.wind = 0.0f;
    document.fur.hairs = hairs;
    return document;
}

Document oneHair(float length, float width, float taper) {
    Document document = upright(1, length, width, taper);
    while (scatterRoots(*document.skin, 1, document.fur.seed).roots.size() != 1)
        ++document.fur.seed;
    return document;
}

Document furryBall(uint hairs) {
    Document document = test::evenDocument(test::ball(2));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 0.0f, 0.5f), 0.2f, vec3(1.0f), 1.0f});
    document.fur.hairs = hairs;
    return document;
}

// White from all sides, and nothing else.
Light furnace() {
    Light light{};
    light.toKey = vec3(0.0f, 1.0f, 0.0f);
    light.sky = light.ground = vec3(1.0f);
    return light;
}

Light keyOnly(vec3 toKey) {
    Light light{};
    light.toKey = glm::normalize(toKey);
    light.key = 1.0f;
    return light;
}

// Without perspective, from an angle to the vertical, at a place in the middle of the picture.
ReferenceView fromAngle(double angle, vec3 middle, ivec2 size, float pixel) {
    ReferenceView view;
    view.size = size;
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    view.forward = vec3(0.0f, -c, -s);
    view.up = vec3(0.0f, s, -c);
    view.eye = middle - view.forward;
    view.orthographic = true;
    view.halfHeight = 0.5f * static_cast<float>(size.y) * pixel;
    view.light = furnace();
    return view;
}

ReferenceView ofBall(int side) {
    ReferenceView view;
    view.size = ivec2(side);
    view.eye = vec3(0.0f, 0.0f, 4.0f);
    view.halfHeight = 0.33f;
    view.light = furnace();
    view.light.toKey = glm::normalize(vec3(-0.5f, 0.8f, 0.6f));
    view.light.key = 1.0f;
    return view;
}

ReferencePicture traced(const Document& document, const ReferenceView& view, uint samples,
                        const ReferenceOptions& options = {}) {
    ReferencePicture picture(std::make_shared<const ReferenceScene>(document, options), view);
    picture.add(samples);
    return picture;
}

vec4 sumOf(const ReferencePicture& picture) {
    glm::dvec4 sum(0.0);
    for (const vec4& pixel : picture.pixels()) sum += glm::dvec4(pixel);
    return vec4(sum);
}

double distanceOf(const std::vector<vec4>& a, const std::vector<vec4>& b, int channels) {
    double sum = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p)
        for (int c = 4 - channels; c < 4; ++c)
            sum += std::pow(static_cast<double>(a[p][c] - b[p][c]), 2.0);
    return std::sqrt(sum / static_cast<double>(a.size()) / channels);
}

ReferenceOptions withoutSkin() {
    ReferenceOptions options;
    options.skin = false;
    return options;
}

// Outline of a cone with a ball of radius r at its foot, seen from an angle to its axis.
double areaOfCone(double r, double height, double angle) {
    const double across = height * std::sin(angle);
    return r * std::sqrt(across * across - r * r) + r * r * (kPi - std::acos(r / across));
}

// The same with a flat foot.
double areaOfFlatCone(double r, double height, double angle) {
    const double across = height * std::tan(angle);
    return std::cos(angle) *
           (r * std::sqrt(across * across - r * r) + r * r * (kPi - std::acos(r / across)));
}

TEST(Reference, ATaperedHairCoversTheOutlineOfACone) {
    constexpr float kPixel = 1e-3f;
    constexpr double kLength = 64.0, kRadius = 1.0;  // pixels
    Document document = oneHair(static_cast<float>(kLength) * kPixel, 2.0f * kPixel, 1.0f);
    const Curves hair = growCurves(document, scatterRoots(*document.skin, 1, document.fur.seed), 1);
    ASSERT_EQ(hair.root.size(), 1u);
    const vec3 middle = 0.5f * (hair.points[0] + hair.points[1]);
    for (const double degrees : {10.0, 45.0, 70.0}) {
        const double angle = degrees * kPi / 180.0;
        const ivec2 size(8, static_cast<int>(kLength * std::sin(angle)) + 6);
        const double pixels = size.x * size.y;
        ReferenceView view = fromAngle(angle, middle, size, kPixel);
        view.shadows = Shadows::live;
        const double alone =
            static_cast<double>(sumOf(traced(document, view, 1024, withoutSkin())).a);
        const double ball = areaOfCone(kRadius, kLength, angle);
        EXPECT_NEAR(alone / ball, 1.0, 2.5e-3);
        // On white skin black hair is what is missing; half of the ball is under it.
        Document black = document;
        for (Coat* coat : {&black.fur.over, &black.fur.under})
            coat->ambient = coat->diffuse = vec3(0.0f);
        const double covered =
            1.0 - static_cast<double>(sumOf(traced(black, view, 1024)).g) / pixels;
        const double flat = areaOfFlatCone(kRadius, kLength, angle);
        std::printf("from %.0f degrees %.5f, with skin %.5f; exactly %.5f and %.5f\n", degrees,
                    alone / pixels, covered, ball / pixels, flat / pixels);
        EXPECT_NEAR(covered, flat / pixels, 1e-3);
        // A ribbon has no round foot.
        const double ribbon = kRadius * kLength * std::sin(angle);
        EXPECT_GT(std::abs(ribbon / flat - 1.0), 5.0 * std::abs(pixels * covered / flat - 1.0));
    }
}

TEST(Reference, AHairThatPointsAtTheEyeCoversTheCircleOfItsFoot) {
    constexpr float kPixel = 1e-3f;
    const Document document = oneHair(0.05f, 8.0f * kPixel, 0.5f);
    const Curves hair = growCurves(document, scatterRoots(*document.skin, 1, document.fur.seed), 1);
    ReferenceView view = fromAngle(0.0, hair.points[1], ivec2(16), kPixel);
    EXPECT_NEAR(static_cast<double>(sumOf(traced(document, view, 256, withoutSkin())).a),
                16.0 * kPi, 0.01);
    // With perspective, 2 cm above the tip, the tip of radius 2 mm hides what is behind it.
    view.orthographic = false;
    view.eye = hair.points[1] + vec3(0.0f, 0.02f, 0.0f);
    view.halfHeight = 8.0f * kPixel / 0.02f;
    const double sine = 2.0 / 20.0, radius = sine / std::sqrt(1.0 - sine * sine) * 20.0;
    EXPECT_NEAR(static_cast<double>(sumOf(traced(document, view, 256, withoutSkin())).a),
                kPi * radius * radius, 0.02);
}

TEST(Reference, WhiteSkinAndWhiteHairInAFurnaceAreWhite) {
    for (const Shadows shadows : {Shadows::traced, Shadows::live}) {
        ReferenceView view = fromAngle(0.5, vec3(0.0f), ivec2(8), 0.02f);
        view.shadows = shadows;
        const vec4 skin = sumOf(traced(upright(0, 0.1f, 1e-3f, 0.0f), view, 16));
        EXPECT_NEAR(skin.a, 64.0f, 1e-3f);
        EXPECT_NEAR(skin.g, skin.a, 1e-3f);
    }
    // Hair by itself: of light that is the same from everywhere it sends on what it gets.
    const ReferenceView view = fromAngle(1.0, vec3(0.0f), ivec2(32), 0.05f);
    const vec4 hair = sumOf(traced(oneHair(0.5f, 0.05f, 0.3f), view, 64, withoutSkin()));
    EXPECT_GT(hair.a, 1.0f);
    EXPECT_NEAR(hair.g, hair.a, 1e-3f * hair.a);
}

TEST(Reference, NoCoatSendsMoreThanTheFurnaceGivesIt) {
    const ReferenceView view = fromAngle(0.6, vec3(0.0f), ivec2(32), 0.005f);
    const ReferencePicture picture = traced(upright(5000, 0.05f, 3e-3f, 0.5f), view, 16);
    for (const vec4& pixel : picture.pixels()) EXPECT_LE(pixel.g, pixel.a + 1e-5f);
    EXPECT_LT(sumOf(picture).g, 0.9f * sumOf(picture).a);
}

// Light that a coat of upright hair lets through to the skin: hair that is black, seen from above,
// so that what it does not cover tells.
double reachingSkin(const Light& light, Shadows shadows) {
    constexpr double kHairs = 50000.0, kLength = 0.02, kWidth = 1e-3;  // of optical depth 1
    Document document = upright(static_cast<uint>(kHairs), static_cast<float>(kLength),
                                static_cast<float>(kWidth), 0.0f);
    for (Coat* coat : {&document.fur.over, &document.fur.under})
        coat->ambient = coat->diffuse = vec3(0.0f);
    constexpr double kAngle = 0.01;  // Embree misses ends of cylinders seen at less than 0.001
    ReferenceView view = fromAngle(kAngle, vec3(0.0f), ivec2(64), 0.6f / 64.0f);
    view.light = light;
    view.shadows = shadows;
    ReferenceOptions options;
    options.segments = 1;
    const double bare = std::exp(-kHairs * kWidth * (kPi / 4.0 * kWidth + kLength * kAngle));
    return static_cast<double>(sumOf(traced(document, view, 32, options)).g) / 64.0 / 64.0 / bare;
}

TEST(Reference, LightThatReachesTheSkinIsTheIntegralOverTheCoat) {
    // From one direction e^-(share tan), from all of them its mean weighted by the cosine.
    double sky = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
        const double angle = (i + 0.5) * 0.5 * kPi / kSteps;
        sky += std::sin(2.0 * angle) * std::exp(-kStraightShare * std::tan(angle)) * 0.5 * kPi /
               kSteps;
    }
    const Light key = keyOnly(vec3(0.6f, 1.0f, 0.8f));  // at 45 degrees
    const double straight = std::sqrt(0.5) * std::exp(-kStraightShare);
    EXPECT_NEAR(reachingSkin(furnace(), Shadows::traced), sky, 0.01);
    EXPECT_NEAR(reachingSkin(furnace(), Shadows::live), sky, 0.01);
    EXPECT_NEAR(reachingSkin(key, Shadows::traced), straight, 0.01);
    EXPECT_NEAR(reachingSkin(key, Shadows::live), straight, 0.01);
}

TEST(Reference, SkinBlocksLight) {
    // Two sheets, the light above, the eye between them: the lower one lies in the shadow.
    Document document = test::evenDocument(test::twoSheets(2, 0.2f));
    document.fur.hairs = 0;
    ReferenceView view = fromAngle(0.0, vec3(0.0f, -0.1f, 0.0f), ivec2(8), 0.01f);
    view.orthographic = false;
    view.eye = vec3(0.0f);
    view.halfHeight = 0.5f;
    view.light = keyOnly(vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(sumOf(traced(document, view, 4)), vec4(0.0f, 0.0f, 0.0f, 64.0f));
    view.light = keyOnly(vec3(1.0f, 0.02f, 0.0f));  // from the side
    EXPECT_GT(sumOf(traced(document, view, 4)).g, 0.5f);
}

TEST(Reference, ThePictureIsTheSameForAnyNumberOfThreadsAndCalls) {
    const auto scene = std::make_shared<const ReferenceScene>(furryBall(2000));
    const auto pixels = [&](std::size_t threads, uint seed, const std::vector<uint>& calls) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        ReferenceView view = ofBall(32);
        view.seed = seed;
        ReferencePicture picture(scene, view);
        for (const uint samples : calls) picture.add(samples);
        EXPECT_EQ(picture.samples(), 8u);
        EXPECT_GT(picture.rays(), 8u * 32u * 32u);
        return picture.pixels();
    };
    const std::vector<vec4> once = pixels(1, 1, {8});
    EXPECT_EQ(pixels(2, 1, {8}), once);
    EXPECT_EQ(pixels(2, 1, {1, 4, 2}), once);
    EXPECT_NE(pixels(1, 2, {8}), once);
}

TEST(Reference, FurtherPicturesByTheSameRaysAreAsTheyWouldBeAlone) {
    const auto scene = std::make_shared<const ReferenceScene>(furryBall(500));
    ReferenceView view = ofBall(24);
    view.shadows = Shadows::live;
    const std::vector<Lighting> more = {
        {Shadows::traced, {}}, {Shadows::live, kStyleTube}, {Shadows::traced, kStyleRibbon}};
    ReferencePicture all(scene, view, more);
    all.add(4);
    all.add(8);
    ReferencePicture first(scene, view);
    first.add(12);
    EXPECT_EQ(all.pixels(), first.pixels());
    for (std::size_t i = 0; i < more.size(); ++i) {
        ReferenceView other = view;
        other.shadows = more[i].shadows;
        other.style = more[i].style;
        ReferencePicture alone(scene, other);
        alone.add(12);
        EXPECT_EQ(all.pixels(i + 1), alone.pixels()) << i;
        EXPECT_EQ(all.noise(vec3(0.2f), i + 1).color, alone.noise(vec3(0.2f)).color) << i;
        EXPECT_NE(all.pixels(i + 1), all.pixels()) << i;
        if (other.shadows == Shadows::traced) {
            EXPECT_EQ(all.rays(), alone.rays()) << i;
        }
    }
}

TEST(Reference, ACancelledCallLeavesThePictureAsItWas) {
    ReferencePicture picture(std::make_shared<const ReferenceScene>(furryBall(500)), ofBall(48));
    picture.add(2);
    const std::vector<vec4> before = picture.pixels();
    const std::size_t rays = picture.rays();
    Progress progress;
    progress.cancel = true;
    EXPECT_THROW(picture.add(4, &progress), Cancelled);
    EXPECT_EQ(picture.pixels(), before);
    EXPECT_EQ(picture.samples(), 2u);
    EXPECT_EQ(picture.rays(), rays);
    progress.cancel = false;
    picture.add(4, &progress);
    EXPECT_EQ(progress.done, 1.0f);
    progress.cancel = true;
    EXPECT_THROW(ReferenceScene(furryBall(500), {}, &progress), Cancelled);
}

TEST(Reference, NoiseIsTheTrueErrorAndFallsAsThatOfStratifiedSamplesDoes) {
    const auto scene = std::make_shared<const ReferenceScene>(furryBall(2000));
    ReferenceView view = ofBall(20);
    ReferencePicture few(scene, view), truth(scene, [&] {
        ReferenceView other = view;
        other.seed = 77;
        return other;
    }());
    truth.add(2048);
    double coverage16 = 0.0;
    for (const uint samples : {16u, 64u, 256u}) {
        few.add(samples - few.samples());
        const ReferenceNoise noise = few.noise(vec3(0.0f));
        // Colors are compared over black, so that they are as the picture has them.
        double color = 0.0;
        const auto a = few.pixels(), b = truth.pixels();
        for (std::size_t p = 0; p < a.size(); ++p) {
            const vec3 apart(a[p] - b[p]);
            color += static_cast<double>(glm::dot(apart, apart)) / 3.0;
        }
        color = std::sqrt(color / static_cast<double>(a.size()));
        const double coverage = distanceOf(a, b, 1);
        std::printf("%3u samples: noise %.4f of color, %.4f of coverage; in truth %.4f, %.4f\n",
                    samples, static_cast<double>(noise.color), static_cast<double>(noise.coverage),
                    color, coverage);
        EXPECT_NEAR(static_cast<double>(noise.color) / color, 1.0, 0.2);
        EXPECT_NEAR(static_cast<double>(noise.coverage) / coverage, 1.0, 0.25);
        if (samples == 16) coverage16 = coverage;
        // Independent samples would make it a quarter.
        if (samples == 256) {
            EXPECT_LT(coverage, coverage16 / 5.0);
        }
    }
}

TEST(Reference, WithoutSkinOrHairThereIsNothing) {
    for (const Shadows shadows : {Shadows::traced, Shadows::live}) {
        ReferenceView view = ofBall(8);
        view.shadows = shadows;
        Document empty = test::evenDocument(test::oneMesh({}, {}));
        EXPECT_EQ(sumOf(traced(empty, view, 2)), vec4(0.0f));
        Document bald = furryBall(0);
        EXPECT_GT(sumOf(traced(bald, view, 2)).a, 10.0f);
        EXPECT_EQ(sumOf(traced(bald, view, 2, withoutSkin())), vec4(0.0f));
    }
}

TEST(Reference, CoatsThatAreNotWantedAreLeftOut) {
    const Document document = furryBall(3000);
    ReferenceOptions over, under;
    over.under = under.over = false;
    const std::size_t both = ReferenceScene(document).hairs();
    const std::size_t ofOver = ReferenceScene(document, over).hairs();
    const std::size_t ofUnder = ReferenceScene(document, under).hairs();
    EXPECT_EQ(ofOver + ofUnder, both);
    EXPECT_NEAR(static_cast<double>(ofOver) / static_cast<double>(both),
                static_cast<double>(document.fur.share), 0.05);
}

TEST(Reference, TheStyleOfACoatIsHowItsHairIsLitNotItsShape) {
    Document document = furryBall(500);
    for (Coat* coat : {&document.fur.over, &document.fur.under}) coat->style = kStylePolyline;
    const auto lines = traced(document, ofBall(24), 2).pixels();
    const auto scene = std::make_shared<const ReferenceScene>(document);
    for (const uint style : {kStyleLine, kStyleRibbon, kStyleCurve, kStyleTube}) {
        document.fur.over.style = document.fur.under.style = style;
        const auto others = traced(document, ofBall(24), 2).pixels();
        EXPECT_NE(others, lines);
        for (std::size_t p = 0; p < lines.size(); ++p) EXPECT_EQ(others[p].a, lines[p].a);
        // A view may ask for the light of any style.
        ReferenceView view = ofBall(24);
        view.style = style;
        ReferencePicture picture(scene, view);
        picture.add(2);
        EXPECT_EQ(picture.pixels(), others);
    }
}

TEST(Reference, ARoundHairIsLitAsACylinderIs) {
    // From straight ahead a matt cylinder that faces the light is brightest in the middle: over its
    // width x in [-1, 1] it has the square root of 1 - x^2.
    constexpr float kPixelSize = 1e-3f;
    Document document = oneHair(0.2f, 16.0f * kPixelSize, 0.0f);
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        coat->ambient = coat->specular = vec3(0.0f);
        coat->style = kStyleTube;
    }
    const Curves hair = growCurves(document, scatterRoots(*document.skin, 1, document.fur.seed), 1);
    const vec3 middle = 0.5f * (hair.points[0] + hair.points[1]);
    ReferenceView view = fromAngle(kPi / 2.0, middle, ivec2(16, 2), kPixelSize);
    view.shadows = Shadows::live;
    view.light = keyOnly(-view.forward);
    const std::vector<vec4> across = traced(document, view, 256, withoutSkin()).pixels();
    const auto area = [](double x) { return 0.5 * (x * std::sqrt(1.0 - x * x) + std::asin(x)); };
    // Half of the light is that of a thin line, whose sine is 1; the skin's normal is at a right
    // angle to the key light, so that half of it is in shadow.
    const double whole =
        static_cast<double>(across[8].g) / (1.0 + 8.0 * (area(1.0 / 8.0) - area(0.0)));
    for (int x = 0; x < 8; ++x) {
        const double mean = 8.0 * (area((x + 1) / 8.0) - area(x / 8.0));
        EXPECT_NEAR(static_cast<double>(across[static_cast<std::size_t>(8 + x)].g) / whole,
                    1.0 + mean, 0.02)
            << x;
    }
}

TEST(Reference, ASkinThatStandsElsewhereTakesItsHairAlong) {
    const Document document = furryBall(500);
    const vec3 step(3.0f, -1.0f, 2.0f);
    Skin moved = *document.skin;
    for (SkinVertex& vertex : moved.vertices) vertex.position += step;
    ReferenceOptions options;
    options.posed = std::make_shared<const Skin>(moved);
    ReferenceView view = ofBall(24);
    const std::vector<vec4> here = traced(document, view, 16).pixels();
    view.eye += step;
    const std::vector<vec4> there = traced(document, view, 16, options).pixels();
    // Rounding moves the edges of hairs by a millionth.
    EXPECT_LT(distanceOf(here, there, 4), 0.02);
}

TEST(Reference, HairsThatNeedTooMuchMemoryAreRefusedWithNumbers) {
    ReferenceOptions options;
    options.memory = 1000;
    try {
        const ReferenceScene scene(furryBall(500), options);
        FAIL() << "was built";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("hairs of 16 segments need about"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Reference, MoreSegmentsAreTakenWhereHairCurls) {
    Document document = furryBall(10);
    EXPECT_EQ(ReferenceScene(document).segments(), 16u);
    document.fur.over.curlRadius = 0.1f;
    document.fur.over.curlTurns = 2.0f;
    EXPECT_EQ(ReferenceScene(document).segments(), 40u);
    ReferenceOptions options;
    options.segments = 5;
    EXPECT_EQ(ReferenceScene(document, options).segments(), 5u);
}

TEST(Reference, ASizeThatCannotBeTracedIsRefused) {
    const auto scene = std::make_shared<const ReferenceScene>(furryBall(0));
    ReferenceView view;
    for (const ivec2 size : {ivec2(0, 5), ivec2(5, -1), ivec2(16385, 5)}) {
        view.size = size;
        EXPECT_THROW(ReferencePicture(scene, view), std::runtime_error);
    }
}

}  // namespace
}  // namespace pelage
