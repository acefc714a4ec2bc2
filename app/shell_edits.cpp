// shell_edits.cpp -- the verbs that choose what shells are cut from.
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "app/app.h"
#include "core/pixels.h"

namespace pelage {
namespace {

const char* nameOf(ShellRecipe::From from) {
    constexpr const char* kNames[] = {"hairs", "photograph", "picture", "noise"};
    return kNames[static_cast<int>(from)];
}

// Of the coats that the panel showed when it was chosen.
void adopt(App& app, ShellChoice choice, int shown) {
    ShellChoices& shells = app.shells;
    ShellChoice& first = shells.coats[shown == 2 ? 1 : 0];
    shells.before = first.preview;
    first = std::move(choice);
    if (shown == 0) shells.coats[1] = first;
    app.touched = true;
    std::string line = std::string("shells of ") + nameOf(first.recipe.from);
    if (first.picture.texture) line += " " + sizeText(first.picture.texture->size);
    if (!first.layers.regions.empty())
        line += ", " + std::to_string(first.layers.layers) + " layers, colors " +
                std::to_string(first.layers.regions.size());
    trace(app, line);
}

void readInWork(App& app, const ShellRecipe& recipe) {
    const std::string name = std::filesystem::path(recipe.file).filename().string();
    startWork(
        app, "Reading " + name,
        [&app, recipe, name, shown = app.shells.shown](Progress& progress) -> Finish {
            const auto made = std::make_shared<ShellChoice>();
            choose(*made, recipe, &progress);
            return [&app, made, name, shown] {
                const std::string halved = halvedText(*made->picture.texture);
                if (!halved.empty()) tell(app, name + ": " + halved);
                adopt(app, std::move(*made), shown);
            };
        },
        "Cancelled; shells are as they were");
}

}  // namespace

void chooseShells(App& app, const ShellRecipe& recipe) {
    ShellChoice choice = app.shells.coats[app.shells.shown == 2 ? 1 : 0];
    if (readsFile(choice, recipe)) return readInWork(app, recipe);
    try {
        choose(choice, recipe);
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    adopt(app, std::move(choice), app.shells.shown);
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
