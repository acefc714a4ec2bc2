// shell_options.h -- pelage render: the picture that shells are cut from in place of hairs.
#pragma once

#include "app/cli/cli.h"
#include "app/render/renderer.h"

namespace pelage {

// Percent of the pixels below the darkest and the brightest tone of a photograph that counts.
CLI::Option* addClampOption(CLI::App& verb, const char* name, std::vector<double>& clamp);
// Throws UsageError "render --shell-clamp: 60 is not below 40".
void expectRising(const char* option, const std::vector<double>& clamp);

struct ShellOptions {
    ShellRecipe recipe;
    bool noise = false;
    std::string coats = "both";
    std::vector<double> clamp = {1.0, 99.0};  // percent of the pixels
};

void addShellOptions(CLI::App& verb, ShellOptions& options);

// Reads the picture. Throws UsageError where the view has no shells.
void useShellOptions(View& view, const ShellOptions& options, float skinSize);

// "texture 256 KiB, with its mips 341 KiB; 16 stored layers would take 4096 KiB", of a picture of
// such a size.
std::string memoryText(ivec2 size, int layers);

// Of the picture, for JSON and as lines of text; 0 and empty without one.
std::size_t storedLayersBytes(const View& view);
std::string pictureText(const View& view);

}  // namespace pelage
