// actions_file.cpp -- actions on files, and help.
#include <GLFW/glfw3.h>

#include "app/actions.h"

namespace pelage {
namespace {

constexpr int kShift = GLFW_MOD_SHIFT;
constexpr int kControl = GLFW_MOD_CONTROL;

constexpr Action kActions[] = {
    {"file.open",
     "File",
     "Open...",
     icon::kOpen,
     "Open a mesh or a groomed .glb.",
     {{{GLFW_KEY_O, kControl}}},
     [](App& app) { askForFile(app, Dialog::open); },
     nullptr,
     nullptr},
    {"file.animal",
     "File",
     "Open the built-in animal",
     "",
     "A groomed animal made by the program.",
     {},
     openAnimal,
     nullptr,
     nullptr},
    {"file.save",
     "File",
     "Save",
     icon::kSave,
     "Save the groomed .glb.",
     {{{GLFW_KEY_S, kControl}}},
     [](App& app) { save(app); },
     hasAnimal,
     nullptr,
     false,
     true},
    {"file.saveAs",
     "File",
     "Save as...",
     "",
     "Save the groomed .glb under another name.",
     {{{GLFW_KEY_S, kControl | kShift}}},
     [](App& app) { askForFile(app, Dialog::saveAs); },
     hasAnimal,
     nullptr},
    {"file.export",
     "File",
     "Export...",
     icon::kExport,
     "Write a .glb for other programs: choose what goes in, and have it read back.",
     {{{GLFW_KEY_E, kControl}}},
     [](App& app) { askForFile(app, Dialog::exportAs); },
     hasAnimal,
     nullptr},
    {"file.quit",
     "File",
     "Quit",
     "",
     "Close the editor.",
     {{{GLFW_KEY_Q, kControl}}},
     requestQuit,
     nullptr,
     nullptr,
     false,
     true},

    {"help.keys",
     "Help",
     "Keys and mouse",
     icon::kHelp,
     "Everything the keys and the mouse do.",
     {{{GLFW_KEY_F1}, {GLFW_KEY_SLASH, kShift}}},
     [](App& app) { app.dialogs.help = !app.dialogs.help; },
     nullptr,
     nullptr},
    {"help.report",
     "Help",
     "Load report",
     "",
     "What was found in the file that was opened.",
     {},
     [](App& app) { app.dialogs.report = true; },
     hasAnimal,
     nullptr},
};

}  // namespace

std::span<const Action> fileActions() { return kActions; }

}  // namespace pelage
