// actions_edit.cpp -- undo and redo.
#include <GLFW/glfw3.h>

#include "app/actions.h"

namespace pelage {
namespace {

constexpr int kShift = GLFW_MOD_SHIFT;
constexpr int kControl = GLFW_MOD_CONTROL;

constexpr Action kActions[] = {
    {"edit.undo",
     "Edit",
     "Undo",
     icon::kUndo,
     "Take back the last step.",
     {{{GLFW_KEY_Z, kControl}}},
     undo,
     [](const App& app) {
         return app.isOpen() && (!app.editor().undoLabel().empty() || app.pending);
     },
     nullptr,
     true},
    {"edit.redo",
     "Edit",
     "Redo",
     icon::kRedo,
     "Make the step again that was taken back.",
     {{{GLFW_KEY_Z, kControl | kShift}, {GLFW_KEY_Y, kControl}}},
     redo,
     [](const App& app) { return app.isOpen() && !app.editor().redoLabel().empty(); },
     nullptr,
     true},
};

}  // namespace

std::span<const Action> editActions() { return kActions; }

}  // namespace pelage
