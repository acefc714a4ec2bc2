// widgets.h -- the small vocabulary that panels are written in, over Dear ImGui.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/theme.h"
#include "core/coat.h"

namespace pelage {

// Which tool tip may show: one appears after the pointer has rested.
struct Tips {
    const void* over = nullptr;  // text of the widget under the pointer
    double since = 0.0;          // s
    double wakeAt = 0.0;         // s, when a frame is needed for it; 0 = never
    bool seen = false;           // a widget under the pointer was met in this frame
};

// What the panels need to draw themselves.
struct Ui {
    const Theme& theme;
    Tips& tips;
};

// A linear color as the screen shows it.
vec3 displayedColor(vec3 color);

void beginTips(Tips& tips);
// Of the widget before; `text` has to outlive the frame. `detail` is a dim line below it.
void tip(Ui ui, const char* text, const char* detail = "");

// A heading that opens and closes what is under it.
bool section(Ui ui, const char* label, bool open = true);
// Small capitals-like label above a group of widgets.
void caption(Ui ui, const char* text);

// Starts a row: the label to the left, the next widget fills the rest.
void rowLabel(Ui ui, const char* label);

struct Number {
    float least = 0.0f, greatest = 1.0f;
    float fallback = 0.0f;  // right click brings it back
    const char* format = "%.3g";
    bool logarithmic = false;
    const char* help = "";
    const char* unit = "";  // in words, for the tool tip
};
// A bar to drag; double click or Ctrl+click to type. The new value when it changed.
std::optional<float> numberBar(Ui ui, const char* id, float value, const Number& number);
std::optional<float> numberRow(Ui ui, const char* label, float value, const Number& number);

// A row of the parameter table. `fallback` is what right click brings back; `size` that of the skin
// in m, which bounds the bars of lengths.
std::optional<vec3> parameterRow(Ui ui, const Parameter& row, vec3 value, vec3 fallback,
                                 float size);

bool toggleRow(Ui ui, const char* label, bool* on, const char* help);
// Buttons of which one is chosen, equal where their labels fit; the new index when another was
// clicked.
std::optional<int> choiceRow(Ui ui, const char* id, std::span<const char* const> labels,
                             int chosen);
// Drop-down list over all of the width.
std::optional<int> choiceList(Ui ui, const char* id, std::span<const char* const> labels,
                              int chosen);

bool primaryButton(Ui ui, const char* label, float width = 0.0f);
bool plainButton(Ui ui, const char* label, float width = 0.0f);
// Flat square button with an icon, or the label where there is no icon font.
bool iconButton(Ui ui, const char* glyph, const char* label, bool on, bool enabled);

// A text with thousands separated: 1 234 567.
std::string grouped(std::size_t number);

}  // namespace pelage
