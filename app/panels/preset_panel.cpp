// preset_panel.cpp -- presets as a grid of pictures, and saving one's own.
#include "app/panels/panels.h"  // first: the next needs ImGui

#include <imgui_stdlib.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace pelage {
namespace {

constexpr int kColumns = 3;
constexpr float kSide = 92.0f;   // of a picture, units of the design
constexpr float kNames = 26.0f;  // height of two lines of small text

bool isWorn(const App& app, const Preset& preset) {
    Fur made = app.document().fur;
    applyPreset(made, preset);
    return made == app.document().fur;
}

// True when it was clicked.
bool drawCell(App& app, const ShelfEntry& entry) {
    const Ui ui = uiOf(app);
    const float side = ui.theme.px(kSide), rounding = ui.theme.px(4);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 end{corner.x + side, corner.y + side};
    const bool clicked = ImGui::InvisibleButton("cell", {side, side + ui.theme.px(kNames)});
    const bool over = ImGui::IsItemHovered();
    const std::string& note = entry.preset.note.empty() ? entry.preset.name : entry.preset.note;
    const std::string author = entry.preset.author.empty() ? "" : "By " + entry.preset.author;
    tip(ui, note.c_str(), author.c_str());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (const unsigned texture = textureOf(entry))
        draw.AddImageRounded((ImTextureID) static_cast<std::intptr_t>(texture), corner, end, {0, 0},
                             {1, 1}, IM_COL32_WHITE, rounding);
    else
        draw.AddRectFilled(corner, end, ImGui::GetColorU32(color::kFrame), rounding);
    const bool worn = isWorn(app, entry.preset);
    if (worn || over)
        draw.AddRect(corner, end, ImGui::GetColorU32(worn ? color::kAccent : color::kDim), rounding,
                     0, ui.theme.px(2));
    ImGui::PushFont(ui.theme.small);
    const char* name = entry.preset.name.c_str();
    const float width = ImGui::CalcTextSize(name, nullptr, false, side).x;
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                 {corner.x + 0.5f * (side - width), end.y + ui.theme.px(2)},
                 ImGui::GetColorU32(ImGuiCol_Text), name, nullptr, side);
    ImGui::PopFont();
    return clicked;
}

// What the right button offers for a preset of the user's own; true when it was thrown away.
bool drawCellMenu(const Preset& preset) {
    bool thrown = false;
    if (preset.file.empty() || !ImGui::BeginPopupContextItem("menu")) return false;
    ImGui::TextDisabled("%s", preset.file.c_str());
    if (ImGui::MenuItem("Copy the name of the file")) ImGui::SetClipboardText(preset.file.c_str());
    if (ImGui::BeginMenu("Delete")) {
        thrown = ImGui::MenuItem("Yes, delete the file");
        ImGui::EndMenu();
    }
    ImGui::EndPopup();
    return thrown;
}

void drawGrid(App& app) {
    const Ui ui = uiOf(app);
    std::optional<Preset> chosen, thrown;
    int column = 0;
    const char* title = "";
    const bool mixed = !app.shelf.entries.front().preset.file.empty();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.theme.px(6), ui.theme.px(6)});
    for (const ShelfEntry& entry : app.shelf.entries) {
        const char* kind = entry.preset.file.empty() ? "OF THE PROGRAM" : "YOUR OWN";
        if (mixed && std::exchange(title, kind) != kind) {
            column = 0;
            caption(ui, kind);
        }
        if (column++ % kColumns != 0) ImGui::SameLine();
        ImGui::PushID((entry.preset.file + entry.preset.name).c_str());
        if (drawCell(app, entry)) chosen = entry.preset;
        if (drawCellMenu(entry.preset)) thrown = entry.preset;
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    if (chosen) {
        choosePreset(app, *chosen);
        ImGui::CloseCurrentPopup();
    }
    if (thrown) removePreset(app, *thrown);
}

void askForName(App& app) {
    Preset& draft = app.dialogs.preset;
    draft.name.clear();
    draft.note.clear();  // the author most likely stays the same
    app.dialogs.presetFresh = true;
    app.dialogs.current = Dialog::savePreset;
}

void field(const char* label, std::string& text, const char* hint) {
    ImGui::TextDisabled("%s", label);
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##text", hint, &text);
    ImGui::PopID();
}

}  // namespace

void drawPresets(App& app) {
    const Ui ui = uiOf(app);
    Shelf& shelf = app.shelf;
    if (shelf.entries.empty()) openShelf(app);
    const auto worn = std::ranges::find_if(
        shelf.entries, [&](const ShelfEntry& entry) { return isWorn(app, entry.preset); });
    const bool known = worn != shelf.entries.end();
    const float button = ui.theme.px(76), gap = ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - gap);
    const float width = kColumns * ui.theme.px(kSide + 6) + 2 * ImGui::GetStyle().WindowPadding.x +
                        ImGui::GetStyle().ScrollbarSize;
    const float room = ImGui::GetIO().DisplaySize.y - ImGui::GetCursorScreenPos().y;
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, room - 2 * ImGui::GetFrameHeight()});
    const bool wasShown = std::exchange(shelf.shown, false);
    if (ImGui::BeginCombo("##preset", known ? worn->preset.name.c_str() : "Own mixture")) {
        if (!wasShown) openShelf(app);
        shelf.shown = true;
        drawGrid(app);
        ImGui::EndCombo();
    }
    tip(ui, "Coats to begin with. Choosing one is a step that can be undone.");
    ImGui::SameLine();
    if (plainButton(ui, "Save as...", button)) askForName(app);
    tip(ui, "Keep these coats as a preset of your own.");
    if (!shelf.dropped) return;
    if (plainButton(ui, "Keep", button)) return keepPreset(app, *shelf.dropped);
    tip(ui, "Put the preset that was dropped among your own.");
    ImGui::SameLine();
    ImGui::Text("%s", shelf.dropped->name.c_str());
}

void drawSavePreset(App& app) {
    if (!beginModal(app, "preset", 420)) return;
    Preset& draft = app.dialogs.preset;
    heading(app, "Save the coats as a preset");
    if (std::exchange(app.dialogs.presetFresh, false)) ImGui::SetKeyboardFocusHere();
    field("Name", draft.name, "What it is called");
    field("Author", draft.author, "Who made it");
    field("Note", draft.note, "One sentence about it");
    const auto same = std::ranges::find_if(app.shelf.entries, [&](const ShelfEntry& entry) {
        return entry.preset.name == draft.name;
    });
    const bool known = same != app.shelf.entries.end();
    const bool taken = known && same->preset.file.empty();
    ImGui::TextDisabled("%s", taken   ? "A preset of the program has this name."
                              : known ? "Takes the place of your preset of this name."
                                      : " ");
    const float width = buttonsRight(app, 2);
    const Ui ui = uiOf(app);
    const bool possible = !draft.name.empty() && !taken;
    const bool cancel = plainButton(ui, "Cancel", width) || app.dialogs.escape;
    ImGui::SameLine();
    ImGui::BeginDisabled(!possible);
    const bool keep =
        primaryButton(ui, known && !taken ? "Replace" : "Save", width) || app.dialogs.enter;
    ImGui::EndDisabled();
    if (cancel || (keep && possible)) closeDialog(app);
    if (keep && possible && !cancel) {
        Preset preset = draft;
        preset.fur = app.document().fur;
        preset.seeded = true;
        keepPreset(app, std::move(preset));
    }
    ImGui::EndPopup();
}

}  // namespace pelage
