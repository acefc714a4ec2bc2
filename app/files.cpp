// files.cpp -- the verbs that read and write files, and the questions they ask first.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/app.h"
#include "app/export_check.h"
#include "core/animal.h"
#include "core/files.h"
#include "core/spacing.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

void rememberFile(App& app, const std::string& path) {
    remember(app.settings, path);
    app.settings.folder = fs::absolute(path).parent_path().string();
    try {
        saveSettings(app.settings, settingsPath());
    } catch (const std::exception& error) {
        tell(app, error.what());  // a nuisance, not a danger
    }
}

// Takes over what a worker has opened. `path` is empty for the built-in animal.
void adopt(App& app, Workspace opened, const std::string& path) {
    cancelDrag(app);
    app.pending.reset();
    app.viewport.hit.reset();
    app.workspace = std::move(opened);
    app.restored = false;
    app.file = hasExtension(path, ".glb") ? path : "";
    app.name = path.empty() ? "animal" : fs::path(path).filename().string();
    meetSkin(app.session, app.skin(), app.viewport.size.x / std::max(app.viewport.size.y, 1.0f));
    const LoadReport& report = app.skin().report;
    const std::size_t notes = report.warnings.size() + spacingNotes(app.document()).size();
    tell(app, app.name + ": " + grouped(report.triangles) + " triangles" +
                  (notes == 0 ? "" : ", " + std::to_string(notes) + " notes: Help > Load report"));
    for (const std::string& warning : report.warnings)
        std::fprintf(stderr, "pelage: %s\n", warning.c_str());
    trace(app, "opened " + (path.empty() ? "animal" : path));
}

std::string proposedName(const App& app) { return fs::path(app.name).stem().string() + ".glb"; }

// Goes on where an editor that was killed had ended: its journal becomes ours.
void takeOverWork(App& app, const LostWork& lost, Workspace opened, const std::string& lines) {
    const std::string file = lost.document == "animal" ? "" : lost.document;
    // A file beside the journal is no file of the user's.
    const bool own = fs::path(file).parent_path() == fs::path(lost.path).parent_path();
    if (app.journal) {
        app.journal->takeOver(lost, lines);
        dropSnapshot(app);
        if (own) app.snapshot = file;
    }
    adopt(app, std::move(opened), file);
    app.restored = true;
    app.journalFile = file;
    app.journalStep = 0;
    app.journalEnd = app.editor().stepCount() - 1;
    app.journalPose = app.workspace.pose;
    if (own) app.file.clear();
    tell(app, "Restored " + std::to_string(lost.edits) + " unsaved edits of " + app.name);
    trace(app, "restored " + std::to_string(lost.edits));
}

// Before a file is written over that the journal's first line opens: its other lines must not be
// run again on what they have made. The journal begins anew at a snapshot.
void leaveJournalFile(App& app, const std::string& path, std::function<void()> then) {
    std::error_code absent;
    if (!app.journal || app.saved() || !fs::equivalent(app.journalFile, path, absent))
        return then();
    startWork(
        app, "Keeping the work safe",
        [&app, then = std::move(then), document = app.document(),
         kept = snapshotPath(app)](Progress& progress) -> Finish {
            writeGroomedGlb(document, kept, {}, &progress);
            return [&app, then] {
                restartFromSnapshot(app);
                then();
            };
        },
        "Cancelled; the file is as it was");
}

}  // namespace

void startWork(App& app, const std::string& label, std::function<Finish(Progress&)> job,
               const std::string& cancelled) {
    if (app.work.running()) return;
    app.work.start(
        label, std::move(job),
        [&app, cancelled](const std::string& problem) {
            if (app.work.cancelling())
                tell(app, cancelled);
            else
                complain(app, problem);
        },
        app.wake);
}

void leave(App& app, std::function<void()> then) {
    if (app.work.running()) return;
    cancelStroke(app);
    if (app.isOpen()) commitPending(app);
    if (app.saved()) return then();
    app.dialogs.then = std::move(then);
    app.dialogs.current = Dialog::unsaved;
    trace(app, "asked unsaved");
}

void openFile(App& app, const std::string& path) {
    leave(app, [&app, path] {
        const std::string absolute = fs::absolute(path).lexically_normal().string();
        startWork(
            app, "Opening " + fs::path(path).filename().string(),
            [&app, absolute](Progress& progress) -> Finish {
                auto opened = std::make_shared<Workspace>();
                opened->open(openDocument(readSource(absolute, &progress), &progress));
                return [&app, absolute, opened] {
                    adopt(app, std::move(*opened), absolute);
                    restartJournal(app, absolute);
                    rememberFile(app, absolute);
                };
            },
            "Opening cancelled");
    });
}

void openAnimal(App& app) {
    leave(app, [&app] {
        startWork(
            app, "Making the animal",
            [&app](Progress&) -> Finish {
                auto opened = std::make_shared<Workspace>();
                opened->open(groomedAnimal(kAnimalTriangles));
                return [&app, opened] {
                    adopt(app, std::move(*opened), "");
                    restartJournal(app, "");
                };
            },
            "Cancelled");
    });
}

void askForFile(App& app, Dialog purpose) {
    FileDialog& dialog = app.dialogs.files;
    dialog = {};
    dialog.saving =
        purpose != Dialog::open && purpose != Dialog::transfer && purpose != Dialog::shellPicture;
    std::string proposed = proposedName(app);
    if (purpose == Dialog::shellPicture) {
        dialog.title = "Open a picture to cut fur from";
        dialog.accept = "Open";
        dialog.extensions = {".png", ".jpg", ".jpeg"};
    } else if (!dialog.saving) {
        const bool open = purpose == Dialog::open;
        dialog.title =
            open ? "Open a mesh or a groomed .glb" : "Transfer the groom of another file";
        dialog.accept = open ? "Open" : "Transfer";
        dialog.extensions = {".glb", ".gltf", ".obj", ".ply", ".off", ".stl"};
    } else if (purpose == Dialog::accuracy) {
        dialog.title = "Save the figures, with pictures beside them";
        dialog.accept = "Save";
        dialog.extensions = {".csv"};
        proposed = fs::path(app.name).stem().string() + "-accuracy.csv";
    } else {
        dialog.title = purpose == Dialog::saveAs ? "Save the groomed .glb" : "Export for others";
        dialog.accept = purpose == Dialog::saveAs ? "Save" : "Export";
        dialog.extensions = {".glb"};
    }
    const char* home = std::getenv("HOME");
    std::string folder = app.settings.folder;
    if (folder.empty() || !fs::is_directory(folder)) folder = home ? home : "/";
    browse(dialog, folder, dialog.saving ? proposed : "");
    app.dialogs.current = purpose;
}

void save(App& app, std::function<void()> then) {
    if (!app.isOpen() || app.work.running()) return;
    cancelStroke(app);
    if (!app.file.empty()) return saveTo(app, app.file, std::move(then));
    app.dialogs.then = std::move(then);
    askForFile(app, Dialog::saveAs);
}

void saveTo(App& app, const std::string& path, std::function<void()> then) {
    commitPending(app);
    const std::string absolute = fs::absolute(path).lexically_normal().string();
    const auto finish = [&app, absolute, then = std::move(then)] {
        app.editor().markSaved();
        app.restored = false;
        app.file = absolute;
        app.name = fs::path(absolute).filename().string();
        restartJournal(app, absolute);
        rememberFile(app, absolute);
        tell(app, "Saved " + absolute);
        trace(app, "saved " + absolute);
        if (then) then();
    };
    leaveJournalFile(app, absolute, [&app, absolute, finish] {
        startWork(
            app, "Saving " + fs::path(absolute).filename().string(),
            [absolute, finish, document = app.document()](Progress& progress) -> Finish {
                writeGroomedGlb(document, absolute, {}, &progress);
                return finish;
            },
            "Saving cancelled; the file is as it was");
    });
}

void exportTo(App& app, const std::string& path) {
    commitPending(app);
    const std::string absolute = fs::absolute(path).lexically_normal().string();
    leaveJournalFile(app, absolute, [&app, absolute] {
        startWork(
            app, "Exporting " + fs::path(absolute).filename().string(),
            [&app, absolute, options = app.dialogs.exportOptions, check = app.dialogs.exportCheck,
             document = app.document()](Progress& progress) -> Finish {
                writeGroomedGlb(document, absolute, options, &progress);
                const std::string proof = check ? checkExport(document, absolute, &progress) : "";
                return [&app, absolute, proof] {
                    rememberFile(app, absolute);
                    tell(app, "Exported " + absolute + proof);
                    trace(app, "exported " + absolute + proof);
                };
            },
            "Export cancelled");
    });
}

void restoreWork(App& app, const LostWork& lost) {
    startWork(
        app, "Restoring unsaved work",
        [&app, lost](Progress&) -> Finish {
            auto opened = std::make_shared<Workspace>();
            const std::string lines = replayJournal(*opened, lost.path);
            return
                [&app, lost, opened, lines] { takeOverWork(app, lost, std::move(*opened), lines); };
        },
        "Restoring cancelled; the work is offered again at the next start");
}

void discardWork(App& app, const LostWork& lost) {
    try {
        discardLostWork(lost);
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    std::error_code absent;
    fs::remove(lost.path + ".glb", absent);
    tell(app, "Unsaved work discarded");
    trace(app, "discarded");
}

void requestQuit(App& app) {
    leave(app, [&app] { app.quit = true; });
}

}  // namespace pelage
