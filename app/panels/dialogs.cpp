// dialogs.cpp -- the questions: unsaved work, lost work, files, problems, and the running job.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "app/panels/panels.h"
#include "core/subdivide.h"

namespace pelage {
bool beginModal(App& app, const char* name, float width) {
    if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * window.x, 0.46f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(app.theme.px(width), window.x - 20.0f), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {app.theme.px(20), app.theme.px(18)});
    const bool open =
        ImGui::BeginPopupModal(name, nullptr,
                               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    return open;
}

void heading(App& app, const char* text) {
    ImGui::PushFont(app.theme.title);
    ImGui::TextWrapped("%s", text);
    ImGui::PopFont();
    ImGui::Dummy({0, app.theme.px(4)});
}

float buttonsRight(App& app, int count) {
    ImGui::Dummy({0, app.theme.px(8)});
    const float width = app.theme.px(118);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const auto buttons = static_cast<float>(count);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - buttons * width -
                         (buttons - 1.0f) * gap);
    return width;
}

void closeDialog(App& app) {
    app.dialogs.current = Dialog::none;
    ImGui::CloseCurrentPopup();
}

namespace {

void drawUnsaved(App& app) {
    if (!beginModal(app, "unsaved", 460)) return;
    heading(app, ("Save the changes to " + app.name + "?").c_str());
    ImGui::TextWrapped("What was painted and set since the last save is lost otherwise.");
    const float width = buttonsRight(app, 3);
    const Ui ui = uiOf(app);
    const bool drop = plainButton(ui, "Don't save", width);
    ImGui::SameLine();
    const bool cancel = plainButton(ui, "Cancel", width) || app.dialogs.escape;
    ImGui::SameLine();
    const bool keep = primaryButton(ui, "Save", width) || app.dialogs.enter;
    if (drop || cancel || keep) {
        const auto then = std::exchange(app.dialogs.then, nullptr);
        closeDialog(app);
        if (drop) then();
        if (keep) save(app, then);
    }
    ImGui::EndPopup();
}

void drawLostWork(App& app) {
    if (!beginModal(app, "lost work", 520)) return;
    const LostWork lost = app.dialogs.lost.back();
    const bool animal = lost.document == "animal";
    const std::string name =
        animal ? "the animal" : std::filesystem::path(lost.document).filename().string();
    heading(app, "There is unsaved work");
    ImGui::TextWrapped("The editor ended without saving %s: %zu step%s that can be made again.",
                       name.c_str(), lost.edits, lost.edits == 1 ? "" : "s");
    if (!animal) ImGui::TextDisabled("%s", lost.document.c_str());
    const float width = buttonsRight(app, 3);
    const Ui ui = uiOf(app);
    const bool drop = plainButton(ui, "Discard", width);
    ImGui::SameLine();
    const bool later = plainButton(ui, "Keep for later", width) || app.dialogs.escape;
    ImGui::SameLine();
    const bool restore = primaryButton(ui, "Restore", width) || app.dialogs.enter;
    if (drop || later || restore) {
        app.dialogs.lost.pop_back();
        const bool more = !app.dialogs.lost.empty() && !restore;
        if (!more) closeDialog(app);
        if (drop) discardWork(app, lost);
        if (restore) leave(app, [&app, lost] { restoreWork(app, lost); });
    }
    ImGui::EndPopup();
}

// What an export holds, and the choices there are.
void drawExportChoices(App& app) {
    const Ui ui = uiOf(app);
    caption(ui, "GOES IN");
    ImGui::BulletText("Everything of the source: skin, joints, animations, materials, names");
    ImGui::BulletText("Length, density and direction at each of its vertices, and both coats");
    toggleRow(ui, "Fields once more as UV sets 2 to 4 (Godot, Babylon, older Blender)",
              &app.dialogs.exportOptions.compatibilityUvs,
              "For readers that drop attributes of their own names.");
    toggleRow(ui, "Open the written file again and compare it", &app.dialogs.exportCheck,
              "Proves that every vertex reads back equal to the bit.");
}

void drawFiles(App& app) {
    const Dialog purpose = app.dialogs.current;
    if (!beginModal(app, "files", 720)) return;
    std::function<void()> extras;
    if (purpose == Dialog::exportAs) extras = [&app] { drawExportChoices(app); };
    FileChoice choice = drawFileDialog(uiOf(app), app.dialogs.files, app.settings.recent,
                                       app.dialogs.enter, extras);
    if (app.dialogs.escape) choice = FileChoice::cancelled;
    if (choice != FileChoice::open) {
        const auto then = std::exchange(app.dialogs.then, nullptr);
        const std::string path = app.dialogs.files.name;
        closeDialog(app);
        if (choice == FileChoice::accepted) {
            if (purpose == Dialog::open) openFile(app, path);
            if (purpose == Dialog::saveAs) saveTo(app, path, then);
            if (purpose == Dialog::exportAs) exportTo(app, path);
            if (purpose == Dialog::transfer) transferFrom(app, path);
            if (purpose == Dialog::accuracy) saveAccuracy(app, path);
            if (purpose == Dialog::shellPicture) openShellPicture(app, path, app.shells.asked);
        }
    }
    ImGui::EndPopup();
}

void sizeColumn(const App& app, const char* title, MeshSize size, float spacing) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", title);
    ImGui::Text("%s vertices", grouped(size.vertices).c_str());
    ImGui::Text("%s triangles", grouped(size.triangles).c_str());
    ImGui::Text("%s apart", lengthText(spacing).c_str());
    ImGui::Dummy({0, app.theme.px(4)});
}

void drawSubdivide(App& app) {
    if (!beginModal(app, "subdivide", 460)) return;
    heading(app, "Subdivide the mesh");
    ImGui::TextWrapped(
        "Each triangle becomes four, rounded by Loop's rule. The fur and everything of the file "
        "go along.");
    ImGui::Dummy({0, app.theme.px(6)});
    const Ui ui = uiOf(app);
    constexpr const char* kTimes[] = {"Once", "Twice", "3 times"};
    const std::size_t count = app.dialogs.sizes.size() - 1;
    if (const auto other =
            choiceRow(ui, "levels", std::span(kTimes, count), app.dialogs.levels - 1))
        app.dialogs.levels = *other + 1;
    const MeshSize after = app.dialogs.sizes[static_cast<std::size_t>(app.dialogs.levels)];
    const float spacing = app.skin().spacing;
    if (ImGui::BeginTable("sizes", 2)) {
        sizeColumn(app, "Now", app.dialogs.sizes[0], spacing);
        sizeColumn(app, "Then", after, std::ldexp(spacing, -app.dialogs.levels));
        ImGui::EndTable();
    }
    const bool fits = after.triangles <= kMostTriangles;
    if (!fits)
        ImGui::TextDisabled("At most %s triangles are made.", grouped(kMostTriangles).c_str());
    const float width = buttonsRight(app, 2);
    const bool cancel = plainButton(ui, "Cancel", width) || app.dialogs.escape;
    ImGui::SameLine();
    ImGui::BeginDisabled(!fits);
    const bool yes = (primaryButton(ui, "Subdivide", width) || app.dialogs.enter) && fits;
    ImGui::EndDisabled();
    if (cancel || yes) closeDialog(app);
    if (yes) subdivideMesh(app, app.dialogs.levels);
    ImGui::EndPopup();
}

void drawProblem(App& app) {
    if (!beginModal(app, "problem", 480)) return;
    heading(app, "That did not work");
    ImGui::TextWrapped("%s", app.dialogs.problem.c_str());
    const float width = buttonsRight(app, 1);
    if (primaryButton(uiOf(app), "Close", width) || app.dialogs.escape || app.dialogs.enter) {
        app.dialogs.problem.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void drawWork(App& app) {
    if (!beginModal(app, "work", 420)) return;
    heading(app, app.work.label().c_str());
    ImGui::ProgressBar(app.work.done(), {-1, app.theme.px(8)}, "");
    const float width = buttonsRight(app, 1);
    ImGui::BeginDisabled(app.work.cancelling());
    if (plainButton(uiOf(app), app.work.cancelling() ? "Stopping..." : "Cancel", width))
        app.work.cancel();
    if (app.dialogs.escape) app.work.cancel();
    ImGui::EndDisabled();
    if (!app.work.running()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

void drawDialogs(App& app) {
    if (app.work.running() || ImGui::IsPopupOpen("work")) return drawWork(app);
    if (!app.dialogs.problem.empty()) return drawProblem(app);
    switch (app.dialogs.current) {
        case Dialog::none:
            return;
        case Dialog::unsaved:
            return drawUnsaved(app);
        case Dialog::lostWork:
            return drawLostWork(app);
        case Dialog::savePreset:
            return drawSavePreset(app);
        case Dialog::open:
        case Dialog::saveAs:
        case Dialog::exportAs:
        case Dialog::transfer:
        case Dialog::accuracy:
        case Dialog::shellPicture:
            return drawFiles(app);
        case Dialog::subdivide:
            return drawSubdivide(app);
    }
}

}  // namespace pelage
