// edits.cpp -- the verbs that change the document: each one step of history, one line of journal.
#include <cassert>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "app/app.h"
#include "core/animal.h"
#include "core/body.h"
#include "core/region_text.h"
#include "core/script.h"
#include "core/segment_text.h"

namespace pelage {
namespace {

// A parameter by its path: the row and which coat it belongs to.
struct ParameterPlace {
    const Parameter* row = nullptr;
    Coat Fur::*coat = nullptr;  // null for what the coats share
};

ParameterPlace placeOf(std::string_view path) {
    const std::size_t dot = path.find('.');
    const std::string_view group = path.substr(0, dot), name = path.substr(dot + 1);
    const bool shared = group == "fur";
    for (const Parameter& row : shared ? furParameters() : coatParameters())
        if (row.name == name)
            return {&row, shared ? nullptr : group == "over" ? &Fur::over : &Fur::under};
    assert(false);
    return {};
}

// One more line on the disk. A disk that refuses is told once for each line: work is at risk.
void note(App& app, std::string_view line) {
    app.touched = true;
    if (!app.journal) return;
    try {
        if (!(app.journalPose == app.workspace.pose)) {
            app.journal->append(poseLine(app.workspace.pose));
            app.journalPose = app.workspace.pose;
        }
        app.journal->append(line);
    } catch (const std::exception& error) {
        complain(app, error.what());
    }
}

// The journal begins at what is saved. When undo goes back beyond it, or redo to a step that was
// made before it, no line leads there: what is on screen is written beside the journal, which
// begins anew.
void keepJournalReachable(App& app) {
    const std::size_t step = app.editor().currentStep();
    if (!app.journal || (step >= app.journalStep && step <= app.journalEnd)) return;
    try {
        writeGroomedGlb(app.document(), snapshotPath(app));
        restartFromSnapshot(app);
    } catch (const std::exception& error) {
        complain(app, error.what());
    }
}

// At the end of a full history a new step makes the oldest go, and all others move down by one.
bool historyFull(const App& app) { return app.editor().currentStep() == Editor::kUndoSteps; }

void stepped(App& app, bool wasFull, std::string_view line) {
    if (wasFull && app.journalStep > 0) --app.journalStep;
    app.journalEnd = app.editor().currentStep();
    note(app, line);
    trace(app, "commit " + std::string(app.editor().undoLabel()));
}

// What the window keeps of a skin, once another one is on screen.
void meetOtherSkin(App& app, const std::shared_ptr<const Skin>& before) {
    if (app.document().skin == before) return;
    app.viewport.hit.reset();
}

// A step that a script line makes: run through the same code that replays it.
void runStep(App& app, const std::string& line) {
    commitPending(app);
    const bool full = historyFull(app);
    const Document before = app.document();
    try {
        runLine(app.workspace, line);
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    if (!(app.document() == before)) stepped(app, full, line);
}

std::string pendingLine(const App& app, const Pending& pending) {
    const Document& now = app.document();
    if (pending.segment == kNoSegment) return setLine(pending.before, now.fur);
    const Segment& segment = now.groom.body()[pending.segment];
    return moveSegmentLine(now.groom, pending.segment, segment.root, segment.tip);
}

// The brush as it is held: the Segment brush paints the segment that is chosen.
Brush withSegment(const App& app, Brush brush) {
    const Groom& groom = app.document().groom;
    if (brush.tool == Tool::segment && app.session.segment.chosen < groom.body().size())
        brush.segment = nameOfSegment(groom.body(), app.session.segment.chosen);
    return brush;
}

// False, and says so, when the Segment brush has nothing to paint.
bool canPaint(App& app, const Brush& brush) {
    if (brush.tool != Tool::segment || !brush.segment.empty()) return true;
    tell(app, "There is no body segment to paint: add one in the panel Body");
    return false;
}

}  // namespace

void tell(App& app, std::string message) {
    app.message = std::move(message);
    app.messageIsBad = false;
}

void complain(App& app, const std::string& problem) {
    std::fprintf(stderr, "pelage: %s\n", problem.c_str());
    app.message = problem;
    app.messageIsBad = true;
    app.dialogs.problem = problem;
}

void trace(const App& app, const std::string& line) {
    if (!app.trace) return;
    std::printf("trace: %s\n", line.c_str());
    std::fflush(stdout);
}

void restartJournal(App& app, const std::string& file) {
    if (!app.journal) return;
    const std::string animal = "animal " + std::to_string(kAnimalTriangles);
    try {
        app.journal->restart({file.empty() ? animal : "open " + file});
    } catch (const std::exception& error) {
        return complain(app, error.what());
    }
    app.journalStep = app.journalEnd = app.editor().currentStep();
    app.journalPose = {};
    app.journalFile = file;
    dropSnapshot(app);
}

std::string snapshotPath(const App& app) { return app.journal->path() + ".glb"; }

void restartFromSnapshot(App& app) {
    const std::string path = snapshotPath(app);
    // The second line counts as an edit: without one it would be no lost work.
    app.journal->restart({"open " + path, "# not saved elsewhere"});
    app.journalStep = app.journalEnd = app.editor().currentStep();
    app.journalPose = {};
    app.journalFile = path;
    if (app.snapshot != path) dropSnapshot(app);
    app.snapshot = path;
}

void dropSnapshot(App& app) {
    if (app.snapshot.empty()) return;
    std::error_code failed;  // a file that stays behind is a nuisance only
    std::filesystem::remove(app.snapshot, failed);
    app.snapshot.clear();
}

void editParameter(App& app, const std::string& path, const std::string& label, vec3 value) {
    if (app.pending && app.pending->path != path) commitPending(app);
    app.touched = true;
    if (!app.pending) app.pending = Pending{path, label, app.document().fur};
    const ParameterPlace place = placeOf(path);
    app.editor().edit([&](Document& document) {
        if (place.coat)
            setParameter(document.fur.*place.coat, *place.row, value);
        else
            setParameter(document.fur, *place.row, value);
    });
}

void editAxis(App& app, uint segment, vec3 root, vec3 tip) {
    if (app.pending && app.pending->segment != segment) commitPending(app);
    app.touched = true;
    if (!app.pending) {
        const std::string& name = app.document().groom.body()[segment].name;
        app.pending = Pending{"", "Move axis of " + name, {}, segment};
    }
    app.editor().edit([&](Document& document) { moveSegment(document.groom, segment, root, tip); });
}

void cancelPending(App& app) {
    if (!app.pending) return;
    app.pending.reset();
    app.editor().cancel();
    app.touched = true;
}

void commitPending(App& app) {
    if (!app.pending) return;
    const Pending pending = *app.pending;
    app.pending.reset();
    const std::string line = pendingLine(app, pending);
    const bool full = historyFull(app);
    if (app.editor().commit(pending.label)) stepped(app, full, line);
}

void undo(App& app) {
    commitPending(app);
    const std::string label(app.editor().undoLabel());
    const auto skin = app.document().skin;
    if (!app.workspace.undo()) return;
    meetOtherSkin(app, skin);
    note(app, "undo");
    keepJournalReachable(app);
    tell(app, "Undone: " + label);
    trace(app, "undo " + label);
}

void redo(App& app) {
    commitPending(app);
    const auto skin = app.document().skin;
    if (!app.workspace.redo()) return;
    meetOtherSkin(app, skin);
    note(app, "redo");
    keepJournalReachable(app);
    const std::string label(app.editor().undoLabel());
    tell(app, "Redone: " + label);
    trace(app, "redo " + label);
}

void goToStep(App& app, std::size_t step) {
    commitPending(app);
    while (app.editor().currentStep() > step) undo(app);
    while (app.editor().currentStep() < step) redo(app);
}

// The journal gets every value, since a file may change or go.
void choosePreset(App& app, const Preset& preset) {
    commitPending(app);
    app.pending = Pending{"", "Preset " + preset.name, app.document().fur};
    app.touched = true;
    app.editor().edit([&](Document& document) { applyPreset(document.fur, preset); });
    commitPending(app);
}

void floodSkin(App& app, vec3 direction) {
    const Brush brush = withSegment(app, app.session.brush());
    if (canPaint(app, brush)) runStep(app, floodLine(brush, direction));
}

void resetSkin(App& app) { runStep(app, std::string("reset ") + toolInfo(app.session.tool).name); }

void editRegion(App& app) { runStep(app, regionLine(app.session.region, app.session.regionEdit)); }

void combAlong(App& app, uint segment, vec3 axis, float weight) {
    runStep(app, segmentLine(app.document().groom, segment, axis, weight));
}

void combBody(App& app, float weight) { runStep(app, headToTailLine(weight)); }

void fillGradient(App& app, const Gradient& gradient) { runStep(app, gradientLine(gradient)); }

void editMask(App& app, const MaskEdit& change) { runStep(app, maskLine(change)); }

void changeBody(App& app, const std::string& line) { runStep(app, line); }

void takeStep(App& app, Document after, std::unique_ptr<SkinQuery> query, const char* label,
              const std::string& line) {
    commitPending(app);
    const bool full = historyFull(app);
    const auto skin = app.document().skin;
    app.editor().edit([&](Document& document) { document = std::move(after); });
    if (query) app.workspace.query = std::move(query);
    if (app.editor().commit(label)) stepped(app, full, line);
    app.workspace.follow();
    meetOtherSkin(app, skin);
}

void beginStroke(App& app, const Brush& brush, const SkinHit& hit, float pressure) {
    commitPending(app);
    const Brush held = withSegment(app, brush);
    if (canPaint(app, held)) app.workspace.press(held, hit.position, hit.normal, pressure);
}

void endStroke(App& app) {
    const bool full = historyFull(app);
    if (const std::string line = app.workspace.release(); !line.empty()) stepped(app, full, line);
}

void cancelStroke(App& app) {
    if (!app.workspace.stroke) return;
    app.workspace.cancelStroke();
    app.touched = true;
    tell(app, "Stroke cancelled");
    trace(app, "cancel");
}

}  // namespace pelage
