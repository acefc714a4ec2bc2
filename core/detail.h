// detail.h -- how much of the fur a view asks for: by a rule, by an error, by the time of a frame.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace pelage {

struct Detail {
    enum class Rule {
        all,
        distance,  // van Gelder and Wilhelms 1997, 3.3: hairs ~ 1/distance, a pixel wide at least
        share,
        pixels,
        flip,  // the mean over the picture, see fidelity.h
    };
    Rule rule = Rule::distance;
    float limit = 1.0f;         // of the rule, where it has one
    float milliseconds = 0.0f;  // per frame; where the rule would take longer, a frame is drawn as
                                // coarsely as it must be. 0 = no bound

    bool operator==(const Detail&) const = default;
};

// A rule by name; what the panel, the command line and their help say.
struct DetailRule {
    const char* name;
    const char* label;
    const char* help;
    const char* format;  // of its limit; null = it has none
    float least = 0.0f, greatest = 0.0f, fallback = 0.0f;
};
extern const std::array<DetailRule, 5> kDetailRules;  // by Detail::Rule
const DetailRule& ruleOf(const Detail& detail);

// "all", "distance", "share:0.5", "pixels:0.5", "flip:0.05", "ms:33"; a rule and a time are joined
// by a comma, a time alone goes with "all". Throws std::runtime_error that quotes what it does not
// understand.
Detail detailFromText(std::string_view text);
std::string textOf(const Detail& detail);

}  // namespace pelage
