// pose_text.cpp -- poses as lines of script.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "pose.h"
#include "rig.h"
#include "text.h"

namespace pelage {
namespace {

const Rig& rigOf(const Skin& skin) {
    if (!skin.source->rig) throw std::runtime_error("nothing of this animal can move");
    return *skin.source->rig;
}

float numberFrom(std::string_view word, const char* what) {
    const std::optional<float> number = floatFromText(word);
    if (!number) throw std::runtime_error(inQuotes(word) + " is no " + what);
    return *number;
}

// The weights after "morph", one for each target.
std::vector<float> weightsFrom(const Rig& rig, std::string_view text) {
    Words words(text);
    std::vector<float> weights;
    while (!words.done()) weights.push_back(numberFrom(words.next(), "weight"));
    if (weights.size() != rig.targets.size())
        throw std::runtime_error("has " + std::to_string(weights.size()) + " weights for " +
                                 std::to_string(rig.targets.size()) + " morph targets");
    return weights;
}

std::string_view trimmed(std::string_view text) { return Words(text).rest(); }

}  // namespace

int clipNamed(const Skin& skin, std::string_view name) {
    const std::vector<Clip>& clips = rigOf(skin).clips;
    const auto found = std::ranges::find(clips, name, &Clip::name);
    if (found != clips.end()) return static_cast<int>(found - clips.begin());
    const auto number = wholeFromText(name);
    if (number && *number >= 1 && *number <= clips.size()) return static_cast<int>(*number) - 1;
    std::string known;
    for (const Clip& clip : clips) known += (known.empty() ? "" : ", ") + inQuotes(clip.name);
    throw std::runtime_error("no clip " + inQuotes(name) + "; " +
                             (known.empty() ? "there are none" : "there are " + known));
}

std::string poseLine(const Pose& pose) {
    std::string line = "pose rest";
    if (pose.clip >= 0)
        line = "pose " + std::to_string(pose.clip + 1) + ' ' + floatText(pose.seconds);
    if (!pose.weights.empty()) line += " morph";
    for (const float weight : pose.weights) line += ' ' + floatText(weight);
    return line;
}

Pose poseFromWords(const Skin& skin, Words& words) {
    std::string_view text = words.rest();
    Pose pose;
    if (const std::size_t morph = (std::string(" ") += text).rfind(" morph ");
        morph != std::string::npos) {
        pose.weights = weightsFrom(rigOf(skin), text.substr(morph + 6));
        text = trimmed(text.substr(0, morph));
    }
    if (text == "rest") return pose;
    const std::size_t space = text.find_last_of(" \t");
    if (space == std::string_view::npos)
        throw std::runtime_error("expected \"rest\", or a clip and its seconds");
    pose.clip = clipNamed(skin, trimmed(text.substr(0, space)));
    pose.seconds = numberFrom(text.substr(space + 1), "number of seconds");
    return pose;
}

}  // namespace pelage
