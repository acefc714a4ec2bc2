// coat.cpp -- the table of the fur's parameters, their defaults, and values by row or by name.
#include "coat.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>

#include "coat_text.h"
#include "text.h"

namespace pelage {
namespace {

using Kind = ParameterKind;

constexpr const char* kStyles[] = {"line", "polyline", "ribbon", "nurbs-curve", "nurbs-surface"};

constexpr const char* kDroops[] = {"paper", "elastica"};

constexpr Parameter kCoatRows[] = {
    {"style", "Hair style", "", "How a hair is drawn; a nurbs-surface is a tube, and the slowest.",
     Kind::choice, 0, 4, offsetof(Coat, style), kStyles},
    {"stiffness", "Stiffness", "", "How much a hair resists gravity; 0 hangs, 1 stands.",
     Kind::scalar, 0, 1, offsetof(Coat, stiffness)},
    {"droop", "Droop", "",
     "How hair bends under its weight: by the rule of the paper, or as elastic rods do.",
     Kind::choice, 0, 1, offsetof(Coat, droop), kDroops},
    {"softness", "Softness", "",
     "Of droop elastica: lets hair sag further than stiffness 0 does; 1 hangs like long silk.",
     Kind::scalar, 0, 1, offsetof(Coat, softness)},
    {"endRandomness", "End randomness", "share of length",
     "How far the tip strays from where it was combed.", Kind::scalar, 0, 1,
     offsetof(Coat, endRandomness)},
    {"normalRandomness", "Normal randomness", "share of half a turn",
     "How far the normal that is lit turns about each hair; more hides the flat look.",
     Kind::scalar, 0, 1, offsetof(Coat, normalRandomness)},
    {"directionWeight", "Direction weight", "",
     "How far hair follows the painted direction; 0 stands along the skin's normal.", Kind::scalar,
     0, 1, offsetof(Coat, directionWeight)},
    {"relativeLength", "Relative length", "share of length",
     "Length of this coat's hair as a share of the painted length.", Kind::scalar, 0, 1,
     offsetof(Coat, relativeLength)},
    {"ambient", "Ambient color", "linear RGB", "Reflectance for light from all sides.", Kind::color,
     0, 1, offsetof(Coat, ambient)},
    {"diffuse", "Diffuse color", "linear RGB", "Reflectance for light from the lamp.", Kind::color,
     0, 1, offsetof(Coat, diffuse)},
    {"specular", "Specular color", "linear RGB", "Color and strength of the highlight.",
     Kind::color, 0, 1, offsetof(Coat, specular)},
    {"shininess", "Shininess", "exponent", "How narrow the highlight is.", Kind::scalar, 1, 256,
     offsetof(Coat, shininess)},
    {"rootColor", "Root color", "linear RGB", "Multiplies ambient and diffuse at the root.",
     Kind::color, 0, 1, offsetof(Coat, rootColor)},
    {"tipColor", "Tip color", "linear RGB", "Multiplies ambient and diffuse at the tip.",
     Kind::color, 0, 1, offsetof(Coat, tipColor)},
    {"colorNoise", "Color noise", "+- share", "How far brightness differs from hair to hair.",
     Kind::scalar, 0, 1, offsetof(Coat, colorNoise)},
    {"width", "Width", "m", "Diameter at the root; 0 chooses one that makes the coat opaque.",
     Kind::scalar, 0, 10, offsetof(Coat, width)},
    {"taper", "Taper", "share of width", "How much of its width a hair loses from root to tip.",
     Kind::scalar, 0, 1, offsetof(Coat, taper)},
    {"clump", "Clump", "", "How far the tips of a clump gather to the tip of its middle hair.",
     Kind::scalar, 0, 1, offsetof(Coat, clump)},
    {"clumpSize", "Clump size", "hairs", "Hairs that gather to one.", Kind::scalar, 2, 1000,
     offsetof(Coat, clumpSize)},
    {"clumpShape", "Clump shape", "exponent", "How late along the hair a clump closes.",
     Kind::scalar, 0.5f, 4, offsetof(Coat, clumpShape)},
    {"curlRadius", "Curl radius", "share of length", "How wide the curl is at the tip.",
     Kind::scalar, 0, 0.5f, offsetof(Coat, curlRadius)},
    {"curlTurns", "Curl turns", "turns", "How often the hair turns from root to tip.", Kind::scalar,
     0, 20, offsetof(Coat, curlTurns)},
    {"frizz", "Frizz", "share of length", "How far a hair wavers at the tip, each in its own way.",
     Kind::scalar, 0, 0.5f, offsetof(Coat, frizz)},
    {"frizzWaves", "Frizz waves", "waves", "How often it wavers from root to tip.", Kind::scalar, 1,
     16, offsetof(Coat, frizzWaves)},
};

constexpr float kMaxUint = 4294967296.0f;  // the float next to 2^32 - 1

constexpr Parameter kFurRows[] = {
    {"share", "Share of overcoat", "share of hairs",
     "How many of the hairs are overcoat; the others are undercoat.", Kind::scalar, 0, 1,
     offsetof(Fur, share)},
    {"hairs", "Hairs", "", "Hairs on the entire skin where the painted density is 1.", Kind::count,
     0, 5e6f, offsetof(Fur, hairs)},
    {"skinColor", "Skin color", "share",
     "How far the color of the skin shows in the hair; 0 leaves the colors of the coats alone.",
     Kind::scalar, 0, 1, offsetof(Fur, skinColor)},
    {"gravity", "Gravity", "", "How strongly hair is pulled; 0 is weightless.", Kind::scalar, 0, 1,
     offsetof(Fur, gravity)},
    {"gravityDirection", "Gravity direction", "unit vector", "Where hair falls, in the world.",
     Kind::direction, -1, 1, offsetof(Fur, gravityDirection)},
    {"wind", "Wind", "", "How hard the wind pulls; 1 is as hard as gravity of strength 1.",
     Kind::scalar, 0, 1, offsetof(Fur, wind)},
    {"windDirection", "Wind direction", "unit vector", "Where the wind blows to, in the world.",
     Kind::direction, -1, 1, offsetof(Fur, windDirection)},
    {"gusts", "Gusts", "share of wind", "How far the wind swells and dies.", Kind::scalar, 0, 1,
     offsetof(Fur, gusts)},
    {"gustRate", "Gust rate", "Hz", "How often gusts come.", Kind::scalar, 0, 5,
     offsetof(Fur, gustRate)},
    {"gustSize", "Gust size", "m", "How far it is from gust to gust.", Kind::scalar, 1e-4f, 1e4f,
     offsetof(Fur, gustSize)},
    {"seed", "Seed", "", "Another number gives another set of hairs.", Kind::count, 0, kMaxUint,
     offsetof(Fur, seed)},
};

// The nearest count that the row and 32 bits hold; the value is not NaN.
uint clampedCount(double value, const Parameter& row) {
    const double clamped = std::clamp<double>(value, row.least, row.greatest);
    if (clamped >= kMaxUint) return std::numeric_limits<uint>::max();
    return static_cast<uint>(std::lround(clamped));
}

bool isWhole(const Parameter& row) { return row.kind == Kind::count || row.kind == Kind::choice; }

uint countAt(const std::byte* object, const Parameter& row) {
    assert(isWhole(row));
    uint count = 0;
    std::memcpy(&count, object + row.offset, sizeof count);
    return count;
}

void setCountAt(std::byte* object, const Parameter& row, double value) {
    assert(isWhole(row));
    if (std::isnan(value)) return;
    const uint count = clampedCount(value, row);
    std::memcpy(object + row.offset, &count, sizeof count);
}

vec3 valueAt(const std::byte* object, const Parameter& row) {
    if (isWhole(row)) return {static_cast<float>(countAt(object, row)), 0.0f, 0.0f};
    vec3 value{0.0f};
    std::memcpy(&value, object + row.offset,
                sizeof(float) * static_cast<std::size_t>(row.components()));
    return value;
}

void setValueAt(std::byte* object, const Parameter& row, vec3 value) {
    if (isWhole(row)) return setCountAt(object, row, value.x);
    if (row.kind == Kind::direction) {
        const std::optional<vec3> unit = unitDirection(value);
        if (!unit) return;
        value = *unit;
    }
    for (int i = 0; i < row.components(); ++i) {
        if (std::isnan(value[i])) return;
        value[i] = std::clamp(value[i], row.least, row.greatest);
    }
    std::memcpy(object + row.offset, &value,
                sizeof(float) * static_cast<std::size_t>(row.components()));
}

// The row of that name, or null.
const Parameter* rowNamed(std::span<const Parameter> rows, std::string_view name) {
    const auto row =
        std::ranges::find(rows, name, [](const Parameter& r) { return std::string_view(r.name); });
    return row == rows.end() ? nullptr : &*row;
}

std::string names(std::span<const Parameter> rows) {
    std::string list;
    for (const Parameter& row : rows) list += (list.empty() ? "" : ", ") + std::string(row.name);
    return list;
}

[[noreturn]] void failUnknown(std::string_view path) {
    throw std::runtime_error("there is no parameter \"" + std::string(path) +
                             "\"; there are over., under. and both. with " + names(kCoatRows) +
                             "; fur. with " + names(kFurRows));
}

// The text as the value of a row: one number, or three with commas between them.
vec3 parseValue(const std::string& path, const Parameter& row, std::string_view text) {
    vec3 value{0.0f};
    const char* at = text.data();
    const char* end = text.data() + text.size();
    bool valid = true;
    for (int i = 0; i < row.components() && valid; ++i) {
        if (i > 0) valid = at != end && *at++ == ',';
        while (valid && at != end && *at == ' ') ++at;
        const auto [stop, error] = std::from_chars(at, end, value[i]);
        valid = valid && error == std::errc();
        at = stop;
    }
    if (!valid || at != end) {
        throw std::runtime_error(
            path + " is \"" + std::string(text) + "\", which is not " +
            (row.components() == 3 ? "three numbers with commas" : "a number") + "; range " +
            rangeText(row));
    }
    checkRange(path, row, value);
    return value;
}

// As parseValue, without the rounding of a float.
uint parseCount(const std::string& path, const Parameter& row, std::string_view text) {
    std::uint64_t count = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || stop != text.data() + text.size()) {
        throw std::runtime_error(path + " is \"" + std::string(text) +
                                 "\", which is not a whole number; range " + rangeText(row));
    }
    return checkedCount(path, row, count);
}

template <class Object>
void setFromText(Object& object, const std::string& path, const Parameter& row,
                 std::string_view text) {
    if (row.kind == Kind::choice) {
        setParameterCount(object, row, choiceNamed(path, row, text));
    } else if (row.kind == Kind::count) {
        setParameterCount(object, row, parseCount(path, row, text));
    } else {
        setParameter(object, row, parseValue(path, row, text));
    }
}

}  // namespace

std::span<const Parameter> coatParameters() { return kCoatRows; }

const Parameter& styleRow() { return *rowNamed(kCoatRows, "style"); }

std::span<const Parameter> furParameters() { return kFurRows; }

Fur defaultFur() {
    Coat over{};
    over.stiffness = 0.4f;
    over.endRandomness = 0.16f;
    over.normalRandomness = 0.5f;
    over.directionWeight = 0.6f;
    over.relativeLength = 1.0f;
    over.ambient = {0.30f, 0.29f, 0.27f};
    over.diffuse = {0.60f, 0.57f, 0.53f};
    over.specular = {0.16f, 0.15f, 0.14f};
    over.shininess = 50.0f;
    over.rootColor = {0.36f, 0.34f, 0.32f};
    over.tipColor = {1.0f, 0.98f, 0.95f};
    over.colorNoise = 0.22f;
    over.width = 0.0f;
    over.taper = 1.0f;
    over.style = kStylePolyline;
    over.clumpSize = 50.0f;
    over.clumpShape = 2.0f;
    over.frizzWaves = 4.0f;

    Coat under = over;
    under.stiffness = 0.7f;
    under.endRandomness = 0.25f;
    under.directionWeight = 0.5f;
    under.relativeLength = 0.45f;
    under.specular = {0.06f, 0.06f, 0.06f};
    under.shininess = 16.0f;
    under.tipColor = {0.85f, 0.82f, 0.78f};

    Fur fur{};
    fur.over = over;
    fur.under = under;
    fur.gravityDirection = {0.0f, -1.0f, 0.0f};
    fur.gravity = 1.0f;
    fur.windDirection = {1.0f, 0.0f, 0.0f};
    fur.gusts = 0.5f;
    fur.gustRate = 0.5f;
    fur.gustSize = 0.25f;
    fur.share = 0.3f;
    fur.hairs = 100'000;
    fur.seed = 1;
    fur.skinColor = 1.0f;
    return fur;
}

vec3 parameterValue(const Coat& coat, const Parameter& row) {
    return valueAt(reinterpret_cast<const std::byte*>(&coat), row);
}

vec3 parameterValue(const Fur& fur, const Parameter& row) {
    return valueAt(reinterpret_cast<const std::byte*>(&fur), row);
}

void setParameter(Coat& coat, const Parameter& row, vec3 value) {
    setValueAt(reinterpret_cast<std::byte*>(&coat), row, value);
}

void setParameter(Fur& fur, const Parameter& row, vec3 value) {
    setValueAt(reinterpret_cast<std::byte*>(&fur), row, value);
}

uint parameterCount(const Coat& coat, const Parameter& row) {
    return countAt(reinterpret_cast<const std::byte*>(&coat), row);
}

uint parameterCount(const Fur& fur, const Parameter& row) {
    return countAt(reinterpret_cast<const std::byte*>(&fur), row);
}

void setParameterCount(Coat& coat, const Parameter& row, uint count) {
    setCountAt(reinterpret_cast<std::byte*>(&coat), row, count);
}

void setParameterCount(Fur& fur, const Parameter& row, uint count) {
    setCountAt(reinterpret_cast<std::byte*>(&fur), row, count);
}

void setParameter(Fur& fur, std::string_view path, std::string_view value) {
    const std::size_t dot = path.find('.');
    if (dot == std::string_view::npos) failUnknown(path);
    const std::string_view owner = path.substr(0, dot);
    const std::string_view name = path.substr(dot + 1);
    const std::string whole(path);
    if (owner == "fur") {
        const Parameter* row = rowNamed(kFurRows, name);
        if (!row) failUnknown(path);
        setFromText(fur, whole, *row, value);
        return;
    }
    const bool over = owner == "over" || owner == "both";
    const bool under = owner == "under" || owner == "both";
    const Parameter* row = over || under ? rowNamed(kCoatRows, name) : nullptr;
    if (!row) failUnknown(path);
    if (over) setFromText(fur.over, whole, *row, value);
    if (under) setFromText(fur.under, whole, *row, value);
}

std::string rangeText(const Parameter& row) {
    if (row.kind == Kind::choice) {
        std::string list;
        for (const char* name : row.choices) list += (list.empty() ? "" : ", ") + std::string(name);
        return list;
    }
    const bool all32Bits = row.kind == Kind::count && row.greatest >= kMaxUint;
    return floatText(row.least) + ".." + (all32Bits ? "4294967295" : floatText(row.greatest));
}

void checkRange(const std::string& path, const Parameter& row, vec3 value) {
    for (int i = 0; i < row.components(); ++i) {
        if (value[i] >= row.least && value[i] <= row.greatest) continue;
        std::string text = floatText(value.x);
        for (int j = 1; j < row.components(); ++j) text.append(",").append(floatText(value[j]));
        throw std::runtime_error(path + " is " + text + ", range " + rangeText(row));
    }
    if (row.kind == Kind::direction && !unitDirection(value)) {
        throw std::runtime_error(path + " is 0,0,0, which is no direction; range " +
                                 rangeText(row));
    }
}

uint choiceNamed(const std::string& path, const Parameter& row, std::string_view name) {
    const auto found =
        std::ranges::find(row.choices, name, [](const char* n) { return std::string_view(n); });
    if (found == row.choices.end())
        throw std::runtime_error(path + " is \"" + std::string(name) + "\", it may be " +
                                 rangeText(row));
    return static_cast<uint>(found - row.choices.begin());
}

uint checkedCount(const std::string& path, const Parameter& row, std::uint64_t value) {
    if (value > std::numeric_limits<uint>::max() || static_cast<float>(value) > row.greatest) {
        throw std::runtime_error(path + " is " + std::to_string(value) + ", range " +
                                 rangeText(row));
    }
    return static_cast<uint>(value);
}

std::optional<vec3> unitDirection(vec3 value) {
    const float length = glm::length(value);
    if (std::abs(length - 1.0f) < 1e-6f) return value;
    if (!(length > 1e-6f) || std::isinf(length)) return std::nullopt;
    return value / length;
}

}  // namespace pelage
