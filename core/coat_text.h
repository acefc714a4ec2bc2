// coat_text.h -- how values and ranges of coat parameters read in messages. For coat*.cpp only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "coat.h"

namespace pelage {

// "0..1", or the names of a choice: "line, polyline"
std::string rangeText(const Parameter& row);

// Throws "over.stiffness is 3, range 0..1", also for NaN and for a direction of no length.
void checkRange(const std::string& path, const Parameter& row, vec3 value);
// The number of a choice by its name; throws std::runtime_error that lists the names.
uint choiceNamed(const std::string& path, const Parameter& row, std::string_view name);
// The value as a count; throws as checkRange does.
uint checkedCount(const std::string& path, const Parameter& row, std::uint64_t value);

// The unit vector along value: value itself, bit for bit, where that is one already; none where the
// length is 0, NaN or more than a float holds.
std::optional<vec3> unitDirection(vec3 value);

}  // namespace pelage
