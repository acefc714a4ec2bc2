// cli.h -- the verbs of the command line: each adds itself to the parser and runs when it is named.
//
// Exit status: 0, 1 (bad input or failed work: any exception), 2 (bad usage: UsageError or what the
// parser refuses). Results go to stdout, as text or as one JSON object; errors are one line on
// stderr.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>

namespace pelage {

// The command line itself is wrong: exit status 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// `json` is set by --json before or after the verb; it must outlive the parsing.
void addInfo(CLI::App& app, bool& json);
void addRender(CLI::App& app, bool& json);
void addExport(CLI::App& app, bool& json);
void addCompare(CLI::App& app, bool& json);
void addMeasure(CLI::App& app, bool& json);
void addAnimal(CLI::App& app, bool& json);
void addPreset(CLI::App& app, bool& json);
void addPresets(CLI::App& app, bool& json);
void addShapeError(CLI::App& app, bool& json);
void addShells(CLI::App& app, bool& json);
void addJsonFlag(CLI::App& verb, bool& json);

// For `pelage [FILE]` where there is no display: pictures of the animal and a groomed .glb in
// pelage-out/. An empty file means the built-in animal. Prints what was written.
void runShowcase(const std::string& file, bool json);

// Runs the command line; the exit status of the program.
int runCommandLine(int argc, char** argv);

}  // namespace pelage
