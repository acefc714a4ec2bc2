// log_plot.h -- a small curve in two logarithmic axes, which tells the value under the pointer.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "app/theme.h"

namespace pelage {

struct LogPlot {
    struct Point {
        float x = 0.0f, y = 0.0f;  // > 0, or it has no place
        bool sure = true;          // drawn hollow where it is not
    };
    const char* title;
    std::string (*nameX)(float x);  // of a value, with its unit
    std::string (*nameY)(float y);
    std::vector<Point> points{};  // joined in this order
    Point marked{};               // one more, in the color of the accent
};

// With its corner there, in window units. Plots below each other have their axes in line.
void drawLogPlot(const Theme& theme, ImVec2 corner, ImVec2 size, const LogPlot& plot);

}  // namespace pelage
