// input.cpp -- from options to a document.
#include "app/cli/input.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/cli/cli.h"
#include "core/animal.h"
#include "core/field.h"
#include "core/files.h"
#include "core/preset_file.h"
#include "core/script.h"
#include "core/source.h"
#include "core/subdivide.h"
#include "core/transfer.h"

namespace pelage {
namespace {

void applySet(Fur& fur, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        throw UsageError("--set " + text + ": expected NAME=VALUE, as in over.stiffness=0.3");
    }
    try {
        setParameter(fur, text.substr(0, equals), text.substr(equals + 1));
    } catch (const std::runtime_error& error) {
        throw UsageError("--set " + text + ": " + error.what());
    }
}

void applyNamedPreset(Fur& fur, const std::string& name) {
    try {
        applyPreset(fur, findPreset(name));
    } catch (const std::runtime_error& error) {
        throw UsageError(std::string("--preset: ") + error.what());
    }
}

Document afterScript(Document document, const std::string& path) {
    Workspace workspace;
    workspace.open(std::move(document));
    runScript(workspace, path);
    return workspace.editor->document();
}

Document afterTransfer(const Document& onto, const std::string& path) {
    Transferred transfer = transferred(openDocument(readSource(path)), onto);
    if (const std::string note = farNote(transfer); !note.empty())
        std::fprintf(stderr, "pelage: %s: %s\n", path.c_str(), note.c_str());
    return std::move(transfer.document);
}

}  // namespace

void addInputOptions(CLI::App& verb, InputOptions& options) {
    verb.add_option("FILE", options.file, "A .glb, .gltf, .obj, .ply, .off or .stl file");
    verb.add_option("--animal", options.animal, "The built-in animal of N triangles, not a file")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{2000}, std::size_t{2000000}));
    verb.add_option("--field", options.field, "The built-in field of N triangles, not a file")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{2000}, std::size_t{2000000}));
    verb.add_option("--preset", options.preset,
                    "Put on a coat: one of pelage presets, or a .fur.json file")
        ->type_name("NAME|FILE");
    verb.add_option("--script", options.script, "Run the lines of a script on the document")
        ->type_name("S");
    verb.add_option("--set", options.sets, "Set a coat parameter: over.stiffness=0.3 (repeatable)")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    verb.add_option("--hairs", options.hairs, "Hairs on the entire skin at density 1")
        ->type_name("N")
        ->check(CLI::Range(uint{0}, uint{5000000}));
}

void addMeshOptions(CLI::App& verb, InputOptions& options) {
    verb.add_option("--subdivide", options.subdivide, "Cut each triangle in four, N times")
        ->type_name("N")
        ->check(CLI::Range(1, kMostLevels));
    verb.add_option("--transfer", options.transfer, "Take the groom of another file over")
        ->type_name("OLD");
}

Document openInput(const InputOptions& options) {
    if (int{!options.file.empty()} + int{options.animal.has_value()} +
            int{options.field.has_value()} !=
        1)
        throw UsageError("expected a FILE, --animal N or --field N, one of the three");
    // What is wrong with the command line is found before any long work.
    Fur trial = defaultFur();
    if (!options.preset.empty()) applyNamedPreset(trial, options.preset);
    for (const std::string& set : options.sets) applySet(trial, set);

    Document document = options.animal  ? groomedAnimal(*options.animal)
                        : options.field ? groomedField(*options.field)
                                        : openDocument(readSource(options.file));
    if (options.subdivide > 0) document = subdivided(document, options.subdivide);
    if (!options.transfer.empty()) document = afterTransfer(document, options.transfer);
    if (!options.preset.empty()) applyNamedPreset(document.fur, options.preset);
    if (!options.script.empty()) document = afterScript(std::move(document), options.script);
    for (const std::string& set : options.sets) applySet(document.fur, set);
    if (options.hairs) document.fur.hairs = *options.hairs;
    return document;
}

CLI::Validator endsIn(const std::string& extension) {
    return {[=](const std::string& name) -> std::string {
                try {
                    expectExtension(name, extension);
                } catch (const std::runtime_error& error) {
                    return error.what();
                }
                return {};
            },
            ""};
}

std::string sourceName(const InputOptions& options) {
    return options.animal ? "animal" : options.field ? "field" : options.file;
}

std::string stemOf(const std::string& file) {
    return file.empty() ? "animal" : std::filesystem::path(file).stem().string();
}

}  // namespace pelage
