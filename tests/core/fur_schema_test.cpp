// fur_schema_test.cpp -- assets/*.schema.json say what the coat table and the readers say.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/animal.h"
#include "core/coat.h"
#include "core/embedded.h"
#include "core/gltf_in.h"
#include "core/gltf_out.h"
#include "core/preset_file.h"
#include "gtest/gtest.h"
#include "reading.h"

namespace pelage {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kPath = PELAGE_SOURCE_DIR "/assets/fur.schema.json";
constexpr const char* kPresetPath = PELAGE_SOURCE_DIR "/assets/preset.schema.json";

std::string schemaText(const char* path = kPath) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

// Ranges are short decimals or whole numbers of 32 bits: written as such.
Json limit(const Parameter& row, float value) {
    if (row.kind == ParameterKind::count)
        return std::min<std::uint64_t>(static_cast<std::uint64_t>(value), 0xFFFFFFFFu);
    if (value == static_cast<float>(static_cast<int>(value))) return static_cast<int>(value);
    return value;
}

Json rowSchema(const Parameter& row) {
    if (row.kind == ParameterKind::choice)
        return {{"title", row.label},
                {"description", row.help},
                {"type", "string"},
                {"enum", std::vector<std::string>(row.choices.begin(), row.choices.end())}};
    Json number{{"type", row.kind == ParameterKind::count ? "integer" : "number"},
                {"minimum", limit(row, row.least)},
                {"maximum", limit(row, row.greatest)}};
    std::string about = row.help;
    if (*row.unit) about += std::string(" Unit: ") + row.unit + ".";
    if (row.components() == 1) {
        Json schema{{"title", row.label}, {"description", about}};
        schema.update(number);
        return schema;
    }
    return {{"title", row.label}, {"description", about}, {"type", "array"},
            {"items", number},    {"minItems", 3},        {"maxItems", 3}};
}

Json rowsSchema(std::span<const Parameter> rows) {
    Json schema = Json::object();
    for (const Parameter& row : rows) schema[row.name] = rowSchema(row);
    return schema;
}

// The schema as the table wants it.
Json wantedSchema() {
    Json properties{{"version",
                     {{"description", "Of this block. A reader refuses a newer one."},
                      {"type", "integer"},
                      {"minimum", 1},
                      {"maximum", 1}}}};
    properties.update(rowsSchema(furParameters()));
    properties["over"] = {{"description", "Overcoat: the guard hair."}, {"$ref", "#/$defs/coat"}};
    properties["under"] = {{"description", "Undercoat."}, {"$ref", "#/$defs/coat"}};
    properties["uvSet"] = {
        {"description",
         "First of the three texture coordinate sets that mirror the fields; missing when there is "
         "no mirror."},
        {"type", "integer"},
        {"minimum", 2}};
    const Json point{
        {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
    properties["segments"] = {
        {"description",
         "The parts of the body, numbered by _FUR_SEGMENT; missing where the skeleton, materials "
         "or "
         "nodes of the file say them. Root and tip are in the world, rest pose; hair lies from the "
         "one to the other."},
        {"type", "array"},
        {"items",
         {{"type", "object"},
          {"required", {"root", "tip"}},
          {"properties", {{"name", {{"type", "string"}}}, {"root", point}, {"tip", point}}}}}};
    return {
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "extras.fur of a groomed glTF"},
        {"description",
         "Everything about the fur that is not painted. What is missing has its default; what "
         "is not listed here is ignored."},
        {"type", "object"},
        {"required", {"version"}},
        {"properties", properties},
        {"$defs", {{"coat", {{"type", "object"}, {"properties", rowsSchema(coatParameters())}}}}}};
}

// The part of JSON Schema that the file uses; empty when the value fits, else where it does not.
std::string misfit(const Json& root, const Json& schema, const Json& value,
                   const std::string& place) {
    if (schema.contains("$ref") && schema["$ref"] == "fur.schema.json") {
        const Json fur = Json::parse(schemaText());
        return misfit(fur, fur, value, place);
    }
    if (schema.contains("$ref")) return misfit(root, root["$defs"]["coat"], value, place);
    const std::string type = schema.at("type");
    if ((type == "object" && !value.is_object()) || (type == "array" && !value.is_array()) ||
        (type == "number" && !value.is_number()) ||
        (type == "integer" && !value.is_number_integer()) ||
        (type == "string" && !value.is_string()))
        return place + " is no " + type;
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
        return place + " is not in the list";
    if (schema.contains("maxLength") &&
        value.get<std::string>().size() > schema["maxLength"].get<std::size_t>())
        return place + " is too long";
    if (schema.contains("minimum") && value < schema["minimum"]) return place + " is too small";
    if (schema.contains("maximum") && value > schema["maximum"]) return place + " is too large";
    if (type == "array") {
        if (schema.contains("minItems") && value.size() != schema["minItems"])
            return place + " has the wrong size";
        for (const Json& item : value)
            if (const auto bad = misfit(root, schema["items"], item, place); !bad.empty())
                return bad;
    }
    if (type == "object")
        for (const auto& [name, below] : value.items()) {
            if (!schema["properties"].contains(name)) return place + "." + name + " is not listed";
            const auto bad = misfit(root, schema["properties"][name], below, place + "." + name);
            if (!bad.empty()) return bad;
        }
    return "";
}

TEST(FurSchema, IsMadeOfTheCoatTable) {
    const std::string wanted = wantedSchema().dump(2) + "\n";
    if (std::getenv("PELAGE_BLESS")) std::ofstream(kPath) << wanted;
    EXPECT_TRUE(schemaText() == wanted)
        << kPath << " is not what the table says; run this test with PELAGE_BLESS=1 to write it";
}

TEST(FurSchema, AcceptsEveryBlockTheProgramWrites) {
    const Json schema = Json::parse(schemaText());
    EXPECT_EQ(misfit(schema, schema, Json::parse(furToJson(defaultFur())), "fur"), "");
    for (const Preset& preset : presets())
        EXPECT_EQ(misfit(schema, schema, Json::parse(furToJson(preset.fur)), "fur"), "")
            << preset.name;
    const Json block = Json::parse(
        openDocument(readGltf(groomedGlb(groomedAnimal(2000)), "")).skin->source->furBlock);
    EXPECT_TRUE(block.contains("segments"));
    EXPECT_EQ(misfit(schema, schema, block, "fur"), "");
}

TEST(FurSchema, RefusesAValueOutsideTheRangeOfItsRow) {
    const Json schema = Json::parse(schemaText());
    const Json good = Json::parse(furToJson(defaultFur()));
    for (const Parameter& row : coatParameters()) {
        for (const float value : {row.least - 1.0f, row.greatest + 1.0f}) {
            Json bad = good;
            Json& entry = bad["over"][row.name];
            (row.components() == 1 ? entry : entry[1]) = value;
            EXPECT_NE(misfit(schema, schema, bad, "fur"), "") << row.name << " " << value;
        }
    }
}

TEST(PresetSchema, AcceptsEveryFileTheProgramWrites) {
    const Json schema = Json::parse(schemaText(kPresetPath));
    for (Preset preset : presets()) {
        preset.author = "Ann";
        preset.seeded = preset.name == "mink";
        preset.thumbnail = test::bytesOf("\xFF\xD8\xFF");
        EXPECT_EQ(misfit(schema, schema, Json::parse(presetText(preset)), "preset"), "");
    }
    for (const auto& file : embeddedPresets())
        EXPECT_EQ(misfit(schema, schema, Json::parse(file.text), std::string(file.name)), "");
}

TEST(PresetSchema, HasTheBoundsOfTheReader) {
    const Json schema = Json::parse(schemaText(kPresetPath));
    for (const char* member : {"name", "author", "note"}) {
        const std::size_t most = schema["properties"][member]["maxLength"];
        for (const std::size_t bytes : {most, most + 1}) {
            const Json json{{member, std::string(bytes, 'x')}, {"fur", {{"version", 1}}}};
            const std::string read =
                test::refusal([&] { presetFromText(json.dump(), "w.fur.json"); });
            EXPECT_EQ(read == "(not refused)", bytes == most) << read;
            EXPECT_EQ(misfit(schema, schema, json, "w").empty(), bytes == most);
        }
    }
}

}  // namespace
}  // namespace pelage
