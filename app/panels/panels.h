// panels.h -- the panels: one function each, over the App; their state is in the session.
#pragma once

#include <span>

#include "app/app.h"

namespace pelage {

// Where the parts of the window are, in window units.
struct Layout {
    ImVec2 window{0, 0};
    float menu = 0, toolbar = 0, status = 0;  // heights
    float timeline = 0, accuracy = 0;         // the same; 0 = not there
    float left = 0, right = 0;                // widths of the columns

    float bottom() const { return status + accuracy; }  // of what is below the columns
};

float drawMenu(App& app);  // its height
void drawToolbar(App& app, const Layout& layout);
void drawBrushPanel(App& app, const Layout& layout);
void drawHandRows(App& app);  // parts of it
void drawGradient(App& app);
void drawMaskButtons(App& app);
void actionButtons(App& app, std::span<const char* const> names, int columns);
void drawSidePanel(App& app, const Layout& layout);  // tabs: coats, view, history, body, regions
void drawCoats(App& app);
void drawPresets(App& app);
void drawSavePreset(App& app);
void drawRegions(App& app);
void drawView(App& app);
void drawShells(App& app);  // a section of it
void drawHistory(App& app);
void drawSegments(App& app);
// A drop-down list of the body segments; the number of the one that is chosen now.
uint segmentRow(App& app, uint chosen);
void drawTimeline(App& app, const Layout& layout);
void drawMorphTargets(App& app);
void drawAccuracy(App& app, const Layout& layout);
void drawStatus(App& app, const Layout& layout);
void drawDialogs(App& app);
void drawHelp(App& app);
void drawReport(App& app);

// A panel that is fixed at its place. Ends with ImGui::End().
void beginPanel(const char* name, ImVec2 corner, ImVec2 size, ImGuiWindowFlags extra = 0);

// Of dialogs: a window in the middle that has all input until it is closed, its heading, and
// buttons of this many equal widths at the right end of the line (returns one width).
bool beginModal(App& app, const char* name, float width);
void heading(App& app, const char* text);
float buttonsRight(App& app, int count);
void closeDialog(App& app);

inline Ui uiOf(App& app) { return {app.theme, app.tips}; }

}  // namespace pelage
