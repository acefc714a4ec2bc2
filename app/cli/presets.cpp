// presets.cpp -- pelage presets: the coats that come with the program.
#include <algorithm>

#include "app/cli/cli.h"
#include "app/cli/print.h"
#include "core/coat.h"

namespace pelage {
namespace {

void listPresets(bool json) {
    if (json) {
        OrderedJson list = OrderedJson::array();
        for (const Preset& preset : presets()) {
            list.push_back({{"name", preset.name},
                            {"about", preset.about},
                            {"fur", OrderedJson::parse(furToJson(preset.fur))}});
        }
        printJson({{"presets", list}});
        return;
    }
    std::size_t widest = 0;
    for (const Preset& preset : presets()) widest = std::max(widest, preset.name.size());
    std::string text;
    for (const Preset& preset : presets()) {
        text.append(preset.name).append(widest + 2 - preset.name.size(), ' ');
        text.append(preset.about).append("\n");
    }
    print(text);
}

}  // namespace

void addPresets(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("presets", "List the coats that come with the program");
    addJsonFlag(*verb, json);
    verb->callback([&json] { listPresets(json); });
}

}  // namespace pelage
