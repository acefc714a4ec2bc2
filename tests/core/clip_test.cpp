// clip_test.cpp -- values between keys, and what is read of animations and refused.
#include "core/clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "animated.h"
#include "core/gltf_in.h"
#include "core/rig.h"

namespace pelage {
namespace {

using test::addChannel;
using test::GltfMaker;

Track trackOf(Interpolation interpolation, std::size_t width, std::vector<float> times,
              std::vector<float> values, ClipPath path = ClipPath::translation) {
    return {0, path, interpolation, width, std::move(times), std::move(values)};
}

TEST(Clip, StepsHoldTheKeyBefore) {
    const Track track = trackOf(Interpolation::step, 1, {0.0f, 1.0f, 3.0f}, {5.0f, 6.0f, 7.0f});
    EXPECT_EQ(valueAt(track, 0.99f), std::vector<float>{5.0f});
    EXPECT_EQ(valueAt(track, 1.0f), std::vector<float>{6.0f});
    EXPECT_EQ(valueAt(track, 2.99f), std::vector<float>{6.0f});
}

TEST(Clip, LinesAreStraightBetweenKeys) {
    const Track track = trackOf(Interpolation::linear, 2, {1.0f, 3.0f}, {0.0f, 4.0f, 8.0f, 0.0f});
    EXPECT_EQ(valueAt(track, 1.5f), (std::vector<float>{2.0f, 3.0f}));
}

TEST(Clip, TheEndsHoldBeforeAndAfterTheKeys) {
    for (const auto kind : {Interpolation::step, Interpolation::linear, Interpolation::cubic}) {
        const bool cubic = kind == Interpolation::cubic;
        const Track track =
            trackOf(kind, 1, {1.0f, 2.0f},
                    cubic ? std::vector<float>{9, 3, 9, 9, 4, 9} : std::vector<float>{3, 4});
        EXPECT_EQ(valueAt(track, -5.0f), std::vector<float>{3.0f});
        EXPECT_EQ(valueAt(track, 1.0f), std::vector<float>{3.0f});
        EXPECT_EQ(valueAt(track, 2.0f), std::vector<float>{4.0f});
        EXPECT_EQ(valueAt(track, 1e30f), std::vector<float>{4.0f});
    }
}

TEST(Clip, CubicCurvesFollowTheirTangents) {
    // The polynomial x^3 - 2 x has slope 3 x^2 - 2; one curve between keys has its shape.
    const auto value = [](float x) { return x * x * x - 2.0f * x; };
    const auto slope = [](float x) { return 3.0f * x * x - 2.0f; };
    const Track track = trackOf(Interpolation::cubic, 1, {-1.0f, 1.0f},
                                {0.0f, value(-1.0f), slope(-1.0f), slope(1.0f), value(1.0f), 0.0f});
    for (float x = -1.0f; x <= 1.0f; x += 0.125f)
        EXPECT_NEAR(valueAt(track, x)[0], value(x), 1e-6f) << x;
}

TEST(Clip, KeysAndWhatLiesBetweenEqualKeysAreExact) {
    test::Draws draws(5);
    for (int i = 0; i < 200; ++i) {
        std::vector<float> key;
        for (int k = 0; k < 4; ++k) key.push_back(draws.in(-1.0f, 1.0f));
        const float from = draws.in(-2.0f, 0.0f), to = draws.in(0.1f, 2.0f);
        const std::vector<float> zeros(4, 0.0f);
        for (const auto path : {ClipPath::translation, ClipPath::rotation}) {
            const Track line =
                trackOf(Interpolation::linear, 4, {from, to}, test::joined(key, key), path);
            EXPECT_EQ(valueAt(line, draws.in(from, to)), key);
            EXPECT_EQ(valueAt(line, from), key);
            EXPECT_EQ(valueAt(line, to), key);
        }
    }
}

TEST(Clip, RotationsTakeTheShortWayAtEvenSpeed) {
    const float half = 0.5f * std::numbers::pi_v<float> / 3.0f;  // of 60 degrees
    // The same turn as its negative, which would be the long way around.
    const Track track =
        trackOf(Interpolation::linear, 4, {0.0f, 1.0f},
                {0, 0, 0, 1, 0, -std::sin(half), 0, -std::cos(half)}, ClipPath::rotation);
    for (float t = 0.0f; t <= 1.0f; t += 0.125f) {
        const std::vector<float> q = valueAt(track, t);
        const float sign = q[3] < 0.0f ? -1.0f : 1.0f;
        EXPECT_NEAR(sign * q[1], std::sin(t * half), 1e-6f);
        EXPECT_NEAR(sign * q[3], std::cos(t * half), 1e-6f);
    }
}

TEST(Clip, CubicRotationsAreUnit) {
    test::Draws draws(6);
    for (int i = 0; i < 200; ++i) {
        std::vector<float> values;
        for (int k = 0; k < 24; ++k) values.push_back(draws.in(-1.0f, 1.0f));
        const Track track =
            trackOf(Interpolation::cubic, 4, {0.0f, 1.0f}, values, ClipPath::rotation);
        const std::vector<float> q = valueAt(track, draws.in(0.01f, 0.99f));
        EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0f, 1e-5f);
    }
}

// Of a glTF without a path.
Source read(const GltfMaker& maker) { return readGltf(maker.glb(), ""); }

TEST(Clip, NamesAndSecondsAreRead) {
    GltfMaker maker = GltfMaker::skinned();
    addChannel(maker, 0, 1, "translation", {0.0f, 2.0f}, {0, 0, 0, 1, 0, 0});
    addChannel(maker, 0, 2, "scale", {0.5f, 3.25f}, {1, 1, 1, 2, 2, 2}, "STEP");
    addChannel(maker, 1, 2, "rotation", {0.0f}, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0},
               "CUBICSPLINE");
    maker.json["animations"][0]["name"] = "Walk";
    const Source source = read(maker);
    ASSERT_TRUE(source.rig);
    EXPECT_TRUE(source.warnings.empty());
    const std::vector<Clip>& clips = source.rig->clips;
    ASSERT_EQ(clips.size(), 2u);
    EXPECT_EQ(clips[0].name, "Walk");
    EXPECT_EQ(clips[0].seconds, 3.25f);
    EXPECT_EQ(clips[0].tracks[1].interpolation, Interpolation::step);
    EXPECT_EQ(clips[1].name, "clip 2");
    EXPECT_EQ(valueAt(clips[1].tracks[0], 0.0f), (std::vector<float>{0, 0, 0, 1}));
}

TEST(Clip, NormalizedAndSparseNumbersAreRead) {
    GltfMaker maker = test::morphing();
    addChannel(maker, 0, 0, "rotation", {0.0f, 1.0f}, test::joined(test::kNoTurn, test::kNoTurn));
    addChannel(maker, 0, 0, "weights", {0.0f, 1.0f}, {0, 0, 0, 0, 0, 0});
    addChannel(maker, 0, 0, "translation", {0.0f, 1.0f}, {0, 0, 0, 0, 0, 0});
    auto& samplers = maker.json["animations"][0]["samplers"];
    samplers[0]["output"] = maker.add<std::int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}, "VEC4", 5122,
                                                    {{"normalized", true}});
    samplers[1]["output"] =
        maker.accessor(maker.view(std::vector<std::uint8_t>{255, 0, 51, 0, 255, 102}), 6, "SCALAR",
                       5121, {{"normalized", true}});
    const int index = maker.view(std::vector<std::uint8_t>{1});
    const int value = maker.view(std::vector<float>{7, 8, 9});
    samplers[2]["output"] =
        maker.accessor(-1, 2, "VEC3", 5126,
                       {{"sparse",
                         {{"count", 1},
                          {"indices", {{"bufferView", index}, {"componentType", 5121}}},
                          {"values", {{"bufferView", value}}}}}});
    const Source source = read(maker);
    ASSERT_TRUE(source.rig);
    const std::vector<Track>& tracks = source.rig->clips.at(0).tracks;
    EXPECT_EQ(valueAt(tracks[0], 1.0f), (std::vector<float>{0, 0, 1, 0}));
    EXPECT_EQ(valueAt(tracks[1], 1.0f), (std::vector<float>{0, 1, 0.4f}));
    EXPECT_EQ(valueAt(tracks[2], 0.0f), (std::vector<float>{0, 0, 0}));
    EXPECT_EQ(valueAt(tracks[2], 1.0f), (std::vector<float>{7, 8, 9}));
}

TEST(Clip, BadAnimationsAreNotPlayedAndSaySo) {
    const float nan = std::nanf("");
    struct Case {
        const char* complaint;
        void (*spoil)(GltfMaker&);
    };
    const Case cases[] = {
        {"animations[0].samplers[0]: time 1 is 1 after 1, which does not rise",
         [](GltfMaker& m) {
             m.json["animations"][0]["samplers"][0]["input"] = m.add<float>({1, 1}, "SCALAR", 5126);
         }},
        {"animations[0].samplers[0]: has 3 numbers where 2 keys take 6",
         [](GltfMaker& m) {
             m.json["animations"][0]["samplers"][0]["output"] =
                 m.add<float>({1, 1, 1}, "VEC3", 5126);
         }},
        {"animations[0].samplers[0]: has 6 numbers where 2 keys take 18",
         [](GltfMaker& m) {
             m.json["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
         }},
        {"interpolation is \"SINE\", which is none of glTF",
         [](GltfMaker& m) { m.json["animations"][0]["samplers"][0]["interpolation"] = "SINE"; }},
        {"animations[0].channels[0]: names sampler 5 of 1",
         [](GltfMaker& m) { m.json["animations"][0]["channels"][0]["sampler"] = 5; }},
        {"moves node 2, which is placed by a matrix",
         [](GltfMaker& m) {
             m.json["nodes"][2].erase("translation");
             m.json["nodes"][2]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1};
         }},
        {"moves the weights of a node that has no morph target",
         [](GltfMaker& m) {
             m.json["animations"][0]["channels"][0]["target"]["path"] = "weights";
         }},
        {"has 3 components where 4 are needed",
         [](GltfMaker& m) {
             m.json["animations"][0]["channels"][0]["target"]["path"] = "rotation";
         }},
    };
    const auto good = [] {
        GltfMaker maker = GltfMaker::skinned();
        addChannel(maker, 0, 2, "translation", {0.0f, 1.0f}, {0, 1, 0, 0, 2, 0});
        addChannel(maker, 1, 1, "translation", {0.0f, 1.0f}, {0, 1, 0, 0, 2, 0});
        return maker;
    };
    for (const auto& [complaint, spoil] : cases) {
        GltfMaker maker = good();
        spoil(maker);
        const Source source = read(maker);
        ASSERT_EQ(source.warnings.size(), 1u) << complaint;
        EXPECT_NE(source.warnings[0].find(complaint), std::string::npos) << source.warnings[0];
        EXPECT_NE(source.warnings[0].find("; this animation is not played"), std::string::npos);
        EXPECT_EQ(source.warnings[0].find("glTF: "), std::string::npos) << source.warnings[0];
        ASSERT_TRUE(source.rig);
        ASSERT_EQ(source.rig->clips.size(), 1u);
        EXPECT_EQ(source.rig->clips[0].name, "clip 2");
    }
    for (const float bad : {nan, INFINITY}) {
        GltfMaker maker = good();
        maker.json["animations"][0]["samplers"][0]["output"] =
            maker.add<float>({0, 0, 0, 0, 0, bad}, "VEC3", 5126);
        EXPECT_NE(read(maker).warnings.at(0).find("number 5 is not finite"), std::string::npos);
        maker.json["animations"][0]["samplers"][0]["input"] =
            maker.add<float>({0, bad}, "SCALAR", 5126);
        EXPECT_NE(read(maker).warnings.at(0).find("time 1 is not finite"), std::string::npos);
    }
}

TEST(Clip, WhatOnlyAnExtensionKnowsIsIgnored) {
    GltfMaker maker = GltfMaker::skinned();
    addChannel(maker, 0, 2, "translation", {0.0f, 1.0f}, {0, 1, 0, 0, 2, 0});
    addChannel(maker, 0, 2, "translation", {0.0f, 1.0f}, {0, 1, 0, 0, 2, 0});
    addChannel(maker, 1, 2, "translation", {0.0f, 1.0f}, {0, 1, 0, 0, 2, 0});
    maker.json["animations"][0]["channels"][0]["target"] = {{"path", "pointer"}};
    maker.json["animations"][1]["channels"][0]["target"]["path"] = "color";
    const Source source = read(maker);
    EXPECT_TRUE(source.warnings.empty());
    ASSERT_TRUE(source.rig);
    ASSERT_EQ(source.rig->clips.size(), 1u);
    EXPECT_EQ(source.rig->clips[0].tracks.size(), 1u);
}

TEST(Clip, WhatDoesNotMoveHasNoRig) {
    EXPECT_FALSE(read(GltfMaker::triangle()).rig);
    EXPECT_FALSE(read(GltfMaker::skinned()).rig);
}

TEST(Clip, BadTargetsDoNotMoveAndSaySo) {
    GltfMaker maker = test::morphing();
    maker.primitive()["targets"][1]["POSITION"] = maker.add<float>({1, 2, 3}, "VEC3", 5126);
    const Source source = read(maker);
    EXPECT_FALSE(source.rig);
    ASSERT_EQ(source.warnings.size(), 1u);
    EXPECT_EQ(source.warnings[0],
              "meshes[0].primitives[0].targets[1]: POSITION has 1 values for 3 vertices; its morph "
              "targets do not move");
}

}  // namespace
}  // namespace pelage
