// history_panel.cpp -- the steps of the editor; a click goes to one.
#include <string>

#include "app/panels/panels.h"

namespace pelage {

void drawHistory(App& app) {
    const Editor& editor = app.editor();
    const std::size_t current = editor.currentStep();
    std::size_t chosen = current;
    caption(uiOf(app), "CLICK A STEP TO GO THERE");
    for (std::size_t step = editor.stepCount(); step-- > 0;) {
        const std::string label =
            std::to_string(step) + "   " + std::string(editor.stepLabel(step)) + "##step";
        ImGui::PushID(static_cast<int>(step));
        if (step > current) ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
        if (ImGui::Selectable(label.c_str(), step == current)) chosen = step;
        if (step > current) ImGui::PopStyleColor();
        ImGui::PopID();
    }
    if (chosen != current) goToStep(app, chosen);
}

void drawSidePanel(App& app, const Layout& layout) {
    const float top = layout.menu + layout.toolbar;
    beginPanel("side", {layout.window.x - layout.right, top},
               {layout.right, layout.window.y - top - layout.bottom()},
               ImGuiWindowFlags_NoScrollbar);
    struct Tab {
        const char* label;
        void (*draw)(App&);
    };
    constexpr Tab kTabs[] = {{"Coats", drawCoats},
                             {"View", drawView},
                             {"History", drawHistory},
                             {"Body", drawSegments},
                             {"Regions", drawRegions}};
    if (app.isOpen() && ImGui::BeginTabBar("tabs")) {
        for (const Tab& tab : kTabs) {
            if (!ImGui::BeginTabItem(tab.label)) continue;
            ImGui::BeginChild("content");
            tab.draw(app);
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

}  // namespace pelage
