// file_dialog.h -- a file browser of our own, the same on every system.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/widgets.h"

namespace pelage {

struct FileDialog {
    struct Entry {
        std::string name;
        bool folder = false;
        std::uintmax_t bytes = 0;
    };
    bool saving = false;
    std::string title, accept;            // of the window, of its button
    std::vector<std::string> extensions;  // ".glb", lower case; the first is added when saving
    std::string folder;
    std::string name;            // typed or chosen; may be a path of its own
    std::vector<Entry> entries;  // folders first
    std::string problem;         // why the folder or the name is of no use
    bool replaceAsked = false;   // the name exists and the button was pressed once
    bool fresh = true;           // just opened: the name field takes the keyboard
};

// Points the dialog at a folder, with a name proposed.
void browse(FileDialog& dialog, const std::string& folder, const std::string& name);

enum class FileChoice { open, accepted, cancelled };
// Draws the dialog; when accepted `dialog.name` is the whole path. `enter` is true when that key
// was pressed; `extras` draws what else the purpose needs above the buttons.
FileChoice drawFileDialog(Ui ui, FileDialog& dialog, std::span<const std::string> recent,
                          bool enter, const std::function<void()>& extras = {});

}  // namespace pelage
