// segment_text.cpp -- lines of script that comb along the body or change its segments.
#include "segment_text.h"

#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "body.h"
#include "segment_comb.h"
#include "text.h"

namespace pelage {
namespace {

constexpr float kMost = 1e12f;  // m; also keeps squares finite

float weightFrom(Words& words) { return numberAfter(words, "weight", 0.0f, 1.0f); }

uint segmentFrom(const Groom& groom, Words& words) {
    return segmentNamed(groom.body(), textOfWord(words.next()));
}

// "root x y z tip x y z"
struct Ends {
    vec3 root{0.0f}, tip{0.0f};
};

Ends endsFrom(Words& words) {
    Ends ends;
    for (const auto& [name, point] : {std::pair("root", &ends.root), std::pair("tip", &ends.tip)}) {
        expectWord(words, name);
        *point = pointAfter(words, name, kMost);
    }
    return ends;
}

std::string endsText(vec3 root, vec3 tip) {
    return " root " + pointText(root) + " tip " + pointText(tip);
}

}  // namespace

std::string segmentWord(const Groom& groom, uint segment) {
    return wordText(nameOfSegment(groom.body(), segment));
}

std::string segmentLine(const Groom& groom, uint segment, vec3 axis, float weight) {
    return "segment " + segmentWord(groom, segment) + " axis " + pointText(axis) + " weight " +
           floatText(weight);
}

std::string headToTailLine(float weight) { return "comb head-to-tail weight " + floatText(weight); }

std::string addSegmentLine(const Segment& segment) {
    return "body add " + wordText(segment.name) + endsText(segment.root, segment.tip);
}

std::string moveSegmentLine(const Groom& groom, uint segment, vec3 root, vec3 tip) {
    return "body move " + segmentWord(groom, segment) + endsText(root, tip);
}

std::string renameSegmentLine(const Groom& groom, uint segment, const std::string& name) {
    return "body rename " + segmentWord(groom, segment) + ' ' + wordText(name);
}

std::string removeSegmentLine(const Groom& groom, uint segment) {
    return "body remove " + segmentWord(groom, segment);
}

void runSegment(Editor& editor, Words& words) {
    const Groom& groom = editor.document().groom;
    const uint segment = segmentFrom(groom, words);
    const Segment& chosen = groom.body()[segment];
    std::optional<vec3> axis;
    float weight = 1.0f;
    while (!words.done()) {
        const std::string_view word = words.next();
        if (word == "axis") {
            axis = pointAfter(words, word, kMost);
        } else if (word == "weight") {
            weight = weightFrom(words);
        } else {
            throw std::runtime_error("does not expect " + inQuotes(word) + " here");
        }
    }
    const vec3 along = axis ? axisOf({"", vec3(0.0f), *axis}) : axisOf(chosen);
    if (along == vec3(0.0f))
        throw std::runtime_error(axis ? "an axis needs a length"
                                      : "body segment " + inQuotes(chosen.name) +
                                            " has no axis of its own; name one");
    const std::string label = "Comb " + chosen.name;
    editor.edit([&](Document& document) {
        combSegment(*document.skin, document.groom, segment, along, weight);
    });
    editor.commit(label);
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
    expectEnd(words);
    editor.edit(
        [&](Document& document) { combHeadToTail(*document.skin, document.groom, weight); });
    editor.commit("Comb from head to tail");
}

void runBody(Editor& editor, Words& words) {
    Groom groom = editor.document().groom;
    const std::string_view what = words.next();
    std::string label;
    if (what == "add") {
        const std::string name = textOfWord(words.next());
        const Ends ends = endsFrom(words);
        expectEnd(words);
        addSegment(groom, {name, ends.root, ends.tip});
        label = "Add segment " + name;
    } else if (what == "move" || what == "rename" || what == "remove") {
        const uint segment = segmentFrom(groom, words);
        label = groom.body()[segment].name;
        if (what == "move") {
            const Ends ends = endsFrom(words);
            expectEnd(words);
            moveSegment(groom, segment, ends.root, ends.tip);
            label = "Move axis of " + label;
        } else if (what == "rename") {
            const std::string name = textOfWord(words.next());
            expectEnd(words);
            renameSegment(groom, segment, name);
            label = "Rename segment " + name;
        } else {
            expectEnd(words);
            removeSegment(groom, segment);
            label = "Remove segment " + label;
        }
    } else {
        throw std::runtime_error("does not know " + inQuotes(what) +
                                 "; there are add, move, rename, remove");
    }
    editor.edit([&](Document& document) { document.groom = std::move(groom); });
    editor.commit(std::move(label));
}

}  // namespace pelage
