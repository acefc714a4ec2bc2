// actions.cpp -- the table of actions.
#include "app/actions.h"

#include <GLFW/glfw3.h>

#include <cassert>
#include <numbers>

#include "app/view_actions.h"

namespace pelage {
namespace {

constexpr int kShift = GLFW_MOD_SHIFT;
constexpr int kControl = GLFW_MOD_CONTROL;

bool open(const App& app) { return app.isOpen(); }

template <Tool tool>
void chooseTool(App& app) {
    app.session.tool = tool;
}
template <Tool tool>
bool isTool(const App& app) {
    return app.session.tool == tool;
}

void scaleRadius(App& app, float factor) {
    setRadius(app.session, app.skin(), app.session.brush().radius * factor);
}
void scaleStrength(App& app, float factor) {
    setStrength(app.session, app.session.brush().strength * factor);
}

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
     open,
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
     open,
     nullptr},
    {"file.export",
     "File",
     "Export...",
     icon::kExport,
     "Write a .glb for other programs: choose what goes in, and have it read back.",
     {{{GLFW_KEY_E, kControl}}},
     [](App& app) { askForFile(app, Dialog::exportAs); },
     open,
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

    {"brush.length",
     "Brush",
     "Length",
     "",
     "Grow, shorten or set the length of the hair.",
     {{{GLFW_KEY_1}, {GLFW_KEY_L}}},
     chooseTool<Tool::length>,
     nullptr,
     isTool<Tool::length>},
    {"brush.density",
     "Brush",
     "Density",
     "",
     "Change how many hairs grow.",
     {{{GLFW_KEY_2}, {GLFW_KEY_D}}},
     chooseTool<Tool::density>,
     nullptr,
     isTool<Tool::density>},
    {"brush.comb",
     "Brush",
     "Comb",
     "",
     "Lay the hair along the stroke.",
     {{{GLFW_KEY_3}, {GLFW_KEY_C}}},
     chooseTool<Tool::comb>,
     nullptr,
     isTool<Tool::comb>},
    {"brush.smooth",
     "Brush",
     "Smooth",
     "",
     "Even out length, density and direction.",
     {{{GLFW_KEY_4}, {GLFW_KEY_S}}},
     chooseTool<Tool::smooth>,
     nullptr,
     isTool<Tool::smooth>},
    {"brush.mask",
     "Brush",
     "Mask",
     "",
     "Protect hair from the other brushes.",
     {{{GLFW_KEY_5}, {GLFW_KEY_M}}},
     chooseTool<Tool::mask>,
     nullptr,
     isTool<Tool::mask>},
    {"brush.mirror",
     "Brush",
     "Mirror X",
     icon::kMirror,
     "Paint both sides of the animal at once.",
     {{{GLFW_KEY_X}}},
     [](App& app) { setMirror(app.session, !app.session.brush().mirrorX); },
     nullptr,
     [](const App& app) { return app.session.brush().mirrorX; },
     false,
     true},
    {"brush.facing",
     "Brush",
     "Front faces only",
     icon::kFacing,
     "Leave skin alone that faces away from the brush, such as the other side of an ear.",
     {{{GLFW_KEY_B}}},
     [](App& app) { setFacingOnly(app.session, !app.session.brush().facingOnly); },
     nullptr,
     [](const App& app) { return app.session.brush().facingOnly; }},
    {"brush.dragRadius",
     "Brush",
     "Set radius by moving",
     "",
     "Move sideways; click keeps the radius, right click or Esc gives it up.",
     {{{GLFW_KEY_F}}},
     [](App& app) { beginAdjust(app, Drag::radius); },
     open,
     nullptr,
     false,
     true},
    {"brush.dragStrength",
     "Brush",
     "Set strength by moving",
     "",
     "Move sideways; click keeps the strength, right click or Esc gives it up.",
     {{{GLFW_KEY_F, kShift}}},
     [](App& app) { beginAdjust(app, Drag::strength); },
     open,
     nullptr},
    {"brush.smaller",
     "Brush",
     "Smaller",
     "",
     "Radius times 0.9.",
     {{{GLFW_KEY_LEFT_BRACKET}}},
     [](App& app) { scaleRadius(app, 0.9f); },
     open,
     nullptr,
     true},
    {"brush.larger",
     "Brush",
     "Larger",
     "",
     "Radius divided by 0.9.",
     {{{GLFW_KEY_RIGHT_BRACKET}}},
     [](App& app) { scaleRadius(app, 1.0f / 0.9f); },
     open,
     nullptr,
     true},
    {"brush.weaker",
     "Brush",
     "Weaker",
     "",
     "Strength times 0.9.",
     {{{GLFW_KEY_LEFT_BRACKET, kShift}}},
     [](App& app) { scaleStrength(app, 0.9f); },
     open,
     nullptr,
     true},
    {"brush.stronger",
     "Brush",
     "Stronger",
     "",
     "Strength divided by 0.9.",
     {{{GLFW_KEY_RIGHT_BRACKET, kShift}}},
     [](App& app) { scaleStrength(app, 1.0f / 0.9f); },
     open,
     nullptr,
     true},
    {"brush.flood",
     "Brush",
     "Flood",
     "",
     "Use the brush on the entire skin, as one step.",
     {{{GLFW_KEY_F, kControl | kShift}}},
     [](App& app) { floodSkin(app, app.session.floodDirection); },
     open,
     nullptr,
     false,
     true},

    {"view.frame",
     "View",
     "Frame all",
     icon::kFrame,
     "See the entire animal.",
     {{{GLFW_KEY_HOME}, {GLFW_KEY_PERIOD}}},
     frameAnimal,
     open,
     nullptr},
    {"view.front",
     "View",
     "Front",
     "",
     "Look at the face.",
     {{{GLFW_KEY_KP_1}}},
     [](App& app) { turnTo(app.session, 0.0f, 0.0f); },
     open,
     nullptr,
     false,
     true},
    {"view.side",
     "View",
     "Side",
     "",
     "Look at the animal's left side.",
     {{{GLFW_KEY_KP_3}}},
     [](App& app) { turnTo(app.session, 0.5f * std::numbers::pi_v<float>, 0.0f); },
     open,
     nullptr},
    {"view.top",
     "View",
     "Top",
     "",
     "Look at the back from above.",
     {{{GLFW_KEY_KP_7}}},
     [](App& app) { turnTo(app.session, 0.0f, 0.5f * std::numbers::pi_v<float>); },
     open,
     nullptr},
    {"view.orthographic",
     "View",
     "Orthographic",
     "",
     "No perspective: parallel lines stay so.",
     {{{GLFW_KEY_KP_5}, {GLFW_KEY_O}}},
     [](App& app) { app.session.camera.orthographic = !app.session.camera.orthographic; },
     open,
     [](const App& app) { return app.session.camera.orthographic; }},
    {"view.overlay",
     "View",
     "Next overlay",
     "",
     "None, length, density, direction, mask.",
     {{{GLFW_KEY_V}}},
     nextOverlay,
     open,
     nullptr,
     false,
     true},
    {"view.skin",
     "View",
     "Skin",
     "",
     "Show the skin.",
     {{{GLFW_KEY_1, GLFW_MOD_ALT}}},
     [](App& app) { app.session.view.showSkin = !app.session.view.showSkin; },
     nullptr,
     [](const App& app) { return app.session.view.showSkin; }},
    {"view.over",
     "View",
     "Overcoat",
     "",
     "Show the guard hairs.",
     {{{GLFW_KEY_2, GLFW_MOD_ALT}}},
     [](App& app) { app.session.view.showOver = !app.session.view.showOver; },
     nullptr,
     [](const App& app) { return app.session.view.showOver; }},
    {"view.under",
     "View",
     "Undercoat",
     "",
     "Show the undercoat.",
     {{{GLFW_KEY_3, GLFW_MOD_ALT}}},
     [](App& app) { app.session.view.showUnder = !app.session.view.showUnder; },
     nullptr,
     [](const App& app) { return app.session.view.showUnder; }},
    {"view.panels",
     "View",
     "Panels",
     "",
     "Show or hide everything but the animal.",
     {{{GLFW_KEY_TAB}}},
     [](App& app) { app.panelsHidden = !app.panelsHidden; },
     nullptr,
     [](const App& app) { return !app.panelsHidden; },
     false,
     true},
    {"view.larger",
     "View",
     "Larger text",
     "",
     "Text and widgets a quarter larger.",
     {{{GLFW_KEY_EQUAL, kControl}}},
     [](App& app) { scaleText(app, 1.25f); },
     nullptr,
     nullptr,
     false,
     true},
    {"view.smaller",
     "View",
     "Smaller text",
     "",
     "Text and widgets a fifth smaller.",
     {{{GLFW_KEY_MINUS, kControl}}},
     [](App& app) { scaleText(app, 0.8f); },
     nullptr,
     nullptr},
    {"view.ownScale",
     "View",
     "Text size of the display",
     "",
     "As the display asks for.",
     {{{GLFW_KEY_0, kControl}}},
     [](App& app) { scaleText(app, 0.0f); },
     nullptr,
     nullptr},

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
     open,
     nullptr},
};

bool same(Shortcut a, Shortcut b) { return a.key == b.key && a.mods == b.mods; }

std::string keyText(int key) {
    if ((key >= 'A' && key <= 'Z') || (key >= '0' && key <= '9') || (key >= '\'' && key <= ']'))
        return std::string(1, static_cast<char>(key));
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return "Num " + std::to_string(key - GLFW_KEY_KP_0);
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    if (key == GLFW_KEY_HOME) return "Home";
    if (key == GLFW_KEY_TAB) return "Tab";
    return "?";
}

}  // namespace

std::span<const Action> actions() { return kActions; }

const Action& actionNamed(std::string_view name) {
    for (const Action& action : kActions)
        if (action.name == name) return action;
    assert(false);
    return kActions[0];
}

bool isEnabled(const App& app, const Action& action) {
    return !app.work.running() && app.dialogs.current == Dialog::none &&
           app.dialogs.problem.empty() && !app.workspace.stroke &&
           (!action.enabled || action.enabled(app));
}

void perform(App& app, const Action& action) {
    if (!isEnabled(app, action)) return;
    try {
        action.run(app);
    } catch (const std::exception& error) {
        complain(app, error.what());
    }
}

std::string shortcutText(Shortcut shortcut) {
    if (shortcut.key == 0) return "";
    if (shortcut.key == GLFW_KEY_SLASH && shortcut.mods == kShift) return "?";
    std::string text;
    if (shortcut.mods & kControl) text += "Ctrl+";
    if (shortcut.mods & GLFW_MOD_ALT) text += "Alt+";
    if (shortcut.mods & kShift) text += "Shift+";
    return text + keyText(shortcut.key);
}

const Action* actionOfKey(Shortcut pressed) {
    if (pressed.key == GLFW_KEY_KP_DECIMAL) pressed.key = GLFW_KEY_PERIOD;
    for (const Action& action : kActions)
        for (const Shortcut& key : action.keys)
            if (key.key != 0 && same(key, pressed)) return &action;
    return nullptr;
}

std::string firstClash() {
    for (const Action& a : kActions)
        for (const Action& b : kActions) {
            if (&a >= &b) continue;
            if (a.name == std::string_view(b.name)) return std::string(a.name) + " is there twice";
            for (const Shortcut& of : a.keys)
                for (const Shortcut& other : b.keys)
                    if (of.key != 0 && same(of, other))
                        return shortcutText(of) + " is " + a.name + " and " + b.name;
        }
    return "";
}

}  // namespace pelage
