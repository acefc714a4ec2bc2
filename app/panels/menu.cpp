// menu.cpp -- the menu bar and the toolbar, from the table of actions.
#include <filesystem>
#include <string>
#include <string_view>

#include "app/actions.h"
#include "app/panels/panels.h"
#include "core/spacing.h"

namespace pelage {
namespace {

void drawItem(App& app, const Action& action) {
    if (action.line) ImGui::Separator();
    const std::string key = shortcutText(action.keys[0]);
    const bool checked = action.checked && action.checked(app);
    std::string label = action.label;
    if (action.run == undo && app.isOpen() && !app.editor().undoLabel().empty())
        label += " " + std::string(app.editor().undoLabel());
    if (action.run == redo && app.isOpen() && !app.editor().redoLabel().empty())
        label += " " + std::string(app.editor().redoLabel());
    if (ImGui::MenuItem((label + "###" + action.name).c_str(), key.c_str(), checked,
                        isEnabled(app, action)))
        perform(app, action);
    tip(uiOf(app), action.help);
}

// How fine the mesh is for what grows on it.
void drawMeshSize(const App& app) {
    const Skin& skin = app.skin();
    ImGui::Separator();
    ImGui::TextDisabled("%s vertices, %s apart", grouped(skin.source->positions.size()).c_str(),
                        lengthText(skin.spacing).c_str());
    if (const float hair = medianHair(app.document()); hair > 0.0f && hair < skin.spacing)
        ImGui::TextDisabled("Coarser than the hair is long: %s", lengthText(hair).c_str());
}

void drawRecent(App& app) {
    if (!ImGui::BeginMenu("Open recent", !app.settings.recent.empty())) return;
    std::string chosen;
    for (const std::string& path : app.settings.recent) {
        const std::filesystem::path file(path);
        if (ImGui::MenuItem((file.filename().string() + "###" + path).c_str(),
                            file.parent_path().string().c_str()))
            chosen = path;
    }
    ImGui::EndMenu();
    if (!chosen.empty()) openFile(app, chosen);
}

void toolbarButton(App& app, const char* name) {
    const Action& action = actionNamed(name);
    const bool on = action.checked && action.checked(app);
    if (iconButton(uiOf(app), action.glyph, action.label, on, isEnabled(app, action)))
        perform(app, action);
    tip(uiOf(app), action.help);
    ImGui::SameLine();
}

void toolbarLine(const App& app) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = app.theme.px(30), gap = app.theme.px(6);
    ImGui::GetWindowDrawList()->AddLine({at.x + gap, at.y + 5}, {at.x + gap, at.y + height - 5},
                                        ImGui::GetColorU32(ImGuiCol_Separator));
    ImGui::Dummy({2 * gap, height});
    ImGui::SameLine();
}

}  // namespace

float drawMenu(App& app) {
    if (!ImGui::BeginMainMenuBar()) return 0.0f;
    const float height = ImGui::GetWindowSize().y;
    for (const char* menu : {"File", "Edit", "Brush", "Mask", "Mesh", "View", "Help"}) {
        if (!ImGui::BeginMenu(menu)) continue;
        for (const Action& action : actions()) {
            if (menu != std::string_view(action.menu)) continue;
            drawItem(app, action);
            if (action.name == std::string_view("file.open")) drawRecent(app);
        }
        if (menu == std::string_view("Mesh") && app.isOpen()) drawMeshSize(app);
        ImGui::EndMenu();
    }
    const std::string title = app.name + (app.saved() ? "" : "*");
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SameLine(0.5f * (ImGui::GetWindowWidth() - width));
    ImGui::TextDisabled("%s", title.c_str());
    ImGui::EndMainMenuBar();
    return height;
}

void drawToolbar(App& app, const Layout& layout) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {app.theme.px(8), app.theme.px(3)});
    beginPanel("toolbar", {0, layout.menu}, {layout.window.x, layout.toolbar},
               ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.theme.px(3), 0});
    for (const char* name : {"file.open", "file.save", "file.export"}) toolbarButton(app, name);
    toolbarLine(app);
    for (const char* name : {"edit.undo", "edit.redo"}) toolbarButton(app, name);
    toolbarLine(app);
    for (const char* name : {"brush.mirror", "brush.facing"}) toolbarButton(app, name);
    toolbarLine(app);
    for (const char* name :
         {"view.frame", "view.front", "view.side", "view.top", "view.orthographic"})
        toolbarButton(app, name);
    toolbarLine(app);
    constexpr const char* kOverlays[] = {"Fur", "Length", "Density", "Direction", "Mask",
                                         "Segments"};
    for (int i = 0; i < 6; ++i) {
        Overlay& shown = app.session.view.overlay;
        const auto overlay = static_cast<Overlay>(i);
        if (iconButton(uiOf(app), "", kOverlays[i], shown == overlay, app.isOpen()))
            shown = overlay;
        tip(uiOf(app),
            i == 0 ? "Show the fur alone." : "Show this painted field over the skin and the fur.");
        ImGui::SameLine();
    }
    ImGui::PopStyleVar();
    const float side = app.theme.px(30);
    ImGui::SameLine(ImGui::GetWindowWidth() - side - app.theme.px(8));
    toolbarButton(app, "help.keys");
    ImGui::End();
}

}  // namespace pelage
