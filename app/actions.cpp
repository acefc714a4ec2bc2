// actions.cpp -- looking actions up, running them, and naming their keys.
#include "app/actions.h"

#include <GLFW/glfw3.h>

#include <cassert>
#include <vector>

namespace pelage {
namespace {

constexpr int kShift = GLFW_MOD_SHIFT;
constexpr int kControl = GLFW_MOD_CONTROL;

bool same(Shortcut a, Shortcut b) { return a.key == b.key && a.mods == b.mods; }

std::string keyText(int key) {
    if ((key >= 'A' && key <= 'Z') || (key >= '0' && key <= '9') || (key >= '\'' && key <= ']'))
        return std::string(1, static_cast<char>(key));
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return "Num " + std::to_string(key - GLFW_KEY_KP_0);
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    if (key == GLFW_KEY_HOME) return "Home";
    if (key == GLFW_KEY_SPACE) return "Space";
    if (key == GLFW_KEY_TAB) return "Tab";
    return "?";
}

}  // namespace

std::span<const Action> actions() {
    static const std::vector<Action> all = [] {
        std::vector<Action> rows;
        for (const auto part :
             {fileActions(), editActions(), brushActions(), maskActions(), meshActions(),
              viewActions()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return all;
}

const Action& actionNamed(std::string_view name) {
    for (const Action& action : actions())
        if (action.name == name) return action;
    assert(false);
    return actions().front();
}

bool isEnabled(const App& app, const Action& action) {
    return !app.work.running() && app.dialogs.current == Dialog::none &&
           app.dialogs.problem.empty() && (!action.enabled || action.enabled(app));
}

void perform(App& app, const Action& action) {
    if (!isEnabled(app, action) || app.workspace.stroke) return;
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
    for (const Action& action : actions())
        for (const Shortcut& key : action.keys)
            if (key.key != 0 && same(key, pressed)) return &action;
    return nullptr;
}

std::string firstClash() {
    for (const Action& a : actions())
        for (const Action& b : actions()) {
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
