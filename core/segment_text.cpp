// segment_text.cpp -- lines of script that comb along the body.
#include "segment_text.h"

#include <optional>
#include <stdexcept>
#include <string_view>

#include "segment_comb.h"
#include "text.h"

namespace pelage {
namespace {

float numberFrom(Words& words) {
    const std::string_view word = words.next();
    const std::optional<float> number = floatFromText(word);
    if (!number) throw std::runtime_error(inQuotes(word) + " is no number");
    return *number;
}

float weightFrom(Words& words) {
    const float weight = numberFrom(words);
    if (!(weight >= 0.0f && weight <= 1.0f))
        throw std::runtime_error("weight " + floatText(weight) + " is no number from 0 to 1");
    return weight;
}

}  // namespace

std::string segmentLine(const Skin& skin, uint segment, vec3 axis, float weight) {
    return "segment " + nameOfSegment(skin, segment) + " axis " + floatText(axis.x) + ' ' +
           floatText(axis.y) + ' ' + floatText(axis.z) + " weight " + floatText(weight);
}

std::string headToTailLine(float weight) { return "comb head-to-tail weight " + floatText(weight); }

void runSegment(Editor& editor, Words& words) {
    std::string name;
    std::optional<vec3> axis;
    float weight = 1.0f;
    while (!words.done()) {
        const std::string_view word = words.next();
        if (word == "axis") {
            vec3 numbers(0.0f);
            for (int i = 0; i < 3; ++i) numbers[i] = numberFrom(words);
            axis = numbers;
        } else if (word == "weight") {
            weight = weightFrom(words);
        } else if (axis || weight != 1.0f) {
            throw std::runtime_error("does not expect " + inQuotes(word) + " here");
        } else {
            name += (name.empty() ? "" : " ") + std::string(word);
        }
    }
    const Skin& skin = *editor.document().skin;
    const uint segment = segmentNamed(skin, name);
    const vec3 along = axis ? axisOf({"", vec3(0.0f), *axis}) : axisOf(skin.segments()[segment]);
    if (along == vec3(0.0f))
        throw std::runtime_error(axis ? "an axis needs a length"
                                      : "body segment " + inQuotes(name) +
                                            " has no axis of its own; name one");
    editor.edit([&](Document& document) {
        combSegment(*document.skin, document.groom, segment, along, weight);
    });
    editor.commit("Comb " + skin.segments()[segment].name);
}

void runHeadToTail(Editor& editor, Words& words) {
    const std::string_view what = words.next();
    if (what != "head-to-tail")
        throw std::runtime_error("does not know " + inQuotes(what) + "; there is head-to-tail");
    float weight = 1.0f;
    if (const std::string_view word = words.next(); word == "weight")
        weight = weightFrom(words);
    else if (!word.empty())
        throw std::runtime_error("does not expect " + inQuotes(word) + " here");
    if (!words.done())
        throw std::runtime_error("does not expect " + inQuotes(words.next()) + " here");
    editor.edit(
        [&](Document& document) { combHeadToTail(*document.skin, document.groom, weight); });
    editor.commit("Comb from head to tail");
}

}  // namespace pelage
