// window.h -- the editor in a window.
#pragma once

#include <string>

namespace pelage {

struct EditorOptions {
    std::string file;                // to open; empty = the built-in animal
    int width = 1280, height = 720;  // of the window, in its own units
};

// Opens the window and runs until it is closed. Returns the exit status: 0, or 1 when nothing was
// open at the end because `file` could not be read. Throws std::runtime_error when there is no
// display or no OpenGL 4.5.
int runEditor(const EditorOptions& options);

}  // namespace pelage
