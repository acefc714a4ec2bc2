// script_text.cpp -- brushes as words.
#include "script_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <stdexcept>

#include "text.h"
#include "tools.h"

namespace pelage {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::string_view kAxes = "xyz";

std::optional<std::size_t> place(std::span<const char* const> names, std::string_view word) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i]) return i;
    return std::nullopt;
}

// "xz": the axes that the next word names; x alone where it names none.
glm::bvec3 axesFromWords(Words& words) {
    Words ahead = words;
    const std::string_view word = ahead.next();
    if (word.empty() || word.find_first_not_of(kAxes) != std::string_view::npos)
        return {true, false, false};
    words = ahead;
    glm::bvec3 axes(false);
    for (const char letter : word) axes[static_cast<int>(kAxes.find(letter))] = true;
    return axes;
}

}  // namespace

const ToolInfo& toolNamed(std::string_view word) {
    std::string known;
    for (const ToolInfo& row : tools()) {
        if (word == row.name) return row;
        known += std::string(known.empty() ? "" : ", ") + row.name;
    }
    throw std::runtime_error("no tool " + inQuotes(word) + "; there are " + known);
}

std::string toolText(const Brush& brush) {
    const ToolInfo& tool = toolInfo(brush.tool);
    std::string text = tool.name;
    if (brush.tool == Tool::segment)
        text += brush.segment.empty() ? " #" : ' ' + wordText(brush.segment);
    const Mode mode = modeOf(brush);
    if (tool.hasSet || mode == Mode::subtract)
        text += std::string(" ") + modeNames()[static_cast<std::size_t>(mode)];
    if (mode == Mode::set) text += ' ' + floatText(brush.value);
    if (mode == Mode::scale) text += ' ' + floatText(brush.factor);
    if (brush.tool == Tool::tint && mode != Mode::subtract)
        text += " color " + pointText(brush.color);
    return text + " strength " + floatText(brush.strength);
}

std::string brushText(const Brush& brush) {
    std::string text = toolText(brush) + " radius " + floatText(brush.radius);
    if (brush.falloff != Falloff::smooth)
        text += std::string(" falloff ") + falloffNames()[static_cast<std::size_t>(brush.falloff)];
    if (glm::any(brush.mirror)) text += " mirror";
    if (brush.mirror.y || brush.mirror.z) {
        text += ' ';
        for (int axis = 0; axis < 3; ++axis)
            if (brush.mirror[axis]) text += kAxes[static_cast<std::size_t>(axis)];
    }
    if (!brush.alongSurface) text += " straight";
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

std::string_view Words::path() {
    const std::size_t first = std::min(rest_.find_first_not_of(kBlanks), rest_.size());
    rest_.remove_prefix(first);
    if (rest_.ends_with('\r')) rest_.remove_suffix(1);
    return rest_;
}

void expectEnd(Words& words) {
    if (!words.done())
        throw std::runtime_error("does not expect " + inQuotes(words.next()) + " here");
}

void expectWord(Words& words, std::string_view expected) {
    const std::string_view word = words.next();
    if (word != expected)
        throw std::runtime_error("expects " + std::string(expected) + " and not " + inQuotes(word));
}

std::string wordText(std::string_view text) {
    std::string word;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte > 0x20 && byte != 0x7f && byte != '%') {
            word += c;
            continue;
        }
        constexpr char kDigits[] = "0123456789ABCDEF";
        word += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
    return word;
}

std::string textOfWord(std::string_view word) {
    std::string text;
    while (!word.empty()) {
        unsigned byte = 0;
        const bool escaped = word.front() == '%';
        if (escaped) {
            const char* begin = word.data() + 1;
            if (word.size() < 3 || std::from_chars(begin, begin + 2, byte, 16).ptr != begin + 2)
                throw std::runtime_error("no two hexadecimal digits after % in " + inQuotes(word));
        }
        text += escaped ? static_cast<char>(static_cast<unsigned char>(byte)) : word.front();
        word.remove_prefix(escaped ? 3 : 1);
    }
    return text;
}

float numberFrom(std::string_view word, std::string_view what, float least, float greatest) {
    const std::optional<float> number = floatFromText(word);
    if (!number || *number < least || *number > greatest)
        throw std::runtime_error(std::string(what) + " " + inQuotes(word) + " is no number from " +
                                 floatText(least) + " to " + floatText(greatest));
    return *number;
}

float numberAfter(Words& words, std::string_view what, float least, float greatest) {
    return numberFrom(words.next(), what, least, greatest);
}

vec3 pointAfter(Words& words, std::string_view what, float greatest) {
    vec3 point(0.0f);
    for (int i = 0; i < 3; ++i) point[i] = numberAfter(words, what, -greatest, greatest);
    return point;
}

std::string pointText(vec3 point) {
    return floatText(point.x) + ' ' + floatText(point.y) + ' ' + floatText(point.z);
}

BrushWords brushFromWords(Words& words, bool ofStroke) {
    constexpr float kMost = 1e6f;  // m; also keeps squares of it finite
    BrushWords found;
    Brush& brush = found.brush;
    brush.tool = toolNamed(words.next()).tool;
    if (brush.tool == Tool::segment) {
        brush.segment = textOfWord(words.next());
        if (brush.segment.empty()) throw std::runtime_error("the brush names no body segment");
        if (brush.segment == "#") brush.segment.clear();
    }
    if (!ofStroke) brush.strength = 1.0f;
    const ToolInfo& tool = toolInfo(brush.tool);
    bool radius = false, value = false;
    for (std::string_view word = words.next();; word = words.next()) {
        if (const auto mode = place(modeNames(), word)) {
            brush.mode = static_cast<Mode>(*mode);
            const float most = tool.ofLength ? kMost : 1.0f;
            if (brush.mode == Mode::scale && !tool.hasScale)
                throw std::runtime_error(std::string(tool.name) + " does not scale");
            if (brush.mode == Mode::scale)
                brush.factor = numberAfter(words, word, 0.0f, kGreatestFactor);
            value = brush.mode == Mode::set;
            if (value) brush.value = numberAfter(words, word, 0.0f, most);
        } else if (brush.tool == Tool::tint && word == "color") {
            for (int i = 0; i < 3; ++i) brush.color[i] = numberAfter(words, word, 0.0f, 1.0f);
        } else if (ofStroke && word == "radius") {
            brush.radius = numberAfter(words, word, 1e-9f, kMost);
            radius = true;
        } else if (word == "strength") {
            brush.strength = numberAfter(words, word, 0.0f, 1.0f);
        } else if (ofStroke && word == "falloff") {
            const std::string_view name = words.next();
            const auto falloff = place(falloffNames(), name);
            if (!falloff)
                throw std::runtime_error("no falloff " + inQuotes(name) +
                                         "; there are smooth, linear, sharp, constant");
            brush.falloff = static_cast<Falloff>(*falloff);
        } else if (ofStroke && word == "mirror") {
            brush.mirror = axesFromWords(words);
        } else if (ofStroke && word == "straight") {
            brush.alongSurface = false;
        } else if (ofStroke && word == "through") {
            brush.facingOnly = false;
        } else {
            found.stopped = word;
            break;
        }
    }
    if (tool.hasSet && !tool.add && !value)
        throw std::runtime_error(std::string(tool.name) + " needs set and a value");
    if (ofStroke && !radius) throw std::runtime_error("the stroke says no radius");
    return found;
}

}  // namespace pelage
