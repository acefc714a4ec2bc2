// script_text.cpp -- numbers and brushes as words.
#include "script_text.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace pelage {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string quoted(std::string_view word) {
    constexpr std::size_t kShown = 60;  // of what may be a file of noise
    return word.size() <= kShown ? '"' + std::string(word) + '"'
                                 : '"' + std::string(word.substr(0, kShown)) + "...\"";
}

std::optional<std::size_t> place(std::span<const char* const> names, std::string_view word) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i]) return i;
    return std::nullopt;
}

const ToolInfo& toolNamed(std::string_view word) {
    std::string known;
    for (const ToolInfo& row : tools()) {
        if (word == row.name) return row;
        known += std::string(known.empty() ? "" : ", ") + row.name;
    }
    throw std::runtime_error("no tool " + quoted(word) + "; there are " + known);
}

float numberAfter(Words& words, std::string_view what, float least, float greatest) {
    const std::string_view word = words.next();
    const std::optional<float> number = floatFromText(word);
    if (!number || *number < least || *number > greatest)
        throw std::runtime_error(std::string(what) + " " + quoted(word) + " is no number from " +
                                 floatText(least) + " to " + floatText(greatest));
    return *number;
}

}  // namespace

std::string floatText(float number) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, number).ptr;
    return {text, end};
}

std::optional<float> floatFromText(std::string_view text) {
    float number = 0.0f;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::string brushText(const Brush& brush) {
    std::string text = toolInfo(brush.tool).name;
    text += std::string(" ") + modeNames()[static_cast<std::size_t>(brush.mode)];
    if (brush.mode == Mode::set) text += ' ' + floatText(brush.value);
    text += " radius " + floatText(brush.radius) + " strength " + floatText(brush.strength);
    if (brush.falloff != Falloff::smooth)
        text += std::string(" falloff ") + falloffNames()[static_cast<std::size_t>(brush.falloff)];
    if (brush.mirrorX) text += " mirror";
    if (!brush.facingOnly) text += " through";
    return text;
}

std::string_view Words::next() {
    const std::string_view all = rest();
    const std::string_view word = all.substr(0, all.find_first_of(kBlanks));
    rest_ = all.substr(word.size());
    return word;
}

std::string_view Words::rest() {
    const std::size_t first = rest_.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return rest_ = {};
    const std::size_t last = rest_.find_last_not_of(kBlanks);
    return rest_ = rest_.substr(first, last - first + 1);
}

BrushWords brushFromWords(Words& words, bool needsRadius) {
    constexpr float kMost = 1e6f;  // m; also keeps squares of it finite
    BrushWords found;
    Brush& brush = found.brush;
    brush.tool = toolNamed(words.next()).tool;
    bool radius = false;
    for (std::string_view word = words.next();; word = words.next()) {
        if (const auto mode = place(modeNames(), word)) {
            brush.mode = static_cast<Mode>(*mode);
            if (brush.mode == Mode::set) brush.value = numberAfter(words, word, 0.0f, kMost);
        } else if (word == "radius") {
            brush.radius = numberAfter(words, word, 1e-9f, kMost);
            radius = true;
        } else if (word == "strength") {
            brush.strength = numberAfter(words, word, 0.0f, 1.0f);
        } else if (word == "falloff") {
            const std::string_view name = words.next();
            const auto falloff = place(falloffNames(), name);
            if (!falloff)
                throw std::runtime_error("no falloff " + quoted(name) +
                                         "; there are smooth, linear, sharp, constant");
            brush.falloff = static_cast<Falloff>(*falloff);
        } else if (word == "mirror") {
            brush.mirrorX = true;
        } else if (word == "through") {
            brush.facingOnly = false;
        } else {
            found.stopped = word;
            break;
        }
    }
    if (needsRadius && !radius) throw std::runtime_error("the stroke says no radius");
    return found;
}

}  // namespace pelage
