// preset_edits.cpp -- the verbs that put presets on, keep them and throw them away.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/app.h"
#include "core/preset_file.h"

namespace pelage {

void openShelf(App& app) {
    for (const std::string& warning : loadShelf(app.shelf))
        std::fprintf(stderr, "pelage: %s\n", warning.c_str());
}

void dropPreset(App& app, const std::string& path) {
    if (!app.isOpen() || app.work.running()) return;
    cancelStroke(app);
    try {
        app.shelf.dropped = readPreset(path);
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    choosePreset(app, *app.shelf.dropped);
}

void keepPreset(App& app, Preset preset) {
    try {
        const std::string folder = presetFolder();
        preset.file = presetPath(folder, ownPresets(folder), preset.name);
        std::filesystem::create_directories(folder);
        // At once, so that nothing is lost; once more when its picture is drawn.
        writePreset(preset, preset.file);
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    openShelf(app);
    for (ShelfEntry& entry : app.shelf.entries)
        if (entry.preset.file == preset.file) entry.unfinished = preset.thumbnail.empty();
    app.shelf.dropped.reset();
    tell(app, "Kept as " + preset.file);
    trace(app, "kept " + preset.name);
}

void removePreset(App& app, const Preset& preset) {
    const std::string name = preset.name;  // the shelf is about to change
    std::error_code failed;
    std::filesystem::remove(preset.file, failed);
    if (failed) return complain(app, preset.file + ": " + failed.message());
    openShelf(app);
    tell(app, "Deleted the preset " + name);
    trace(app, "deleted " + name);
}

void stepPresets(App& app) {
    if (!shelfBusy(app.shelf)) return;
    try {
        stepShelf(app.shelf);
    } catch (const std::exception& error) {
        complain(app, error.what());
    }
    if (shelfBusy(app.shelf)) return;
    app.wake();  // one more frame, to show the last picture
    trace(app, "pictures");
}

}  // namespace pelage
