// text.cpp -- numbers to text and back, without a locale.
#include "text.h"

#include <charconv>
#include <cmath>

namespace pelage {

std::string floatText(float number) {
    char text[32];
    const bool whole = std::abs(number) < 1e9f && number == std::floor(number);
    const auto end =
        whole ? std::to_chars(text, text + sizeof text, number, std::chars_format::fixed).ptr
              : std::to_chars(text, text + sizeof text, number).ptr;
    return {text, end};
}

std::optional<float> floatFromText(std::string_view text) {
    float number = 0.0f;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::optional<std::uint32_t> wholeFromText(std::string_view text) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::string inQuotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text.substr(0, 80)) {
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return out + (text.size() > 80 ? "...\"" : "\"");
}

}  // namespace pelage
