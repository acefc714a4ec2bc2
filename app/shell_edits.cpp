// shell_edits.cpp -- the verbs that choose what shells are cut from.
#include <stdexcept>

#include "app/app.h"

namespace pelage {

void chooseShells(App& app, const ShellRecipe& recipe) {
    ShellChoices& shells = app.shells;
    try {
        ShellChoice& first = shells.coats[shells.shown == 2 ? 1 : 0];
        choose(first, recipe);
        if (shells.shown == 0) shells.coats[1] = first;
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    app.touched = true;
}

void openShellPicture(App& app, const std::string& path, ShellRecipe::From from) {
    if (!app.isOpen() || app.work.running()) return;
    ShellRecipe recipe = app.shells.coats[app.shells.shown == 2 ? 1 : 0].recipe;
    recipe.from = from;
    recipe.file = path;
    chooseShells(app, recipe);
}

void askForShellPicture(App& app, ShellRecipe::From from) {
    app.shells.asked = from;
    askForFile(app, Dialog::shellPicture);
}

}  // namespace pelage
