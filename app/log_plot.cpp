// log_plot.cpp -- axes with ticks at 1, 2 and 5, the curve, and the point under the pointer.
#include "app/log_plot.h"

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

constexpr float kLabel = 46.0f, kAbove = 17.0f, kBelow = 16.0f;  // units of the design

bool hasPlace(const LogPlot::Point& p) {
    return p.x > 0.0f && p.y > 0.0f && std::isfinite(p.x) && std::isfinite(p.y);
}

// From a value to a place between two ends of the window.
struct Axis {
    float least = 0.0f, greatest = 0.0f;  // 0 while nothing is on it
    float from = 0.0f, to = 0.0f;         // window units

    void hold(float value) {
        least = least > 0.0f ? std::min(least, value) : value;
        greatest = std::max(greatest, value);
    }
    // Room at both ends, and at least `ratio` in all.
    void widen(float ratio) {
        const float room =
            std::max(std::pow(greatest / least, 0.06f), std::sqrt(ratio * least / greatest));
        least /= room;
        greatest *= room;
    }
    float at(float value) const {
        return from + (to - from) * std::log(value / least) / std::log(greatest / least);
    }
    // 1, 2 and 5 times powers of ten, or the powers alone where there are many.
    std::vector<float> ticks(float apart) const {
        std::vector<float> all;
        const int first = static_cast<int>(std::floor(std::log10(least)));
        const int last = static_cast<int>(std::ceil(std::log10(greatest)));
        for (int decade = first; decade <= last; ++decade)
            for (const float digit : {1.0f, 2.0f, 5.0f}) {
                const float value = digit * std::pow(10.0f, static_cast<float>(decade));
                if (value >= least && value <= greatest) all.push_back(value);
            }
        std::vector<float> kept;
        for (const float value : all)
            if (kept.empty() || std::abs(at(value) - at(kept.back())) >= apart)
                kept.push_back(value);
        return kept;
    }
};

}  // namespace

void drawLogPlot(const Theme& theme, ImVec2 corner, ImVec2 size, const LogPlot& plot) {
    std::vector<LogPlot::Point> points;
    std::ranges::copy_if(plot.points, std::back_inserter(points), hasPlace);
    const ImU32 dim = ImGui::GetColorU32(color::kDim), line = ImGui::GetColorU32(color::kLine);
    const ImU32 curve = ImGui::GetColorU32(color::kText), mark = ImGui::GetColorU32(color::kAccent);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImGui::PushFont(theme.small);
    draw.AddText(corner, dim, plot.title);

    Axis across{.from = corner.x + theme.px(kLabel), .to = corner.x + size.x};
    Axis up{.from = corner.y + size.y - theme.px(kBelow), .to = corner.y + theme.px(kAbove)};
    if (hasPlace(plot.marked)) points.push_back(plot.marked);
    for (const LogPlot::Point& point : points) {
        across.hold(point.x);
        up.hold(point.y);
    }
    draw.AddRectFilled({across.from, up.to}, {across.to, up.from}, ImGui::GetColorU32(color::kBack),
                       theme.px(3));
    if (points.empty()) return ImGui::PopFont();
    across.widen(4.0f);
    up.widen(3.0f);
    const float letter = ImGui::GetFontSize();
    for (const float value : up.ticks(1.3f * letter)) {
        const std::string text = plot.nameY(value);
        const float y = up.at(value), width = ImGui::CalcTextSize(text.c_str()).x;
        draw.AddLine({across.from, y}, {across.to, y}, line);
        draw.AddText({across.from - theme.px(5) - width, y - 0.5f * letter}, dim, text.c_str());
    }
    for (const float value : across.ticks(theme.px(52))) {
        const std::string text = plot.nameX(value);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float x = across.at(value);
        draw.AddLine({x, up.to}, {x, up.from}, line);
        const float left = std::clamp(x - 0.5f * width, across.from, across.to - width);
        draw.AddText({left, up.from + theme.px(2)}, dim, text.c_str());
    }

    const auto place = [&](const LogPlot::Point& p) { return ImVec2(across.at(p.x), up.at(p.y)); };
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
        const auto nearest = std::ranges::min_element(
            points, {}, [&](const LogPlot::Point& p) { return std::abs(across.at(p.x) - x); });
        draw.AddCircle(place(*nearest), theme.px(6), mark, 0, theme.px(1.5f));
        ImGui::SetTooltip("%s away: %s%s", plot.nameX(nearest->x).c_str(),
                          plot.nameY(nearest->y).c_str(),
                          nearest->sure ? "" : "\nThe reference is too noisy for it");
    }
    ImGui::PopFont();
}

}  // namespace pelage
