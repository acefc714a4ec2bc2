// presets.cpp -- the coats that come with the program, and putting one on.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "coat.h"
#include "embedded.h"

namespace pelage {
namespace {

Preset readPreset(const EmbeddedFile& file) {
    try {
        const auto json = nlohmann::json::parse(file.text);
        return {json.at("name"), json.at("about"), furFromJson(json.at("fur").dump())};
    } catch (const std::exception& error) {
        throw std::runtime_error(std::string(file.name) + ": " + error.what());
    }
}

std::vector<Preset> readPresets() {
    std::vector<Preset> all;
    for (const EmbeddedFile& file : embeddedPresets()) all.push_back(readPreset(file));
    std::ranges::sort(all, {}, &Preset::name);
    return all;
}

}  // namespace

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all = readPresets();
    return all;
}

const Preset& presetNamed(std::string_view name) {
    const auto found = std::ranges::find(presets(), name, &Preset::name);
    if (found != presets().end()) return *found;
    std::string list;
    for (const Preset& preset : presets()) list += (list.empty() ? "" : ", ") + preset.name;
    throw std::runtime_error("there is no preset \"" + std::string(name) + "\"; there are " + list);
}

void applyPreset(Fur& fur, const Preset& preset) {
    const uint seed = fur.seed;
    fur = preset.fur;
    fur.seed = seed;
}

}  // namespace pelage
