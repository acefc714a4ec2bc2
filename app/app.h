// app.h -- everything the window's parts share, and the verbs that change it.
//
// The window owns one App and hands it to panels, actions and the viewport. State that is saved
// lives in the editor, state of one person in the session; what is here besides is bookkeeping.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy.h"
#include "app/file_dialog.h"
#include "app/session.h"
#include "app/settings.h"
#include "app/shelf.h"
#include "app/shell_choice.h"
#include "app/theme.h"
#include "app/viewport.h"
#include "app/widgets.h"
#include "app/work.h"
#include "core/edge_cuts.h"
#include "core/gltf_out.h"
#include "core/gradient.h"
#include "core/journal.h"
#include "core/mask_edit.h"
#include "core/rig.h"
#include "core/script.h"

namespace pelage {

class AccuracyPictures;

enum class Dialog {
    none,
    unsaved,
    lostWork,
    open,
    saveAs,
    exportAs,
    savePreset,
    transfer,
    subdivide,
    accuracy,
    shellPicture
};

struct Dialogs {
    Dialog current = Dialog::none;
    FileDialog files;
    std::function<void()> then;  // goes on once unsaved work is saved or given up
    ExportOptions exportOptions;
    bool exportCheck = true;      // open the written file again and compare
    std::vector<MeshSize> sizes;  // of the mesh now and subdivided once, twice, ...
    int levels = 1;               // of which this one is chosen
    std::vector<LostWork> lost;   // offered one after the other
    Preset preset;                // that is to be saved; its coats come at the end
    bool presetFresh = false;     // its dialog was just opened
    std::string problem;          // shown in a box until it is read; empty = none
    bool help = false, report = false;
    bool escape = false, enter = false;  // keys of this frame, for the question that is open
};

// Edits on screen that are not yet a step of history: a slider or an arrow that is still held.
struct Pending {
    std::string path;   // of the parameter, or empty
    std::string label;  // of the step
    Fur before;
    uint segment = kNoSegment;  // whose axis is moved
};

struct App {
    Workspace workspace;  // the only owner of the document and its history
    Session session;
    Settings settings;
    Theme theme;
    Tips tips;
    Viewport viewport;
    Shelf shelf;
    ShellChoices shells;
    Dialogs dialogs;
    std::unique_ptr<Journal> journal;
    std::size_t journalStep = 0;  // the step of history that the journal's first line makes
    std::size_t journalEnd = 0;   // the last step that its other lines make
    std::string journalFile;      // that the first line opens; empty for the animal
    std::string snapshot;         // the same when nobody else knows that file
    Pose journalPose;             // that its lines so far end with
    bool restored = false;        // from a journal, and not saved since
    std::optional<Pending> pending;
    std::string file;     // what Save writes; empty until there is a .glb
    std::string name;     // of the animal, for title and status line
    std::string message;  // the latest, in the status line
    bool messageIsBad = false;
    FrameStats stats;        // of the last frame
    FrameStats movingStats;  // of the last one while the hand moved
    std::string device;
    bool touched = false;  // the document changed since the last frame
    bool panelsHidden = false;
    bool trace = false;  // one line on stdout for each step (PELAGE_TRACE)
    bool quit = false;
    std::function<void()> wake;  // ends the wait for events; any thread
    Accuracy accuracy;
    std::shared_ptr<AccuracyPictures> accuracyPictures;  // null until something was measured
    Work work;  // last: its thread ends before the rest goes

    bool isOpen() const { return workspace.editor != nullptr; }
    Editor& editor() { return *workspace.editor; }
    const Editor& editor() const { return *workspace.editor; }
    const Document& document() const { return workspace.editor->document(); }
    const Skin& skin() const { return *workspace.shown(); }  // as it stands
    // What can move it; null where nothing can.
    const Rig* rig() const { return isOpen() ? skin().source->rig.get() : nullptr; }
    // Of the clip in which it stands; 0 without one.
    float clipSeconds() const {
        const int clip = workspace.pose.clip;
        return clip < 0 ? 0.0f : rig()->clips[static_cast<std::size_t>(clip)].seconds;
    }
    // True while every frame differs from the one before.
    bool moves() const { return windBlows() || session.playback.playing; }
    bool windBlows() const {
        return isOpen() && session.view.playWind && document().fur.wind > 0.0f;
    }
    bool saved() const { return !isOpen() || (workspace.editor->saved() && !pending && !restored); }
};

// Messages. A problem is one line on stderr, in the status line and in a box.
void tell(App& app, std::string message);
void complain(App& app, const std::string& problem);
void trace(const App& app, const std::string& line);

// Edits (edits.cpp). Each ends in at most one step of history and one line of the journal.
void editParameter(App& app, const std::string& path, const std::string& label, vec3 value);
void editAxis(App& app, uint segment, vec3 root, vec3 tip);  // of the body, world
void commitPending(App& app);
void cancelPending(App& app);
void undo(App& app);
void redo(App& app);
void goToStep(App& app, std::size_t step);
void choosePreset(App& app, const Preset& preset);
void floodSkin(App& app, vec3 direction);                         // of combing, world
void resetSkin(App& app);                                         // what the brush paints
void editRegion(App& app);                                        // as the session says
void combAlong(App& app, uint segment, vec3 axis, float weight);  // world
void combBody(App& app, float weight);                            // from head to tail
void fillGradient(App& app, const Gradient& gradient);
void editMask(App& app, const MaskEdit& change);
void changeBody(App& app, const std::string& line);  // as segment_text.h says
// A step that was made elsewhere: its document, the query of its skin, and the line that makes it.
void takeStep(App& app, Document after, std::unique_ptr<SkinQuery> query, const char* label,
              const std::string& line);
void beginStroke(App& app, const Brush& brush, const SkinHit& hit, float pressure);
void endStroke(App& app);
void cancelStroke(App& app);
// Starts the journal anew for what is on screen: the file, or the animal if empty, is all of it.
void restartJournal(App& app, const std::string& file);
// The same for a file of our own with what is on screen, which was written beside the journal.
std::string snapshotPath(const App& app);
void restartFromSnapshot(App& app);
void dropSnapshot(App& app);

// How the animal stands (playback.cpp): no steps of history. Lines of the journal say it where an
// edit after it depends on it.
void stand(App& app, Pose pose);
void playOrPause(App& app);
// Between frames: goes on by so many seconds while it plays.
void playOn(App& app, float seconds);
// Before the pointer is used: a press pauses what plays, and finds the skin where it is seen.
void meetPointer(App& app, bool mine);

// Edits of the whole mesh, which take long (mesh_edits.cpp).
void askSubdivide(App& app);
void subdivideMesh(App& app, int levels);
void transferFrom(App& app, const std::string& path);

// Presets (preset_edits.cpp).
void openShelf(App& app);                            // reads the user's own
void dropPreset(App& app, const std::string& path);  // puts on what a file holds
void keepPreset(App& app, Preset preset);            // among the user's own, under its name
void removePreset(App& app, const Preset& preset);
void stepPresets(App& app);  // goes on with their pictures

// What the live picture's shortcuts cost (accuracy_steps.cpp).
void toggleAccuracy(App& app);
void measureAccuracy(App& app);
void cancelAccuracy(App& app);
void showAccuracy(App& app, AccuracyPicture picture);  // in place of the window's
unsigned accuracyTexture(const App& app, AccuracyPicture picture);
// In each frame: goes on measuring, by a frame only where nothing changed for a while and the
// window is not busy. Returns the seconds until it should be called again.
double stepAccuracy(App& app, double rested, bool busy);
void saveAccuracy(App& app, const std::string& path);

// What shells are cut from, of the coats that the panel shows (shell_edits.cpp). Where a file
// cannot be read it stays what it was.
void chooseShells(App& app, const ShellRecipe& recipe);
void openShellPicture(App& app, const std::string& path, ShellRecipe::From from);
void askForShellPicture(App& app, ShellRecipe::From from);

// Files (files.cpp). All of them ask first when work would be lost, and then go on by themselves.
void leave(App& app, std::function<void()> then);
void openFile(App& app, const std::string& path);
void openAnimal(App& app);
void save(App& app, std::function<void()> then = {});
void saveTo(App& app, const std::string& path, std::function<void()> then = {});
void exportTo(App& app, const std::string& path);
void restoreWork(App& app, const LostWork& lost);
void discardWork(App& app, const LostWork& lost);
void askForFile(App& app, Dialog purpose);
void requestQuit(App& app);
// A job beside the main thread; its errors are shown, `cancelled` when it was given up.
void startWork(App& app, const std::string& label, std::function<Finish(Progress&)> job,
               const std::string& cancelled);

}  // namespace pelage
