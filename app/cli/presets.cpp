// presets.cpp -- pelage presets and pelage preset: the coats there are, and one more as a file.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/cli/cli.h"
#include "app/cli/input.h"
#include "app/cli/print.h"
#include "app/render/headless.h"
#include "app/render/thumbnail.h"
#include "core/preset_file.h"

namespace pelage {
namespace {

std::string sourceOf(const Preset& preset) { return preset.file.empty() ? "program" : preset.file; }

void listPresets(bool json) {
    const OwnPresets own = ownPresets();
    std::vector<Preset> all = presets();
    all.insert(all.end(), own.presets.begin(), own.presets.end());
    if (json) {
        OrderedJson list = OrderedJson::array();
        for (const Preset& preset : all) {
            list.push_back({{"name", preset.name},
                            {"author", preset.author},
                            {"note", preset.note},
                            {"source", sourceOf(preset)},
                            {"fur", OrderedJson::parse(furToJson(preset.fur))}});
        }
        printJson({{"presets", list}, {"folder", presetFolder()}, {"warnings", own.warnings}});
        return;
    }
    std::size_t widest = 0;
    for (const Preset& preset : all) widest = std::max(widest, preset.name.size());
    std::string text;
    for (const Preset& preset : all) {
        text.append(preset.name).append(widest + 2 - preset.name.size(), ' ').append(preset.note);
        if (!preset.author.empty()) text.append(" By ").append(preset.author).append(".");
        if (!preset.file.empty()) text.append(" (").append(preset.file).append(")");
        text.append("\n");
    }
    print(text);
    for (const std::string& warning : own.warnings)
        std::fprintf(stderr, "pelage: %s\n", warning.c_str());
}

struct Options {
    InputOptions input;
    std::string output, name, author, note;
};

void writeOne(const Options& options, bool json) {
    Preset preset;
    preset.name = options.name;
    preset.author = options.author;
    preset.note = options.note;
    preset.fur = openInput(options.input).fur;
    preset.seeded = true;
    const HeadlessContext context;
    Thumbnailer thumbnailer;
    while (preset.thumbnail.empty())
        if (auto picture = thumbnailer.draw(preset.fur)) preset.thumbnail = std::move(*picture);
    writePreset(preset, options.output);
    const Preset written = readPreset(options.output);
    const std::size_t bytes = presetText(written).size();
    if (json) {
        printJson({{"output", options.output}, {"name", written.name}, {"bytes", bytes}});
    } else {
        print("wrote " + options.output + ": " + written.name + ", " + bytesText(bytes) + "\n");
    }
}

}  // namespace

void addPresets(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("presets", "List the coats of the program and your own");
    addJsonFlag(*verb, json);
    verb->callback([&json] { listPresets(json); });
}

void addPreset(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("preset", "Write the coats of a file as a preset to share");
    const auto options = std::make_shared<Options>();
    addInputOptions(*verb, options->input);
    verb->add_option("-o,--output", options->output, "The .fur.json file to write")
        ->type_name("OUT.fur.json")
        ->check(endsIn(kPresetExtension))
        ->required();
    verb->add_option("--name", options->name, "What it is called; without it that of the file");
    verb->add_option("--author", options->author, "Who made it");
    verb->add_option("--note", options->note, "One sentence about it");
    addJsonFlag(*verb, json);
    verb->callback([options, &json] { writeOne(*options, json); });
}

}  // namespace pelage
