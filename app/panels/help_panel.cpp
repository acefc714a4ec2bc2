// help_panel.cpp -- keys and mouse from the table of actions, and the load report.
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "app/actions.h"
#include "app/panels/panels.h"
#include "core/spacing.h"

namespace pelage {
namespace {

struct MouseHelp {
    const char* hand;
    const char* effect;
};
constexpr MouseHelp kMouse[] = {
    {"Left drag", "Paint"},
    {"Ctrl + left drag", "Paint with add and subtract exchanged"},
    {"Shift + left drag", "Smooth"},
    {"Shift + click", "Paint a line from the end of the last stroke"},
    {"Hold Z while painting", "A light touch, as of a pen"},
    {"Drag the end of a segment's arrow", "Move it; Ctrl keeps its direction"},
    {"Esc, right click", "Give up the stroke"},
    {"Middle drag, Alt + left drag", "Turn"},
    {"Shift + middle, Alt + middle", "Move"},
    {"Wheel, Ctrl + middle, Alt + right", "Nearer and farther"},
    {"Drag a number", "Change it; double click or Ctrl + click to type"},
    {"Right click on a number", "Its default"},
    {"Drop a file on the window", "Open it"},
};

void helpRow(const std::string& keys, const char* text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", keys.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text);
}

bool beginKeys(App& app, const char* id) {
    if (!ImGui::BeginTable(id, 2)) return false;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, app.theme.px(136));
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

void drawActionKeys(App& app, std::string_view menu) {
    std::string heading(menu);
    std::ranges::transform(heading, heading.begin(), [](char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    });
    caption(uiOf(app), heading.c_str());
    if (!beginKeys(app, menu.data())) return;
    for (const Action& action : actions()) {
        if (action.menu != menu) continue;
        std::string keys = shortcutText(action.keys[0]);
        if (action.keys[1].key != 0) keys += ", " + shortcutText(action.keys[1]);
        if (!keys.empty()) helpRow(keys, action.label);
    }
    ImGui::EndTable();
}

bool beginSheet(App& app, const char* title, bool* open, ImVec2 size) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({app.theme.px(size.x), app.theme.px(size.y)}, ImGuiCond_Appearing);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, color::kRaised);
    const bool shown =
        ImGui::Begin(title, open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleColor();
    return shown;
}

}  // namespace

void drawHelp(App& app) {
    if (!app.dialogs.help) return;
    if (beginSheet(app, "Keys and mouse", &app.dialogs.help, {1060, 640}) &&
        ImGui::BeginTable("columns", 3, ImGuiTableFlags_SizingStretchSame)) {
        ImGui::TableNextColumn();
        caption(uiOf(app), "MOUSE");
        for (const MouseHelp& row : kMouse) {
            ImGui::TextUnformatted(row.effect);
            ImGui::PushFont(app.theme.small);
            ImGui::TextDisabled("%s", row.hand);
            ImGui::PopFont();
            ImGui::Dummy({0, app.theme.px(2)});
        }
        ImGui::TableNextColumn();
        for (const char* menu : {"Brush", "Edit"}) drawActionKeys(app, menu);
        ImGui::TableNextColumn();
        for (const char* menu : {"View", "Mask", "File", "Help"}) drawActionKeys(app, menu);
        ImGui::EndTable();
    }
    ImGui::End();
}

void drawReport(App& app) {
    if (!app.dialogs.report || !app.isOpen()) return;
    if (beginSheet(app, "Load report", &app.dialogs.report, {460, 400})) {
        const LoadReport& report = app.skin().report;
        const std::pair<const char*, std::size_t> rows[] = {
            {"vertices in the file", report.vertices},
            {"triangles", report.triangles},
            {"vertices after welding", report.weldedVertices},
            {"vertices of no triangle", report.unusedVertices},
            {"edges of three triangles or more", report.nonManifoldEdges},
            {"edges used twice in one direction", report.flippedEdges},
            {"open edges", report.boundaryEdges},
            {"triangles without area", report.degenerateFaces},
        };
        if (beginKeys(app, "counts")) {
            for (const auto& [name, count] : rows) helpRow(grouped(count), name);
            ImGui::EndTable();
        }
        std::vector<std::string> notes = report.warnings;
        for (std::string& note : spacingNotes(app.document())) notes.push_back(std::move(note));
        caption(uiOf(app), notes.empty() ? "NO NOTES" : "NOTES");
        for (const std::string& note : notes) ImGui::TextWrapped("%s", note.c_str());
    }
    ImGui::End();
}

}  // namespace pelage
