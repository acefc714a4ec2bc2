// export.cpp -- pelage export and pelage animal: groomed .glb files.
#include <filesystem>
#include <memory>

#include "app/cli/cli.h"
#include "app/cli/input.h"
#include "app/cli/print.h"
#include "core/animal.h"
#include "core/gltf_out.h"

namespace pelage {
namespace {

struct Options {
    InputOptions input;
    std::string output;
    ExportOptions glb;
    std::size_t triangles = kAnimalTriangles;
};

void addOutput(CLI::App& verb, Options& options) {
    verb.add_option("-o,--output", options.output, "The .glb file to write")
        ->type_name("OUT.glb")
        ->check(endsIn(".glb"))
        ->required();
    verb.add_flag("--compatibility-uvs", options.glb.compatibilityUvs,
                  "Mirror the fur fields into TEXCOORD_2 to TEXCOORD_4");
}

void write(const Document& document, const Options& options, bool json) {
    writeGroomedGlb(document, options.output, options.glb);
    const LoadReport& report = document.skin->report;
    const std::size_t bytes = std::filesystem::file_size(options.output);
    if (json) {
        printJson({{"output", options.output},
                   {"bytes", bytes},
                   {"vertices", report.vertices},
                   {"triangles", report.triangles},
                   {"hairs", document.fur.hairs}});
    } else {
        print("wrote " + options.output + ": " + std::to_string(report.triangles) + " triangles, " +
              bytesText(bytes) + "\n");
    }
}

}  // namespace

void addExport(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("export", "Write a groomed .glb");
    const auto options = std::make_shared<Options>();
    addInputOptions(*verb, options->input);
    addMeshOptions(*verb, options->input);
    addOutput(*verb, *options);
    addJsonFlag(*verb, json);
    verb->callback([options, &json] { write(openInput(options->input), *options, json); });
}

void addAnimal(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("animal", "Write the built-in animal, groomed, as .glb");
    const auto options = std::make_shared<Options>();
    verb->add_option("--triangles", options->triangles, "How many, within a tenth")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(std::size_t{2000}, std::size_t{2000000}));
    addOutput(*verb, *options);
    addJsonFlag(*verb, json);
    verb->callback([options, &json] { write(groomedAnimal(options->triangles), *options, json); });
}

}  // namespace pelage
