// region_text.cpp -- regions and their edits as words.
#include "region_text.h"

#include <array>
#include <optional>
#include <span>
#include <stdexcept>

#include "text.h"

namespace pelage {
namespace {

constexpr std::array<const char*, 8> kPlaces{"all",  "sphere", "box",    "segment",
                                             "mask", "narrow", "curved", "lasso"};
constexpr std::array<const char*, 3> kChannels{"length", "density", "direction"};  // as Channel
constexpr std::array<const char*, 4> kActs{"scale", "set", "smooth", "randomise"};
constexpr float kMost = 1e6f;  // m, and of factors; also keeps squares finite

std::size_t placeOf(std::span<const char* const> names, std::string_view word, const char* what) {
    std::string known;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (word == names[i]) return i;
        known += std::string(i ? ", " : "") + names[i];
    }
    throw std::runtime_error(std::string("no ") + what + " " + inQuotes(word) + "; there are " +
                             known);
}

float number(Words& words, std::string_view what, float least, float greatest = kMost) {
    return numberAfter(words, what, least, greatest);
}

// The points of the lasso, up to the first word that is no number, which it returns.
std::string_view readPolygon(Words& words, std::vector<vec2>& polygon) {
    std::string_view word = words.next();
    for (; floatFromText(word); word = words.next()) {
        const float x = numberFrom(word, "points", -kMost, kMost);
        polygon.push_back({x, number(words, "points", -kMost)});
    }
    return word;
}

uint seedFrom(std::string_view word) {
    if (const auto seed = wholeFromText(word)) return *seed;
    throw std::runtime_error("seed " + inQuotes(word) + " is no number from 0 to 4294967295");
}

RegionEdit readEdit(Words& words) {
    RegionEdit change;
    change.channel = static_cast<Channel>(placeOf(kChannels, words.next(), "channel"));
    change.act = static_cast<RegionAct>(placeOf(kActs, words.next(), "operation"));
    if (change.act == RegionAct::scale) {
        change.value = number(words, "scale", 0.0f);
    } else if (change.act == RegionAct::set && change.channel == Channel::direction) {
        change.direction = pointAfter(words, "set");
    } else if (change.act == RegionAct::set) {
        change.value = number(words, "set", 0.0f, change.channel == Channel::length ? kMost : 1.0f);
    } else if (change.act == RegionAct::randomise || !words.done()) {
        change.value = number(words, kActs[static_cast<std::size_t>(change.act)], 0.0f, 1.0f);
    }
    if (change.act == RegionAct::randomise && !words.done()) {
        expectWord(words, "seed");
        change.seed = seedFrom(words.next());
    }
    return change;
}

void add(std::string& text, vec3 numbers) { text += ' ' + pointText(numbers); }

std::string channelName(Channel channel) { return kChannels[static_cast<std::size_t>(channel)]; }

std::string editText(const RegionEdit& change) {
    std::string text =
        channelName(change.channel) + ' ' + kActs[static_cast<std::size_t>(change.act)];
    if (change.act == RegionAct::set && change.channel == Channel::direction)
        add(text, change.direction);
    else
        text += ' ' + floatText(change.value);
    if (change.act == RegionAct::randomise && change.seed != 0)
        text += " seed " + std::to_string(change.seed);
    return text;
}

}  // namespace

Region regionNamed(std::string_view where, Words& words) {
    Region region;
    region.where = static_cast<Where>(placeOf(kPlaces, where, "region"));
    std::optional<std::string_view> ahead;
    switch (region.where) {
        case Where::sphere:
            region.center = pointAfter(words, "the centre");
            expectWord(words, "radius");
            region.radius = number(words, "radius", 0.0f);
            break;
        case Where::box:
            region.center = pointAfter(words, "the centre");
            expectWord(words, "half");
            region.half = pointAfter(words, "half");
            break;
        case Where::segment:
            region.segment = textOfWord(words.next());
            break;
        case Where::narrow:
            region.width = number(words, "narrow", 0.0f);
            break;
        case Where::curved:
            region.curvature = number(words, "curved", 0.0f, 1e9f);
            break;
        case Where::lasso: {
            if (Words after = words; after.next() == "eye") {
                words = after;
                region.eye = pointAfter(words, "eye");
            }
            expectWord(words, "view");
            for (int i = 0; i < 16; ++i)
                region.viewProjection[i / 4][i % 4] = number(words, "view", -1e30f, 1e30f);
            expectWord(words, "points");
            ahead = readPolygon(words, region.polygon);
            break;
        }
        case Where::all:
        case Where::mask:
            break;
    }
    for (std::string_view word = ahead ? *ahead : words.next(); !word.empty() && word != ":";
         word = words.next()) {
        if (word == "sizes") {
            region.sizes = true;
        } else if (word == "falloff") {
            region.falloff = number(words, word, 0.0f, 1e9f);
        } else if (word == "turn" && region.where == Where::box) {
            region.turn = pointAfter(words, word);
        } else {
            throw std::runtime_error("no region knows " + inQuotes(word));
        }
    }
    return region;
}

std::string regionText(const Region& region) {
    std::string text = kPlaces[static_cast<std::size_t>(region.where)];
    switch (region.where) {
        case Where::sphere:
            add(text, region.center);
            text += " radius " + floatText(region.radius);
            break;
        case Where::box:
            add(text, region.center);
            add(text += " half", region.half);
            if (region.turn != vec3(0.0f)) add(text += " turn", region.turn);
            break;
        case Where::segment:
            text += ' ' + wordText(region.segment);
            break;
        case Where::narrow:
            text += ' ' + floatText(region.width);
            break;
        case Where::curved:
            text += ' ' + floatText(region.curvature);
            break;
        case Where::lasso:
            if (region.eye != vec3(0.0f)) add(text += " eye", region.eye);
            text += " view";
            for (int i = 0; i < 16; ++i)
                text += ' ' + floatText(region.viewProjection[i / 4][i % 4]);
            text += " points";
            for (const vec2 at : region.polygon)
                text += ' ' + floatText(at.x) + ' ' + floatText(at.y);
            break;
        case Where::all:
        case Where::mask:
            break;
    }
    if (region.sizes) text += " sizes";
    if (region.falloff > 0.0f) text += " falloff " + floatText(region.falloff);
    return text;
}

RegionWords regionFromWords(Words& words) {
    RegionWords read;
    read.region = regionNamed(words.next(), words);
    if (words.done()) throw std::runtime_error("the region has no : with an edit after it");
    read.change = readEdit(words);
    return read;
}

std::string regionLine(const Region& region, const RegionEdit& change) {
    return "region " + regionText(region) + " : " + editText(change);
}

std::string regionLabel(const Region& region, const RegionEdit& change) {
    return std::string("Region ") + kPlaces[static_cast<std::size_t>(region.where)] + ": " +
           channelName(change.channel) + ' ' + kActs[static_cast<std::size_t>(change.act)];
}

}  // namespace pelage
