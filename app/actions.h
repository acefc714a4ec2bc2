// actions.h -- every verb a person can call, once: menus, toolbar, keys and help are made from it.
#pragma once

#include <array>
#include <span>
#include <string>

#include "app/app.h"

namespace pelage {

struct Shortcut {
    int key = 0;   // GLFW_KEY_..., 0 = none
    int mods = 0;  // GLFW_MOD_SHIFT, _CONTROL, _ALT
};

struct Action {
    const char* name;   // "edit.undo"
    const char* menu;   // the menu it is in, "" = in none
    const char* label;  // "Undo"
    const char* glyph;  // icon, "" = none
    const char* help;   // one sentence
    std::array<Shortcut, 2> keys;
    void (*run)(App&);
    bool (*enabled)(const App&);  // null = always
    bool (*checked)(const App&);  // null = no toggle
    bool repeats = false;         // while the key is held
    bool line = false;            // the menu draws a line above it
};

// Enables what needs something open.
inline bool hasAnimal(const App& app) { return app.isOpen(); }

std::span<const Action> actions();
// Its parts, each in a file of its own; in a menu they stand in this order.
std::span<const Action> fileActions();
std::span<const Action> editActions();
std::span<const Action> brushActions();
std::span<const Action> maskActions();
std::span<const Action> meshActions();
std::span<const Action> viewActions();

const Action& actionNamed(std::string_view name);  // asserted to be there

bool isEnabled(const App& app, const Action& action);
// Runs it if it is enabled. Errors are shown; nothing is thrown.
void perform(App& app, const Action& action);

// "Ctrl+Shift+Z", empty without a key.
std::string shortcutText(Shortcut shortcut);

// The action of a key, null when there is none.
const Action* actionOfKey(Shortcut pressed);

// Two actions on one key or of one name, as a sentence; empty when the table is sound.
std::string firstClash();

}  // namespace pelage
