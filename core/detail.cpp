// detail.cpp -- the rules of detail by name, and as text.
#include "detail.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "text.h"

namespace pelage {
namespace {

constexpr float kShortestFrame = 1e-3f, kLongestFrame = 1e6f;  // ms

[[noreturn]] void refuse(std::string_view text) {
    throw std::runtime_error(
        inQuotes(text) +
        " is no detail: all, distance, share:S (0.001 to 1), pixels:P (0.01 to 16), flip:F "
        "(0.001 to 1), ms:T (0.001 to 1e6), or a rule and a time joined by a comma");
}

float numberWithin(std::string_view number, float least, float greatest, std::string_view all) {
    const std::optional<float> value = floatFromText(number);
    if (!value || *value < least || *value > greatest) refuse(all);
    return *value;
}

}  // namespace

const std::array<DetailRule, 5> kDetailRules{{
    {"all", "All hairs", "Every hair, however thin it is on the screen.", nullptr},
    {"distance", "By distance",
     "The number of hairs falls with the distance (van Gelder and Wilhelms, 1997).", nullptr},
    {"share", "A share", "This share of the hairs is drawn, each wider in the same proportion.",
     "%.3f", 0.001f, 1.0f, 0.5f},
    {"pixels", "By error",
     "Nowhere may the edge of a hair be off by more than this: as few and wide hairs, of as few "
     "segments as it allows.",
     "%.2f px", 0.01f, 16.0f, 0.5f},
    {"flip", "By FLIP",
     "As coarse as it may be for this mean error of the picture: the difference that an eye sees "
     "between it and the one with all hairs (FLIP).",
     "%.3f", 0.001f, 1.0f, 0.05f},
}};

const DetailRule& ruleOf(const Detail& detail) {
    return kDetailRules[static_cast<std::size_t>(detail.rule)];
}

Detail detailFromText(std::string_view text) {
    Detail detail{.rule = Detail::Rule::all};
    bool ruled = false;
    std::size_t begin = 0, end = 0;
    for (; end != std::string_view::npos; begin = end + 1) {
        end = text.find(',', begin);
        const std::string_view part = text.substr(begin, end - begin);
        const std::size_t colon = part.find(':');
        const bool limited = colon != std::string_view::npos;
        const std::string_view name = part.substr(0, colon);
        const std::string_view number = limited ? part.substr(colon + 1) : std::string_view();
        if (name == "ms" && detail.milliseconds == 0.0f) {
            detail.milliseconds = numberWithin(number, kShortestFrame, kLongestFrame, text);
            continue;
        }
        const auto row = std::ranges::find_if(
            kDetailRules, [&](const DetailRule& rule) { return name == rule.name; });
        if (row == kDetailRules.end() || ruled || limited != (row->format != nullptr)) refuse(text);
        ruled = true;
        detail.rule = static_cast<Detail::Rule>(row - kDetailRules.begin());
        if (limited) detail.limit = numberWithin(number, row->least, row->greatest, text);
    }
    return detail;
}

std::string textOf(const Detail& detail) {
    const DetailRule& rule = ruleOf(detail);
    std::string text = rule.name;
    if (rule.format) text += ":" + floatText(detail.limit);
    if (detail.milliseconds > 0.0f) text += ",ms:" + floatText(detail.milliseconds);
    return text;
}

}  // namespace pelage
