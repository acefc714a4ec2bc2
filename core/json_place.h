// json_place.h -- a value of a JSON file that knows where it stands, so that every complaint says
// so.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

using Json = nlohmann::json;

// The text as JSON. Refuses with std::runtime_error "name: ..." what is none, nests deeper than 200
// (what walks it may recurse), or holds a number that no float can hold.
Json parsedJson(std::string_view text, const std::string& name);

// What is asked for and is missing or of the wrong kind is refused with std::runtime_error
// "horse.gltf: accessors[3].count: is "many", not a whole number from 1 to 100".
class JsonPlace {
public:
    // `file` and `value` must outlive the place.
    JsonPlace(const std::string& file, const Json& value, std::string text = {})
        : file_(&file), value_(&value), text_(std::move(text)) {}

    const Json& json() const { return *value_; }
    const std::string& text() const { return text_; }
    std::size_t size() const { return value_->size(); }

    // Also false when this is no object.
    bool has(const char* member) const;
    JsonPlace at(const std::string& member) const;  // of an object
    JsonPlace at(std::size_t index) const;          // of an array
    // The member, which must be an array or object if it is there.
    std::optional<JsonPlace> array(const char* member) const;
    std::optional<JsonPlace> object(const char* member) const;

    std::size_t integer(std::size_t least, std::size_t greatest) const;
    std::size_t integer(const char* member, std::size_t least, std::size_t greatest) const;
    std::size_t integerOr(const char* member, std::size_t fallback, std::size_t greatest) const;
    std::optional<std::size_t> reference(const char* member) const;  // of an object, if it is there
    bool boolean(const char* member) const;                          // false when missing
    std::string string(const char* member) const;                    // empty when missing
    // Exactly `count` numbers that are finite as float; empty when missing.
    std::vector<float> numbers(const char* member, std::size_t count) const;
    float numberOr(const char* member, float fallback) const;

    [[noreturn]] void refuse(const std::string& what) const;

private:
    const std::string* file_;
    const Json* value_;
    std::string text_;
};

}  // namespace pelage
