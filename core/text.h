// text.h -- how numbers and foreign words stand in files and in messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pelage {

// The shortest text that reads back to the same float, -0 included; whole numbers below 1e9 without
// an exponent.
std::string floatText(float number);
// Empty unless all of the text is one finite number.
std::optional<float> floatFromText(std::string_view text);

// Empty unless all of the text is one whole number below 2^32.
std::optional<std::uint32_t> wholeFromText(std::string_view text);

// A text of a file as it may stand in a message: one line, at most 80 bytes, no control codes.
std::string inQuotes(std::string_view text);

// As it stands between the tags of HTML and SVG, and in their attributes.
std::string markupText(std::string_view text);

// As one field of a CSV file (RFC 4180): quoted where it has to be.
std::string csvField(std::string_view text);

// RFC 4648, with padding.
std::string base64(std::span<const std::byte> bytes);

}  // namespace pelage
