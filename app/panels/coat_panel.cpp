// coat_panel.cpp -- the fur's parameters: what coats share, and two equal groups of one table.
#include <string>

#include "app/panels/panels.h"

namespace pelage {
namespace {

struct Group {
    const char* label;
    const char* path;
    Coat Fur::*coat;
};
constexpr Group kGroups[] = {{"Overcoat", "over", &Fur::over}, {"Undercoat", "under", &Fur::under}};

}  // namespace

void drawCoats(App& app) {
    const Ui ui = uiOf(app);
    // Two coats of one fur: what right click brings back is the fur of a mesh just opened.
    const Fur before = app.document().fur;
    const Fur plain = defaultFur();
    const float size = app.skin().size();
    caption(ui, "PRESET");
    drawPresets(app);
    ImGui::Dummy({0, app.theme.px(3)});
    if (section(ui, "Both coats")) {
        for (const Parameter& row : furParameters())
            if (const auto value = parameterRow(ui, row, parameterValue(before, row),
                                                parameterValue(plain, row), size))
                editParameter(app, std::string("fur.") + row.name, row.label, *value);
    }
    for (const Group& group : kGroups) {
        ImGui::PushID(group.path);
        if (section(ui, group.label)) {
            for (const Parameter& row : coatParameters())
                if (const auto value =
                        parameterRow(ui, row, parameterValue(before.*group.coat, row),
                                     parameterValue(plain.*group.coat, row), size))
                    editParameter(app, std::string(group.path) + "." + row.name,
                                  std::string(group.label) + ": " + row.label, *value);
        }
        ImGui::PopID();
    }
}

}  // namespace pelage
