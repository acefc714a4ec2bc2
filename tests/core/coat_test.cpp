// coat_test.cpp -- the promises of coat.h.
#include "core/coat.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/strand.h"
#include "gtest/gtest.h"
#include "reading.h"

namespace pelage {
namespace {

using test::refusal;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

bool sameBits(const Fur& a, const Fur& b) { return std::memcmp(&a, &b, sizeof(Fur)) == 0; }

// A number of [0,1) with all its 23 fraction bits in use, another one for each i.
float draw(uint i) { return rand01(pcg(i)); }

TEST(Coat, EveryFieldOfTheStructIsOneRowOfTheTable) {
    std::size_t floats = 0;
    std::set<std::size_t> offsets;
    for (const Parameter& row : coatParameters()) {
        floats += static_cast<std::size_t>(row.components());
        offsets.insert(row.offset);
    }
    EXPECT_EQ((floats + 2) * sizeof(float), sizeof(Coat));  // 2 are padding
    EXPECT_EQ(offsets.size(), coatParameters().size());
    floats = 0;
    for (const Parameter& row : furParameters())
        floats += static_cast<std::size_t>(row.components());
    EXPECT_EQ((floats + 1) * sizeof(float) + 2 * sizeof(Coat), sizeof(Fur));  // 1 is padding
}

TEST(Coat, NamesLabelsAndHelpAreThereAndNamesAreUnique) {
    std::set<std::string> names;
    for (const auto rows : {coatParameters(), furParameters()}) {
        for (const Parameter& row : rows) {
            EXPECT_TRUE(names.insert(row.name).second) << row.name;
            EXPECT_STRNE(row.label, "") << row.name;
            EXPECT_STRNE(row.help, "") << row.name;
            EXPECT_LT(row.least, row.greatest) << row.name;
        }
    }
}

TEST(Coat, DefaultsAreInRange) {
    const Fur fur = defaultFur();
    for (const Parameter& row : coatParameters()) {
        for (const Coat& coat : {fur.over, fur.under}) {
            const vec3 value = parameterValue(coat, row);
            for (int i = 0; i < row.components(); ++i) {
                EXPECT_GE(value[i], row.least) << row.name;
                EXPECT_LE(value[i], row.greatest) << row.name;
            }
        }
    }
    EXPECT_EQ(fur.hairs, 100000u);
    EXPECT_EQ(fur.share, 0.3f);
}

TEST(Coat, SetParameterClampsToTheRangeOfTheRow) {
    for (const Parameter& row : coatParameters()) {
        Coat coat = defaultFur().over;
        setParameter(coat, row, vec3(row.greatest + 1.0f));
        vec3 value = parameterValue(coat, row);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(value[i], i < row.components() ? row.greatest : 0.0f) << row.name;
        }
        setParameter(coat, row, vec3(row.least - 1.0f));
        value = parameterValue(coat, row);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(value[i], i < row.components() ? row.least : 0.0f) << row.name;
        }
        setParameter(coat, row, vec3(std::numeric_limits<float>::infinity()));
        EXPECT_EQ(parameterValue(coat, row).x, row.greatest) << row.name;
    }
}

TEST(Coat, SetParameterAtTheLimitsOfEveryRowKeepsItAsIs) {
    for (const Parameter& row : coatParameters()) {
        for (const float limit : {row.least, row.greatest}) {
            Coat coat = defaultFur().over;
            setParameter(coat, row, vec3(limit));
            EXPECT_EQ(parameterValue(coat, row).x, limit) << row.name;
        }
    }
}

TEST(Coat, SetParameterChangesNothingButItsRow) {
    for (const Parameter& row : coatParameters()) {
        const Coat before = defaultFur().over;
        Coat coat = before;
        setParameter(coat, row, vec3(0.123f));
        for (const Parameter& other : coatParameters()) {
            if (&other == &row) continue;
            EXPECT_EQ(parameterValue(coat, other), parameterValue(before, other))
                << row.name << " changed " << other.name;
        }
    }
}

TEST(Coat, NanLeavesTheOldValue) {
    for (const Parameter& row : coatParameters()) {
        for (int i = 0; i < row.components(); ++i) {
            Coat coat = defaultFur().over;
            vec3 value(row.greatest);
            value[i] = kNan;
            setParameter(coat, row, value);
            EXPECT_EQ(coat, defaultFur().over) << row.name;
        }
    }
    for (const Parameter& row : furParameters()) {
        Fur fur = defaultFur();
        setParameter(fur, row, vec3(kNan));
        EXPECT_EQ(fur, defaultFur()) << row.name;
    }
}

TEST(Coat, CountsAreClampedAndRounded) {
    for (const Parameter& row : furParameters()) {
        if (row.kind != ParameterKind::count) continue;
        Fur fur = defaultFur();
        setParameter(fur, row, vec3(-3.0f));
        EXPECT_EQ(parameterValue(fur, row).x, 0.0f);
        setParameter(fur, row, vec3(1e30f));
        EXPECT_EQ(parameterValue(fur, row).x, row.greatest);
        setParameter(fur, row, vec3(12.6f));
        EXPECT_EQ(parameterValue(fur, row).x, 13.0f);
    }
}

TEST(Coat, ParameterCountsAreExactAndClampedToTheRangeOfTheRow) {
    constexpr uint kMost = std::numeric_limits<uint>::max();
    for (const Parameter& row : furParameters()) {
        if (row.kind != ParameterKind::count) continue;
        Fur fur = defaultFur();
        for (const uint count : {0u, 1u, 16'777'217u, kMost - 1, kMost}) {
            setParameterCount(fur, row, count);
            const uint greatest = row.greatest < 4e9f ? static_cast<uint>(row.greatest) : kMost;
            EXPECT_EQ(parameterCount(fur, row), std::min(count, greatest)) << row.name;
        }
        setParameterCount(fur, row, 4'999'999u);
        EXPECT_EQ(parameterCount(fur, row), 4'999'999u) << row.name;
        Fur expected = defaultFur();
        (row.name == std::string("seed") ? expected.seed : expected.hairs) = 4'999'999u;
        EXPECT_EQ(fur, expected) << row.name;  // and nothing else
    }
}

TEST(Coat, DirectionsAreNormalisedAndZeroLeavesTheOldValue) {
    for (const Parameter& row : furParameters()) {
        if (row.kind != ParameterKind::direction) continue;
        Fur fur = defaultFur();
        setParameter(fur, row, vec3(0.0f, 3.0f, 4.0f));
        const vec3 unit = parameterValue(fur, row);
        EXPECT_NEAR(unit.y, 0.6f, 1e-6f);
        EXPECT_NEAR(unit.z, 0.8f, 1e-6f);
        setParameter(fur, row, vec3(0.0f));
        EXPECT_EQ(parameterValue(fur, row), unit);
        setParameter(fur, row, unit);  // bit for bit
        EXPECT_EQ(parameterValue(fur, row), unit);
    }
}

TEST(Coat, TextSetsOneCoatOrBothOrWhatTheyShare) {
    const Fur before = defaultFur();
    Fur fur = before;
    setParameter(fur, "over.stiffness", "0.25");
    EXPECT_EQ(fur.over.stiffness, 0.25f);
    EXPECT_EQ(fur.under, before.under);
    setParameter(fur, "under.tipColor", "1,0.5,0.25");
    EXPECT_EQ(fur.under.tipColor, vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(fur.over.tipColor, before.over.tipColor);
    setParameter(fur, "both.shininess", "128");
    EXPECT_EQ(fur.over.shininess, 128.0f);
    EXPECT_EQ(fur.under.shininess, 128.0f);
    setParameter(fur, "fur.hairs", "5000000");
    EXPECT_EQ(fur.hairs, 5000000u);
    setParameter(fur, "fur.seed", "4294967295");
    EXPECT_EQ(fur.seed, 4294967295u);
    setParameter(fur, "fur.gravityDirection", "0, 0, -1");
    EXPECT_EQ(fur.gravityDirection, vec3(0.0f, 0.0f, -1.0f));
}

TEST(Coat, WrongTextIsRefusedByNameTextAndRangeAndChangesNothing) {
    Fur fur = defaultFur();
    const auto message = [&](const char* path, const char* text) {
        return refusal([&] { setParameter(fur, path, text); });
    };
    EXPECT_EQ(message("over.stiffness", "3"), "over.stiffness is 3, range 0..1");
    EXPECT_EQ(message("both.shininess", "0.5"), "both.shininess is 0.5, range 1..256");
    EXPECT_EQ(message("under.stiffness", "nan"), "under.stiffness is nan, range 0..1");
    EXPECT_EQ(message("under.stiffness", "soft"),
              "under.stiffness is \"soft\", which is not a number; range 0..1");
    EXPECT_EQ(message("under.stiffness", "0.5 "),
              "under.stiffness is \"0.5 \", which is not a number; range 0..1");
    EXPECT_EQ(message("over.tipColor", "1,1"),
              "over.tipColor is \"1,1\", which is not three numbers with commas; range 0..1");
    EXPECT_EQ(message("over.tipColor", "1,1,2"), "over.tipColor is 1,1,2, range 0..1");
    EXPECT_EQ(message("fur.hairs", "5000001"), "fur.hairs is 5000001, range 0..5000000");
    EXPECT_EQ(message("fur.hairs", "-1"),
              "fur.hairs is \"-1\", which is not a whole number; range 0..5000000");
    EXPECT_EQ(message("fur.seed", "4294967296"), "fur.seed is 4294967296, range 0..4294967295");
    EXPECT_EQ(message("fur.gravityDirection", "0,0,0"),
              "fur.gravityDirection is 0,0,0, which is no direction; range -1..1");
    for (const char* unknown : {"over.fluffiness", "stiffness", "coat.stiffness", "fur.stiffness",
                                "over.hairs", "over.", ".", ""}) {
        const std::string text = message(unknown, "0");
        EXPECT_EQ(text.find("there is no parameter \"" + std::string(unknown) + "\""), 0u) << text;
        EXPECT_NE(text.find("stiffness, "), std::string::npos) << text;
    }
    EXPECT_EQ(fur, defaultFur());
}

TEST(CoatJson, ValuesReadBackBitForBit) {
    for (uint seed = 0; seed < 200; ++seed) {
        Fur fur = defaultFur();
        uint i = seed * 1000;
        for (const Parameter& row : coatParameters()) {
            for (Coat* coat : {&fur.over, &fur.under}) {
                const vec3 share(draw(i), draw(i + 1), draw(i + 2));
                i += 3;
                setParameter(*coat, row, row.least + share * (row.greatest - row.least));
            }
        }
        for (const Parameter& row : furParameters()) {
            const vec3 share(draw(i), draw(i + 1), draw(i + 2));
            i += 3;
            setParameter(fur, row, row.least + share * (row.greatest - row.least));
        }
        fur.seed = pcg(seed);
        EXPECT_TRUE(sameBits(furFromJson(furToJson(fur)), fur)) << furToJson(fur, 2);
        // A reader that keeps numbers as double and writes them again changes nothing either.
        const std::string carried = nlohmann::json::parse(furToJson(fur)).dump();
        EXPECT_TRUE(sameBits(furFromJson(carried), fur)) << carried;
    }
}

TEST(CoatJson, LimitsAndSmallNumbersReadBackBitForBit) {
    for (const float tiny : {0.0f, -0.0f, 1e-45f, 1.17549435e-38f, 1e-7f, 0.1f, 1.0f / 3.0f}) {
        Fur fur = defaultFur();
        fur.over.stiffness = tiny;
        fur.under.width = tiny;
        EXPECT_TRUE(sameBits(furFromJson(furToJson(fur)), fur)) << tiny;
    }
    for (const Parameter& row : furParameters()) {
        if (row.kind == ParameterKind::direction) continue;
        for (const float limit : {row.least, row.greatest}) {
            Fur fur = defaultFur();
            setParameter(fur, row, vec3(limit));
            EXPECT_TRUE(sameBits(furFromJson(furToJson(fur)), fur)) << row.name;
        }
    }
}

TEST(CoatJson, IsOneVersionedObjectWithACoatInEachGroup) {
    const auto json = nlohmann::json::parse(furToJson(defaultFur(), 2));
    EXPECT_EQ(json.at("version"), 1);
    EXPECT_EQ(json.at("hairs").type(), nlohmann::json::value_t::number_unsigned);
    EXPECT_EQ(json.at("seed").type(), nlohmann::json::value_t::number_unsigned);
    EXPECT_EQ(json.size(), 3 + furParameters().size());
    for (const char* coat : {"over", "under"}) {
        EXPECT_EQ(json.at(coat).size(), coatParameters().size());
        for (const Parameter& row : coatParameters()) {
            const auto& value = json.at(coat).at(row.name);
            EXPECT_EQ(value.is_array(), row.components() == 3) << row.name;
        }
    }
}

TEST(CoatJson, ShortNumbersAreWrittenShort) {
    EXPECT_NE(furToJson(defaultFur()).find("\"share\":0.3,"), std::string::npos)
        << furToJson(defaultFur());
}

TEST(CoatJson, MissingValuesTakeTheDefaultsAndUnknownOnesAreIgnored) {
    EXPECT_EQ(furFromJson("{}"), defaultFur());
    EXPECT_EQ(furFromJson(R"({"version":1,"over":{"shine":7},"breeze":[1,2],"under":{}})"),
              defaultFur());
    Fur expected = defaultFur();
    expected.under.stiffness = 0.5f;
    EXPECT_EQ(furFromJson(R"({"version":1,"under":{"stiffness":0.5}})"), expected);
    expected.hairs = 7;
    EXPECT_EQ(furFromJson(R"({"hairs":7.0,"under":{"stiffness":0.5}})"), expected);
}

TEST(CoatJson, WhatIsWrongIsNamedWithItsRange) {
    const auto message = [](const char* json) { return refusal([&] { furFromJson(json); }); };
    EXPECT_EQ(message(R"({"over":{"stiffness":3}})"),
              "extras.fur: over.stiffness is 3, range 0..1");
    EXPECT_EQ(message(R"({"under":{"shininess":0}})"),
              "extras.fur: under.shininess is 0, range 1..256");
    EXPECT_EQ(message(R"({"under":{"shininess":"high"}})"),
              "extras.fur: under.shininess is not a number, range 1..256");
    EXPECT_EQ(message(R"({"under":{"tipColor":[1,1]}})"),
              "extras.fur: under.tipColor is not an array of 3 numbers, range 0..1");
    EXPECT_EQ(message(R"({"under":{"tipColor":[1,2,1]}})"),
              "extras.fur: under.tipColor is 1,2,1, range 0..1");
    EXPECT_EQ(message(R"({"under":{"tipColor":[1,null,1]}})"),
              "extras.fur: under.tipColor is not an array of 3 numbers, range 0..1");
    EXPECT_EQ(message(R"({"under":4})"), "extras.fur: under is not an object");
    EXPECT_EQ(message(R"({"hairs":-1})"), "extras.fur: hairs is -1, range 0..5000000");
    EXPECT_EQ(message(R"({"hairs":5000001})"), "extras.fur: hairs is 5000001, range 0..5000000");
    EXPECT_EQ(message(R"({"hairs":1.5})"),
              "extras.fur: hairs is not a whole number, range 0..5000000");
    EXPECT_EQ(message(R"({"seed":18446744073709551615})"),
              "extras.fur: seed is 18446744073709551615, range 0..4294967295");
    EXPECT_EQ(message(R"({"gravityDirection":[0,0,0]})"),
              "extras.fur: gravityDirection is 0,0,0, which is no direction; range -1..1");
    EXPECT_EQ(message(R"({"version":2})"), "extras.fur: version is 2, this program reads 1..1");
    EXPECT_EQ(message(R"({"version":"1"})"),
              "extras.fur: version is not a whole number, range 1..1");
    EXPECT_EQ(message("[1]"), "extras.fur: not a JSON object");
    for (const char* broken : {"", "{", "{\"hairs\":1e999}", "\n\n\n", "{\"over\":\"\xff\"}"}) {
        const std::string text = message(broken);
        EXPECT_EQ(text.find("extras.fur: not JSON: "), 0u) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

TEST(Presets, AreInTheOrderOfTheirNamesAndAllThere) {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) {
        EXPECT_FALSE(preset.note.empty()) << preset.name;
        if (!names.empty()) {
            EXPECT_LT(names.back(), preset.name);
        }
        names.push_back(preset.name);
    }
    for (const char* name :
         {"default", "monkey 8", "monkey 9", "house cat short hair", "fox", "mink",
          "wolf winter coat", "plush", "rabbit", "doormat", "grass", "meadow"}) {
        EXPECT_EQ(presetNamed(name).name, name);
    }
}

TEST(Presets, TheDefaultPresetIsTheDefaultFur) {
    EXPECT_EQ(presetNamed("default").fur, defaultFur());
}

TEST(Presets, TheMonkeysHaveTheValuesOfThePaper) {
    const Fur& eight = presetNamed("monkey 8").fur;
    EXPECT_EQ(eight.hairs, 90000u);
    EXPECT_EQ(eight.share, 1.0f);
    EXPECT_EQ(eight.over.stiffness, 0.2f);
    EXPECT_EQ(eight.over.normalRandomness, 0.0f);
    EXPECT_EQ(eight.over.endRandomness, 0.2f);
    EXPECT_EQ(eight.over.directionWeight, 0.2f);
    EXPECT_EQ(eight.over.ambient, vec3(0.3f, 0.14f, 0.0f));
    EXPECT_EQ(eight.over.shininess, 16.0f);
    const Fur& nine = presetNamed("monkey 9").fur;
    EXPECT_EQ(nine.hairs, 500000u);
    EXPECT_EQ(nine.over.normalRandomness, 0.5f);
    EXPECT_EQ(nine.over.ambient, vec3(0.15f, 0.07f, 0.0f));
    EXPECT_EQ(nine.over.specular, vec3(0.6f));
    EXPECT_EQ(nine.over.shininess, 50.0f);
    EXPECT_EQ(nine.under.relativeLength, 0.3f);
}

TEST(Presets, AnUnknownNameListsTheNamesThereAre) {
    const std::string text = refusal([] { presetNamed("poodle"); });
    EXPECT_EQ(text.find("there is no preset \"poodle\"; there are "), 0u) << text;
    for (const Preset& preset : presets()) {
        EXPECT_NE(text.find(preset.name), std::string::npos) << text;
    }
}

TEST(Presets, ApplyingOneTakesEverythingButTheSeed) {
    Fur fur = defaultFur();
    fur.seed = 77;
    const Preset& mink = presetNamed("mink");
    applyPreset(fur, mink);
    EXPECT_EQ(fur.seed, 77u);
    EXPECT_EQ(fur.over, mink.fur.over);
    EXPECT_EQ(fur.hairs, mink.fur.hairs);
}

}  // namespace
}  // namespace pelage
