// log_plot.cpp -- axes with ticks, the curve, and the point under the pointer.
#include "app/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

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
    // Round values, so far apart that each can be named.
    std::vector<float> ticks(float apart) const {
        constexpr std::array kDigits = {1.0f, 1.5f, 2.0f, 3.0f, 4.0f, 5.0f, 7.0f};
        const bool fine = greatest < 8.0f * least;  // else 1, 2 and 5
        std::vector<float> kept;
        float decade = std::pow(10.0f, std::floor(std::log10(least)));
        for (; decade <= greatest; decade *= 10.0f)
            for (const float digit : kDigits) {
                const float value = digit * decade;
                if (value < least || value > greatest) continue;
                if (!fine && digit != 1.0f && digit != 2.0f && digit != 5.0f) continue;
                if (kept.empty() || std::abs(at(value) - at(kept.back())) >= apart)
                    kept.push_back(value);
            }
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
    for (const float value : across.ticks(theme.px(44))) {
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
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);
        ImGui::SetTooltip("%s away: %s%s", plot.nameX(nearest->x).c_str(),
                          plot.nameY(nearest->y).c_str(),
                          nearest->sure ? "" : "\nThe reference is too noisy for it");
        ImGui::PopStyleVar();
    }
    ImGui::PopFont();
}

}  // namespace pelage
