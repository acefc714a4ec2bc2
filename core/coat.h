// coat.h -- the parameters of the fur: one table that makes sliders, JSON, options and tests.
//
// A parameter is named "over.stiffness", "under.stiffness", "both.stiffness" (sets two), or
// "fur.hairs" for what the coats share. Van Gelder and Wilhelms, "An Interactive Fur Modeling
// Technique", 1997, figure 2, is the source of the first eight rows.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "types.h"

namespace pelage {

enum class ParameterKind { scalar, color, direction, count, choice };

struct Parameter {
    const char* name;   // in files and on the command line
    const char* label;  // in the panel
    const char* unit;   // "" for a pure number
    const char* help;   // one sentence
    ParameterKind kind;
    float least, greatest;  // of each component
    std::size_t offset;     // in Coat, or in Fur for furParameters()
    std::span<const char* const> choices{};  // names of the values 0, 1, ... of a choice

    int components() const {
        return kind == ParameterKind::color || kind == ParameterKind::direction ? 3 : 1;
    }
};

std::span<const Parameter> coatParameters();  // one value for each coat
std::span<const Parameter> furParameters();   // one value for both

const Parameter& styleRow();                  // of coatParameters(): how a hair is drawn

// The fur of a mesh that nobody has groomed yet.
Fur defaultFur();

// A value of the table, by row. Components beyond the row's own are 0.
vec3 parameterValue(const Coat& coat, const Parameter& row);
vec3 parameterValue(const Fur& fur, const Parameter& row);
// Sets it, clamped to the range of the row; NaN leaves the old value; directions are normalised.
void setParameter(Coat& coat, const Parameter& row, vec3 value);
void setParameter(Fur& fur, const Parameter& row, vec3 value);

// The same for rows of counts, exactly, since a float holds no more than 24 bits of a count, and for
// the number of a choice.
uint parameterCount(const Coat& coat, const Parameter& row);
uint parameterCount(const Fur& fur, const Parameter& row);
void setParameterCount(Coat& coat, const Parameter& row, uint count);
void setParameterCount(Fur& fur, const Parameter& row, uint count);

// Sets one parameter from text: "over.stiffness" and "0.3", "under.tipColor" and "1,0.9,0.8",
// "both.style" and "ribbon".
// Throws std::runtime_error naming the parameter, the text and the range; nothing is changed then.
void setParameter(Fur& fur, std::string_view path, std::string_view value);

// The fur as the JSON object of extras.fur (schema: assets/fur.schema.json), and back. Reading
// takes the defaults for what is missing, ignores what it does not know, and throws
// std::runtime_error on a newer version, a wrong type or a value out of range; `place` opens its
// message.
std::string furToJson(const Fur& fur, int indent = -1);
Fur furFromJson(std::string_view json, const std::string& place = "extras.fur");

struct Preset {
    std::string name;    // "house cat short hair"
    std::string author;  // may be empty, as all below
    std::string note;    // one sentence
    Fur fur{};
    bool seeded = false;               // the seed is part of it
    std::vector<std::byte> thumbnail;  // PNG or JPEG
    std::string file;                  // that it was read from
};

// All presets of the program (assets/presets/*.json, compiled in), in the order of their names.
const std::vector<Preset>& presets();
// The preset of that name, of the program's or else of `own`; throws std::runtime_error that lists
// the names there are.
const Preset& presetNamed(std::string_view name, std::span<const Preset> own = {});
// Takes over looks and behaviour; keeps the seed of `fur` unless the preset has one of its own.
void applyPreset(Fur& fur, const Preset& preset);

}  // namespace pelage
