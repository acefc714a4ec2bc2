// json_place.cpp -- the checks behind JsonPlace.
#include "json_place.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "text.h"

namespace pelage {
namespace {

// How a wrong value is shown: scalars as they are, the rest by kind.
std::string shown(const Json& value) {
    if (value.is_string()) return inQuotes(value.get_ref<const std::string&>());
    if (value.is_structured()) return std::string("an ") + value.type_name();
    return value.dump();
}

float finiteFloat(const JsonPlace& place) {
    if (!place.json().is_number()) place.refuse("is " + shown(place.json()) + ", not a number");
    const double value = place.json().get<double>();
    if (!(std::abs(value) <= 3.402823466e38))
        place.refuse("is " + shown(place.json()) + ", too large for a float");
    return static_cast<float>(value);
}

constexpr std::size_t kMaxDepth = 200;  // of nested JSON; what walks it later may recurse

// Refuses JSON that nests too deep, before anything recurses over it.
void checkDepth(std::string_view text, const std::string& name) {
    std::size_t depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') ++i;
            if (c == '"') inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kMaxDepth) {
                throw std::runtime_error(name + ": JSON at byte " + std::to_string(i) +
                                         " is nested deeper than " + std::to_string(kMaxDepth));
            }
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
}

}  // namespace

Json parsedJson(std::string_view text, const std::string& name) {
    checkDepth(text, name);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw std::runtime_error(name + ": JSON is broken or cut off at byte " +
                                 std::to_string(error.byte) + " of " + std::to_string(text.size()));
    } catch (const Json::exception&) {
        throw std::runtime_error(name + ": JSON holds a number that no float can hold");
    }
}

void JsonPlace::refuse(const std::string& what) const {
    throw std::runtime_error(*file_ + ": " + text_ + (text_.empty() ? "" : ": ") + what);
}

bool JsonPlace::has(const char* member) const {
    return value_->is_object() && value_->contains(member);
}

JsonPlace JsonPlace::at(const std::string& member) const {
    if (!value_->is_object()) refuse("is " + shown(*value_) + ", not an object");
    const auto found = value_->find(member);
    if (found == value_->end()) refuse("has no " + inQuotes(member));
    // Names of members come from the file, too, and may hold anything.
    const bool plain = member.size() <= 40 && std::all_of(member.begin(), member.end(), [](char c) {
                           return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
                       });
    const std::string name = plain ? member : inQuotes(member);
    return {*file_, *found, text_.empty() ? name : text_ + "." + name};
}

JsonPlace JsonPlace::at(std::size_t index) const {
    if (!value_->is_array()) refuse("is " + shown(*value_) + ", not an array");
    if (index >= value_->size()) refuse("has no element " + std::to_string(index));
    return {*file_, (*value_)[index], text_ + "[" + std::to_string(index) + "]"};
}

std::optional<JsonPlace> JsonPlace::array(const char* member) const {
    if (!has(member)) return std::nullopt;
    JsonPlace place = at(member);
    if (!place.json().is_array()) place.refuse("is " + shown(place.json()) + ", not an array");
    return place;
}

std::optional<JsonPlace> JsonPlace::object(const char* member) const {
    if (!has(member)) return std::nullopt;
    JsonPlace place = at(member);
    if (!place.json().is_object()) place.refuse("is " + shown(place.json()) + ", not an object");
    return place;
}

std::size_t JsonPlace::integer(std::size_t least, std::size_t greatest) const {
    // Some exporters write 3.0 for 3.
    std::optional<std::size_t> value;
    if (value_->is_number_unsigned()) {
        value = value_->get<std::size_t>();
    } else if (value_->is_number_float()) {
        const double real = value_->get<double>();
        if (real >= 0.0 && real < 1e15 && real == std::floor(real))
            value = static_cast<std::size_t>(real);
    }
    if (!value || *value < least || *value > greatest) {
        refuse("is " + shown(*value_) + ", not a whole number from " + std::to_string(least) +
               " to " + std::to_string(greatest));
    }
    return *value;
}

std::size_t JsonPlace::integer(const char* member, std::size_t least, std::size_t greatest) const {
    return at(member).integer(least, greatest);
}

std::size_t JsonPlace::integerOr(const char* member, std::size_t fallback,
                                 std::size_t greatest) const {
    return has(member) ? at(member).integer(0, greatest) : fallback;
}

std::optional<std::size_t> JsonPlace::reference(const char* member) const {
    if (!has(member)) return std::nullopt;
    return at(member).integer(0, 0xffffffffu);
}

bool JsonPlace::boolean(const char* member) const {
    if (!has(member)) return false;
    const JsonPlace place = at(member);
    if (!place.json().is_boolean())
        place.refuse("is " + shown(place.json()) + ", not true or false");
    return place.json().get<bool>();
}

std::string JsonPlace::string(const char* member) const {
    if (!has(member)) return {};
    const JsonPlace place = at(member);
    if (!place.json().is_string()) place.refuse("is " + shown(place.json()) + ", not a string");
    return place.json().get<std::string>();
}

std::vector<float> JsonPlace::numbers(const char* member, std::size_t count) const {
    const auto place = array(member);
    if (!place) return {};
    if (place->size() != count) {
        place->refuse("has " + std::to_string(place->size()) + " numbers, not " +
                      std::to_string(count));
    }
    std::vector<float> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(finiteFloat(place->at(i)));
    return out;
}

float JsonPlace::numberOr(const char* member, float fallback) const {
    return has(member) ? finiteFloat(at(member)) : fallback;
}

}  // namespace pelage
