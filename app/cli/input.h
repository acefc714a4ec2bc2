// input.h -- the options that say which document a verb works on, and how to make that document.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/document.h"

namespace pelage {

struct InputOptions {
    std::string file;
    std::optional<std::size_t> animal;  // triangles of the built-in animal, instead of a file
    std::optional<std::size_t> field;   // likewise of the built-in field
    std::string preset, script;         // empty = none
    std::vector<std::string> sets;      // "over.stiffness=0.3"
    std::optional<uint> hairs;
    int subdivide = 0;     // times, before all of these
    std::string transfer;  // a file whose groom is taken over, after that; empty = none
};

// FILE, --animal, --field, --preset, --script, --set and --hairs.
void addInputOptions(CLI::App& verb, InputOptions& options);

// --subdivide and --transfer.
void addMeshOptions(CLI::App& verb, InputOptions& options);

// Opens the file or makes the animal or the field, then subdivides, transfers, and applies preset,
// script, sets and hairs in that order. Throws UsageError for a wrong preset or --set,
// std::runtime_error for bad input.
Document openInput(const InputOptions& options);

// Accepts the names that expectExtension (core/files.h) does, before any work.
CLI::Validator endsIn(const std::string& extension);

// The file as it was named; "animal" and "field" for what is built in.
std::string sourceName(const InputOptions& options);

// The file's name without folder and extension; "animal" for the built-in one.
std::string stemOf(const std::string& file);

}  // namespace pelage
