// presets.cpp -- the coats that come with the program, and putting one on.
#include <algorithm>
#include <stdexcept>

#include "coat.h"
#include "embedded.h"
#include "preset_file.h"

namespace pelage {
namespace {

std::vector<Preset> readPresets() {
    std::vector<Preset> all;
    for (const EmbeddedFile& file : embeddedPresets()) {
        all.push_back(presetFromText(file.text, std::string(file.name)));
        all.back().file.clear();
    }
    std::ranges::sort(all, {}, &Preset::name);
    return all;
}

}  // namespace

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all = readPresets();
    return all;
}

const Preset& presetNamed(std::string_view name, std::span<const Preset> own) {
    std::string list;
    for (const std::span<const Preset> some : {std::span<const Preset>(presets()), own}) {
        for (const Preset& preset : some) {
            if (preset.name == name) return preset;
            list += (list.empty() ? "" : ", ") + preset.name;
        }
    }
    throw std::runtime_error("there is no preset \"" + std::string(name) + "\"; there are " + list);
}

void applyPreset(Fur& fur, const Preset& preset) {
    const uint seed = fur.seed;
    fur = preset.fur;
    if (!preset.seeded) fur.seed = seed;
}

}  // namespace pelage
