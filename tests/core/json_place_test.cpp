// json_place_test.cpp -- the promises of json_place.h.
#include "core/json_place.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "reading.h"

namespace pelage {
namespace {

using test::refusal;

const std::string kFile = "horse.gltf";

class JsonPlaceTest : public testing::Test {
protected:
    JsonPlace place() const { return {kFile, json_}; }

    Json json_ = Json::parse(R"({
        "accessors": [{}, {}, {}, {"count": "many", "min": [1, 2.5, -3]}],
        "one": 1, "three": 3.0, "half": 0.5, "minus": -1, "yes": true, "name": "tail",
        "nothing": null, "object": {}, "array": [], "huge": [1e39, 0, 0], "words": ["a", "b"]})");
};

TEST_F(JsonPlaceTest, ComplaintsSayFilePlaceValueAndWhatWasExpected) {
    EXPECT_EQ(refusal([&] { place().at("accessors").at(3).integer("count", 1, 100); }),
              "horse.gltf: accessors[3].count: is \"many\", not a whole number from 1 to 100");
    EXPECT_EQ(refusal([&] { place().refuse("is odd"); }), "horse.gltf: is odd");
}

TEST_F(JsonPlaceTest, MembersWithStrangeNamesStandInQuotes) {
    json_["a\nb"] = 1;
    EXPECT_EQ(place().at("a\nb").text(), "\"a?b\"");
    EXPECT_EQ(place().at("accessors").at(3).text(), "accessors[3]");
}

TEST_F(JsonPlaceTest, WhatIsMissingIsRefused) {
    EXPECT_EQ(refusal([&] { place().at("mane"); }), "horse.gltf: has no \"mane\"");
    EXPECT_EQ(refusal([&] { place().at("accessors").at(4); }),
              "horse.gltf: accessors: has no element 4");
    EXPECT_EQ(refusal([&] { place().integer("mane", 0, 9); }), "horse.gltf: has no \"mane\"");
}

TEST_F(JsonPlaceTest, WhatIsOfTheWrongKindIsRefused) {
    const std::pair<std::string, std::function<void()>> wrong[] = {
        {"one: is 1, not an object", [&] { place().at("one").at("x"); }},
        {"object: is an object, not an array", [&] { place().at("object").at(0); }},
        {"object: is an object, not an array", [&] { place().array("object"); }},
        {"array: is an array, not an object", [&] { place().object("array"); }},
        {"half: is 0.5, not a whole number from 0 to 9", [&] { place().integer("half", 0, 9); }},
        {"minus: is -1, not a whole number from 0 to 9", [&] { place().integerOr("minus", 0, 9); }},
        {"three: is 3.0, not a whole number from 4 to 9", [&] { place().integer("three", 4, 9); }},
        {"minus: is -1, not a whole number from 0 to 4294967295",
         [&] { place().reference("minus"); }},
        {"one: is 1, not true or false", [&] { place().boolean("one"); }},
        {"nothing: is null, not a string", [&] { place().string("nothing"); }},
        {"name: is \"tail\", not a number", [&] { place().numberOr("name", 0.0f); }},
        {"words: has 2 numbers, not 3", [&] { place().numbers("words", 3); }},
        {"words[0]: is \"a\", not a number", [&] { place().numbers("words", 2); }},
    };
    for (const auto& [message, ask] : wrong) EXPECT_EQ(refusal(ask), "horse.gltf: " + message);
}

TEST_F(JsonPlaceTest, HasIsFalseWhereThereIsNoObject) {
    EXPECT_TRUE(place().has("one"));
    EXPECT_TRUE(place().has("nothing"));
    EXPECT_FALSE(place().has("mane"));
    EXPECT_FALSE(place().at("one").has("x"));
    EXPECT_FALSE(place().at("array").has("x"));
}

TEST_F(JsonPlaceTest, MissingMembersTakeTheirFallback) {
    EXPECT_FALSE(place().array("mane"));
    EXPECT_FALSE(place().object("mane"));
    EXPECT_EQ(place().integerOr("mane", 77, 9), 77u);
    EXPECT_FALSE(place().reference("mane"));
    EXPECT_FALSE(place().boolean("mane"));
    EXPECT_EQ(place().string("mane"), "");
    EXPECT_TRUE(place().numbers("mane", 3).empty());
    EXPECT_EQ(place().numberOr("mane", 0.25f), 0.25f);
}

TEST_F(JsonPlaceTest, WhatIsThereIsRead) {
    EXPECT_EQ(place().integer("one", 1, 1), 1u);
    EXPECT_EQ(place().integer("three", 0, 9), 3u);  // some writers know no integers
    EXPECT_EQ(place().reference("one"), std::optional<std::size_t>(1));
    EXPECT_TRUE(place().boolean("yes"));
    EXPECT_EQ(place().string("name"), "tail");
    EXPECT_EQ(place().at("accessors").at(3).numbers("min", 3),
              (std::vector<float>{1.0f, 2.5f, -3.0f}));
    EXPECT_EQ(place().numberOr("half", 0.0f), 0.5f);
    EXPECT_TRUE(place().array("array"));
    EXPECT_TRUE(place().object("object"));
}

TEST_F(JsonPlaceTest, NumbersAreFiniteAsFloat) {
    EXPECT_EQ(refusal([&] { place().numbers("huge", 3); }),
              "horse.gltf: huge[0]: is 1e+39, too large for a float");
}

}  // namespace
}  // namespace pelage
