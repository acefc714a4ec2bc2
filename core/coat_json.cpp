// coat_json.cpp -- the fur as the JSON object of extras.fur, and back; the only reader and writer.
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "coat.h"
#include "coat_text.h"

namespace pelage {
namespace {

constexpr int kVersion = 1;

// Numbers are float, so that the shortest text that reads back bit for bit is written (0.3, not
// 0.30000001192092896); names stay in the order of the table.
using FurJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                     std::int64_t, std::uint64_t, float>;

template <class Object>
FurJson valueToJson(const Object& object, const Parameter& row) {
    if (row.kind == ParameterKind::count) return parameterCount(object, row);
    if (row.kind == ParameterKind::choice) return row.choices[parameterCount(object, row)];
    const vec3 value = parameterValue(object, row);
    if (row.components() == 3) return FurJson::array({value.x, value.y, value.z});
    return value.x;
}

uint countFromJson(const FurJson& json, const std::string& path, const Parameter& row) {
    if (json.is_number_unsigned()) return checkedCount(path, row, json.get<std::uint64_t>());
    if (json.is_number()) {
        // Some writers know only floating-point numbers: 100000.0.
        const float value = json.get<float>();
        checkRange(path, row, vec3(value, 0.0f, 0.0f));
        if (value == std::floor(value)) {
            return checkedCount(path, row, static_cast<std::uint64_t>(value));
        }
    }
    throw std::runtime_error(path + " is not a whole number, range " + rangeText(row));
}

vec3 valueFromJson(const FurJson& json, const std::string& path, const Parameter& row) {
    vec3 value{0.0f};
    if (row.components() == 1) {
        if (!json.is_number()) {
            throw std::runtime_error(path + " is not a number, range " + rangeText(row));
        }
        value.x = json.get<float>();
    } else {
        bool valid = json.is_array() && json.size() == 3;
        for (int i = 0; valid && i < 3; ++i) {
            valid = json[static_cast<std::size_t>(i)].is_number();
            if (valid) value[i] = json[static_cast<std::size_t>(i)].get<float>();
        }
        if (!valid) {
            throw std::runtime_error(path + " is not an array of 3 numbers, range " +
                                     rangeText(row));
        }
    }
    checkRange(path, row, value);
    return value;
}

// Reads the rows that are there; `prefix` is "over.", "under." or "".
template <class Object>
void readRows(Object& object, std::span<const Parameter> rows, const FurJson& json,
              const std::string& prefix) {
    for (const Parameter& row : rows) {
        const auto found = json.find(row.name);
        if (found == json.end()) continue;
        const std::string path = prefix + row.name;
        if (row.kind == ParameterKind::choice) {
            if (!found->is_string())
                throw std::runtime_error(path + " is not one of " + rangeText(row));
            setParameterCount(object, row, choiceNamed(path, row, found->get<std::string>()));
        } else if (row.kind == ParameterKind::count) {
            setParameterCount(object, row, countFromJson(*found, path, row));
        } else {
            setParameter(object, row, valueFromJson(*found, path, row));
        }
    }
}

void readCoat(Coat& coat, const FurJson& json, const std::string& name) {
    const auto found = json.find(name);
    if (found == json.end()) return;
    if (!found->is_object()) throw std::runtime_error(name + " is not an object");
    readRows(coat, coatParameters(), *found, name + ".");
}

void checkVersion(const FurJson& json) {
    const auto version = json.find("version");
    if (version == json.end()) return;
    if (!version->is_number_integer() || version->get<std::int64_t>() < 1) {
        throw std::runtime_error("version is not a whole number, range 1.." +
                                 std::to_string(kVersion));
    }
    if (version->is_number_unsigned() && version->get<std::uint64_t>() > kVersion) {
        throw std::runtime_error("version is " + version->dump() + ", this program reads 1.." +
                                 std::to_string(kVersion));
    }
}

}  // namespace

std::string furToJson(const Fur& fur, int indent) {
    FurJson json = {{"version", kVersion}};
    for (const Parameter& row : furParameters()) json[row.name] = valueToJson(fur, row);
    for (const Parameter& row : coatParameters()) {
        json["over"][row.name] = valueToJson(fur.over, row);
        json["under"][row.name] = valueToJson(fur.under, row);
    }
    return json.dump(indent);
}

Fur furFromJson(std::string_view text, const std::string& place) {
    const auto fail = [&](const std::string& what) {
        throw std::runtime_error(place + ": " + what);
    };
    FurJson json;
    try {
        json = FurJson::parse(text);
    } catch (const FurJson::exception& error) {
        fail("not JSON: " + std::string(error.what()));
    }
    if (!json.is_object()) fail("not a JSON object");
    Fur fur = defaultFur();
    try {
        checkVersion(json);
        readRows(fur, furParameters(), json, "");
        readCoat(fur.over, json, "over");
        readCoat(fur.under, json, "under");
    } catch (const std::runtime_error& error) {
        fail(error.what());
    }
    return fur;
}

}  // namespace pelage
