// log_plot.cpp -- axes with ticks, the curve, and the point under the pointer.
#include "app/log_plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/log_axis.h"

namespace pelage {
namespace {

constexpr float kLabel = 46.0f, kAbove = 17.0f, kBelow = 16.0f;  // units of the design

bool hasPlace(const LogPlot::Point& p) {
    return LogAxis::hasPlace(static_cast<double>(p.x)) &&
           LogAxis::hasPlace(static_cast<double>(p.y));
}

// Between two ends of the window.
LogAxis axisOf(float from, float to) {
    return {.from = static_cast<double>(from), .to = static_cast<double>(to)};
}

float placeOn(const LogAxis& axis, float value) {
    return static_cast<float>(axis.place(static_cast<double>(value)));
}

}  // namespace

void drawLogPlot(const Theme& theme, ImVec2 corner, ImVec2 size, const LogPlot& plot) {
    std::vector<LogPlot::Point> points;
    std::ranges::copy_if(plot.points, std::back_inserter(points), hasPlace);
    const ImU32 dim = ImGui::GetColorU32(color::kDim), line = ImGui::GetColorU32(color::kLine);
    const ImU32 curve = ImGui::GetColorU32(color::kText), mark = ImGui::GetColorU32(color::kAccent);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImGui::PushFont(theme.small);
    draw.AddText(corner, dim, plot.title);

    const ImVec2 lower(corner.x + theme.px(kLabel), corner.y + size.y - theme.px(kBelow));
    const ImVec2 upper(corner.x + size.x, corner.y + theme.px(kAbove));
    LogAxis across = axisOf(lower.x, upper.x), up = axisOf(lower.y, upper.y);
    if (hasPlace(plot.marked)) points.push_back(plot.marked);
    for (const LogPlot::Point& point : points) {
        across.hold(static_cast<double>(point.x));
        up.hold(static_cast<double>(point.y));
    }
    draw.AddRectFilled({lower.x, upper.y}, {upper.x, lower.y}, ImGui::GetColorU32(color::kBack),
                       theme.px(3));
    if (points.empty()) return ImGui::PopFont();
    across.widen(4.0);
    up.widen(3.0);
    const float letter = ImGui::GetFontSize();
    for (const double tick : up.ticks(static_cast<double>(1.3f * letter))) {
        const auto value = static_cast<float>(tick);
        const std::string text = plot.nameY(value);
        const float y = placeOn(up, value), width = ImGui::CalcTextSize(text.c_str()).x;
        draw.AddLine({lower.x, y}, {upper.x, y}, line);
        draw.AddText({lower.x - theme.px(5) - width, y - 0.5f * letter}, dim, text.c_str());
    }
    for (const double tick : across.ticks(static_cast<double>(theme.px(44)))) {
        const auto value = static_cast<float>(tick);
        const std::string text = plot.nameX(value);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float x = placeOn(across, value);
        draw.AddLine({x, upper.y}, {x, lower.y}, line);
        const float left = std::clamp(x - 0.5f * width, lower.x, upper.x - width);
        draw.AddText({left, lower.y + theme.px(2)}, dim, text.c_str());
    }

    const auto place = [&](const LogPlot::Point& p) {
        return ImVec2(placeOn(across, p.x), placeOn(up, p.y));
    };
    if (hasPlace(plot.marked)) points.pop_back();
    for (std::size_t i = 1; i < points.size(); ++i)
        draw.AddLine(place(points[i - 1]), place(points[i]), curve, theme.px(1.5f));
    const auto dot = [&](const LogPlot::Point& point, ImU32 ink, float radius) {
        draw.AddCircleFilled(place(point), theme.px(radius), ink);
        if (!point.sure)
            draw.AddCircleFilled(place(point), theme.px(radius - 1.3f),
                                 ImGui::GetColorU32(color::kBack));
    };
    for (const LogPlot::Point& point : points) dot(point, curve, 3.0f);
    if (hasPlace(plot.marked)) {
        points.push_back(plot.marked);
        dot(plot.marked, mark, 4.0f);
    }

    if (ImGui::IsMouseHoveringRect(corner, {corner.x + size.x, corner.y + size.y})) {
        const float x = ImGui::GetIO().MousePos.x;
        const auto nearest = std::ranges::min_element(points, {}, [&](const LogPlot::Point& p) {
            return std::abs(placeOn(across, p.x) - x);
        });
        draw.AddCircle(place(*nearest), theme.px(6), mark, 0, theme.px(1.5f));
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);
        ImGui::SetTooltip("%s away: %s%s", plot.nameX(nearest->x).c_str(),
                          plot.nameY(nearest->y).c_str(),
                          nearest->sure ? "" : "\nThe reference is too noisy for it");
        ImGui::PopStyleVar();
    }
    ImGui::PopFont();
}

}  // namespace pelage
