// shell_choice.h -- the pictures that the window's shells are cut from, with what a panel shows of
// them: state of one person's view, like the camera.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/shell_source.h"

namespace pelage {

struct ShellPreview;

// Of one coat.
struct ShellChoice {
    ShellRecipe recipe;
    ShellPicture picture;  // of the recipe; empty for hairs
    PhotoLayers layers;    // of a photograph
    std::shared_ptr<ShellPreview> preview;
};

// Makes what the recipe asks for, anew only where it differs. Throws as shellPicture does; the
// choice is then what it was.
void choose(ShellChoice& choice, const ShellRecipe& recipe, Progress* progress = nullptr);
// Whether that reads a file, which may take long.
bool readsFile(const ShellChoice& choice, const ShellRecipe& recipe);

inline constexpr int kPreviewSide = 64;  // pixels of a layer's picture

// Textures of the photograph and of its layers, rows of `columns` pictures from the outermost, each
// with what is in those outside it; made when first asked for after a choice.
struct ShellTextures {
    unsigned photo = 0, layers = 0;
    int columns = 1, rows = 1;
};
ShellTextures texturesOf(ShellChoice& choice);

// Has to go before the OpenGL context does.
struct ShellChoices {
    std::array<ShellChoice, 2> coats;        // over, under
    int shown = 0;                           // in the panel: both coats, over, under
    std::shared_ptr<ShellPreview> before{};  // of what was replaced: this frame may still show it
    ShellRecipe::From asked{};               // while a file is being looked for
};

}  // namespace pelage
