// accuracy_panel.cpp -- the live picture beside its reference, what it errs and what it costs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "app/log_plot.h"
#include "app/panels/panels.h"
#include "core/heat_map.h"

namespace pelage {
namespace {

std::string number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

struct Figure {
    const char* name;
    std::string value;
    const char* help;
    bool bad = false;
};

std::string noiseText(const AccuracyPoint& view) {
    const double share = noiseShare(view.errors.rmse, view.reference);
    const std::string noise = number("%.4f", static_cast<double>(view.reference.noise.color));
    return noise + (share < 9.995 ? number(", %.0f %% of RMSE", 100.0 * share) : "");
}

std::vector<Figure> errorsOf(const AccuracyPoint& view) {
    const ImageErrors& errors = view.errors;
    std::vector<Figure> rows = {
        {"FLIP, mean", number("%.4f", errors.flipMean),
         "The difference that a viewer sees who flips between both pictures: 0 none, 1 all."},
        {"FLIP, worst 1 %", number("%.4f", errors.flip99),
         "99 % of the pixels differ by less than this."},
        {"RMSE, linear light", number("%.4f", errors.rmse),
         "Root of the mean square error of red, green and blue, before display encoding."},
        {"SSIM", number("%.4f", errors.ssim), "How alike the structure is: 1 for equal pictures."},
        {"Brightness", number("%+.2f %%", 100.0 * errors.luminanceBias),
         "Mean luminance against that of the reference."}};
    if (const auto& coverage = errors.coverage) {
        rows.push_back({"Covered area", number("%.2f %%", 100.0 * coverage->areaRatio),
                        "Area that skin and hair cover, of that in the reference."});
        rows.push_back({"Silhouette error", number("%.2f %%", 100.0 * coverage->silhouette),
                        "Share of the area that only one of both pictures covers."});
    }
    rows.push_back(
        {"Noise", noiseText(view),
         "What chance leaves in the reference. Over a fifth of the error its figures are "
         "not to be trusted: take more samples.",
         !view.trusted()});
    return rows;
}

std::string askedText(const Detail& detail) {
    const DetailRule& rule = ruleOf(detail);
    std::string text = rule.label;
    if (rule.format) text += ", " + number(rule.format, static_cast<double>(detail.limit));
    return text;
}

// "undercoat, 16 layers, 240 ms"
std::string shellsText(const View& view, const FrameStats& stats) {
    const bool over = view.showOver && stats.inShells.x > 0.0f;
    const bool under = view.showUnder && stats.inShells.y > 0.0f;
    if (!over && !under) return "none";
    std::string text = over && under ? "both coats" : over ? "overcoat" : "undercoat";
    if (stats.layers > 0) text += ", " + std::to_string(stats.layers) + " layers";
    return text + number(", %.0f ms", 1e3 * stats.shellSeconds);
}

std::vector<Figure> costsOf(const App& app, const AccuracyPoint& view) {
    const FrameStats& stats = view.live.stats;
    const FrameStats& moving = app.movingStats;
    const float asked = app.session.view.detail.milliseconds;
    std::vector<Figure> rows = {
        {"Frame", number("%.1f ms", view.ms()),
         "Median of the frames of this picture, to the end of the GPU's work. The picture is the "
         "mean of several."},
        {"Hairs drawn", grouped(stats.hairsDrawn) + " of " + grouped(stats.hairsTotal),
         "That the rule of detail left and the skin did not hide, of all that grow."},
        {"Segments", grouped(stats.segmentsDrawn), "Straight pieces of these hairs."},
        {"Shells", shellsText(app.accuracy.subject().view, stats),
         "Coats that are drawn in layers, and the time that these take of the frame."},
        {"Detail, asked", askedText(app.accuracy.subject().view.detail),
         "The rule under View, Hairs."},
        {"Detail, achieved", number("FLIP %.4f", view.errors.flipMean),
         "What the picture errs that the rule gave, measured against the reference."}};
    if (asked > 0.0f) {
        const bool drawn = moving.seconds > 0.0;
        rows.push_back({"Moving, asked", number("%.0f ms", static_cast<double>(asked)),
                        "The time that a frame of the window may take while the hand moves."});
        rows.push_back(
            {"Moving, achieved",
             !drawn ? "-"
                    : number("%.0f ms", 1e3 * moving.seconds) +
                          (moving.deviation >= 0.01f
                               ? number(", %.2g px off", static_cast<double>(moving.deviation))
                               : ""),
             "Of the last such frame: its time, and by how much it was coarser to keep to it."});
    }
    return rows;
}

// Names to the left, values to the right.
void drawFigures(const Ui& ui, ImVec2 corner, float width, const std::vector<Figure>& rows) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float step = ui.theme.px(19);
    for (const Figure& row : rows) {
        ImGui::SetCursorScreenPos(corner);
        ImGui::PushID(&row);
        ImGui::InvisibleButton("row", {width, step});
        tip(ui, row.help);
        if (ImGui::IsItemHovered())
            draw.AddRectFilled(corner, {corner.x + width, corner.y + step},
                               ImGui::GetColorU32(color::kRaised), ui.theme.px(3));
        ImGui::PopID();
        const float top = corner.y + 0.5f * (step - ImGui::GetFontSize());
        const float text = ImGui::CalcTextSize(row.value.c_str()).x;
        const float pad = ui.theme.px(4);
        draw.AddText({corner.x + pad, top}, ImGui::GetColorU32(color::kDim), row.name);
        draw.AddText({corner.x + width - pad - text, top},
                     ImGui::GetColorU32(row.bad ? color::kBad : color::kText), row.value.c_str());
        corner.y += step;
    }
}

void drawHeatScale(const Ui& ui, ImVec2 right) {
    constexpr int kSteps = 24;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float width = ui.theme.px(48) / kSteps, height = ui.theme.px(7);
    const float left = right.x - width * kSteps - ImGui::CalcTextSize(" 1").x;
    const float top = right.y + 0.5f * (ImGui::GetFontSize() - height);
    for (int i = 0; i < kSteps; ++i) {
        const vec3 c = displayedColor(heatColor((static_cast<float>(i) + 0.5f) / kSteps));
        const float x = left + static_cast<float>(i) * width;
        draw.AddRectFilled({x, top}, {x + width, top + height},
                           ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1.0f)));
    }
    const ImU32 dim = ImGui::GetColorU32(color::kDim);
    draw.AddText({left - ImGui::CalcTextSize("0 ").x, right.y}, dim, "0");
    draw.AddText({right.x - ImGui::CalcTextSize("1").x, right.y}, dim, "1");
}

struct Cell {
    AccuracyPicture picture;
    const char* name;
    const char* help;
};
constexpr std::array kCells = {
    Cell{AccuracyPicture::live, "Live",
         "As the window draws it at rest. Click to see it in place; H flips to the reference."},
    Cell{AccuracyPicture::reference, "Reference",
         "Every hair at its true width, traced by rays. Click to see it in place; H flips to the "
         "live picture."},
    Cell{AccuracyPicture::heat, "Difference",
         "FLIP of each pixel: dark where nobody sees a difference. Click to see it in place."}};

void drawCell(App& app, const Cell& cell, ImVec2 corner, ImVec2 size) {
    const Ui ui = uiOf(app);
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushID(cell.name);
    const bool clicked = ImGui::InvisibleButton("cell", size);
    ImGui::PopID();
    tip(ui, cell.help);
    const bool over = ImGui::IsItemHovered(), shown = app.accuracy.shown == cell.picture;
    const bool fresh = app.accuracy.fresh();
    if (clicked && fresh) showAccuracy(app, shown ? AccuracyPicture::none : cell.picture);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float rounding = ui.theme.px(4);
    const unsigned texture = accuracyTexture(app, cell.picture);
    draw.AddImageRounded((ImTextureID) static_cast<std::intptr_t>(texture), corner, end, {0, 0},
                         {1, 1}, ImGui::GetColorU32(ImVec4(1, 1, 1, 1)), rounding);
    if (shown || (over && fresh))
        draw.AddRect(corner, end, ImGui::GetColorU32(shown ? color::kAccent : color::kDim),
                     rounding, 0, ui.theme.px(2));
    const float below = end.y + ui.theme.px(3);
    draw.AddText({corner.x + ui.theme.px(2), below},
                 ImGui::GetColorU32(shown ? color::kAccent : color::kText), cell.name);
    if (cell.picture == AccuracyPicture::heat) drawHeatScale(ui, {end.x, below});
}

// Returns the right end.
float drawPictures(App& app, ImVec2 corner, float room, float height) {
    const Theme& theme = app.theme;
    const ivec2 pixels = app.accuracy.subject().view.size;
    const float aspect = static_cast<float>(pixels.x) / static_cast<float>(pixels.y);
    const float gap = theme.px(8), caption = theme.px(18);
    const float width = std::min((room - 2 * gap) / 3, (height - caption) * aspect);
    for (const Cell& cell : kCells) {
        drawCell(app, cell, corner, {width, width / aspect});
        corner.x += width + gap;
    }
    return corner.x - gap;
}

void drawCurves(const App& app, ImVec2 corner, ImVec2 size) {
    const auto flip = [](const AccuracyPoint& p) {
        return LogPlot::Point{p.distance, static_cast<float>(p.errors.flipMean), p.trusted()};
    };
    const auto time = [](const AccuracyPoint& p) {
        return LogPlot::Point{p.distance, static_cast<float>(p.ms())};
    };
    constexpr auto kError = [](float y) { return number("%.2g", static_cast<double>(y)); };
    constexpr auto kTime = [](float y) { return number("%.3g ms", static_cast<double>(y)); };
    LogPlot error{"FLIP over the distance", lengthText, kError};
    LogPlot cost{"Time of a frame", lengthText, kTime};
    const std::vector<AccuracyPoint>& points = app.accuracy.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
        error.points.push_back(flip(points[i]));
        cost.points.push_back(time(points[i]));
    }
    error.marked = flip(points[0]);
    cost.marked = time(points[0]);
    const float gap = app.theme.px(12), half = 0.5f * (size.x - gap);
    drawLogPlot(app.theme, corner, {half, size.y}, error);
    drawLogPlot(app.theme, {corner.x + half + gap, corner.y}, {half, size.y}, cost);
}

// What to measure.
void drawChoices(App& app) {
    const Ui ui = uiOf(app);
    AccuracyOptions& options = app.accuracy.options;
    const auto choose = [&](const char* id, auto& value, const auto& values,
                            std::span<const char* const> names, float width, const char* help) {
        const auto at = std::ranges::find(values, value);
        ImGui::SameLine();
        ImGui::SetNextItemWidth(ui.theme.px(width));
        if (const auto other = choiceList(ui, id, names, static_cast<int>(at - values.begin())))
            value = values[static_cast<std::size_t>(*other)];
        tip(ui, help);
    };
    constexpr const char* kSamples[] = {"64 samples", "256 samples", "1024 samples"};
    choose("##samples", options.samples, std::array{64u, 256u, 1024u}, kSamples, 112,
           "Rays through each pixel of the reference: four times as many halve its noise.");
    constexpr const char* kLight[] = {"Live light", "Traced light"};
    choose("##light", options.traced, std::array{false, true}, kLight, 106,
           "Live light: the reference has the light of the live picture, and what differs is how "
           "hairs are drawn. Traced light: with shadows by rays as well.");
    constexpr const char* kSides[] = {"320 px", "640 px", "As the view"};
    choose("##side", options.side, std::array{320, 640, 0}, kSides, 100,
           "Longer side of the pictures. Detail that depends on pixels is that of this size.");
}

// What is being done, or what the figures are of.
std::string stateText(const Accuracy& accuracy) {
    if (!accuracy.problem().empty()) return accuracy.problem();
    if (accuracy.state() == Accuracy::State::measuring) return accuracy.doing();
    if (accuracy.points().empty()) return "";
    const ivec2 size = accuracy.subject().view.size;
    const std::string of = std::to_string(size.x) + " \xC3\x97 " + std::to_string(size.y) +
                           " px, " + std::to_string(accuracy.points().front().samples) + " samples";
    return accuracy.fresh() ? of : "Of an older view";
}

void drawHeader(App& app) {
    const Ui ui = uiOf(app);
    Accuracy& accuracy = app.accuracy;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.theme.strong);
    ImGui::TextUnformatted("Accuracy");
    ImGui::PopFont();
    ImGui::SameLine(ui.theme.px(86));
    const bool measuring = accuracy.state() == Accuracy::State::measuring;
    const float width = ui.theme.px(124);
    if (measuring) {
        if (plainButton(ui, "Cancel", width)) cancelAccuracy(app);
    } else {
        ImGui::BeginDisabled(app.moves());
        const bool again = !accuracy.points().empty();
        const char* label = again ? "Measure again" : "Measure";
        if (accuracy.fresh() ? plainButton(ui, label, width) : primaryButton(ui, label, width))
            measureAccuracy(app);
        ImGui::EndDisabled();
        tip(ui, app.moves() ? "Hold the animation and the wind first."
                            : "Traces this view by rays and compares the live picture with it, in "
                              "the background.");
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_Text, accuracy.problem().empty() ? color::kDim : color::kBad);
    ImGui::TextUnformatted(stateText(accuracy).c_str());
    ImGui::PopStyleColor();
    if (measuring) {
        const float bottom = at.y + ImGui::GetFrameHeight(), all = ui.theme.px(190);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddRectFilled({at.x, bottom - 2}, {at.x + all, bottom},
                           ImGui::GetColorU32(color::kFrame));
        draw.AddRectFilled({at.x, bottom - 2}, {at.x + all * accuracy.done(), bottom},
                           ImGui::GetColorU32(color::kAccent));
    }
    const float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
    ImGui::SameLine(right - ui.theme.px(602));
    ImGui::Dummy({0, 0});
    drawChoices(app);
    ImGui::SameLine();
    ImGui::Checkbox("Automatic", &accuracy.automatic);
    tip(ui, "Measures a second after document or view have changed.");
    ImGui::SameLine(right - ui.theme.px(132));
    ImGui::BeginDisabled(accuracy.points().empty());
    if (plainButton(ui, "Save report...", ui.theme.px(102))) askForFile(app, Dialog::accuracy);
    ImGui::EndDisabled();
    tip(ui, "The figures as .csv, and the three pictures beside it.");
    ImGui::SameLine(right - ui.theme.px(24));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
    if (plainButton(ui, ui.theme.icons ? icon::kClose : "x", ui.theme.px(24))) toggleAccuracy(app);
    ImGui::PopStyleVar();
    tip(ui, "Close this panel.");
}

}  // namespace

void drawAccuracy(App& app, const Layout& layout) {
    if (layout.accuracy == 0.0f) return;
    const Theme& theme = app.theme;
    const float top = layout.window.y - layout.bottom();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(12), theme.px(7)});
    beginPanel("accuracy", {0, top}, {layout.window.x, layout.accuracy},
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRectFullScreen();
    draw.AddLine({0, top}, {layout.window.x, top}, ImGui::GetColorU32(color::kLine));
    draw.PopClipRect();
    drawHeader(app);
    const std::vector<AccuracyPoint>& points = app.accuracy.points();
    ImVec2 corner{theme.px(12), ImGui::GetCursorScreenPos().y + theme.px(4)};
    if (points.empty()) {
        ImGui::SetCursorScreenPos(corner);
        ImGui::TextDisabled(
            "How far is the picture from the truth, and what would it cost to come nearer?\n"
            "Each hair of this view is traced by rays at its true width, beside your work, and the "
            "live picture is held against it.");
        return ImGui::End();
    }
    const float height = layout.window.y - layout.status - theme.px(7) - corner.y;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, app.accuracy.fresh() ? 1.0f : 0.4f);
    ImGui::PushFont(theme.small);
    corner.x = drawPictures(app, corner, 0.38f * layout.window.x, height) + theme.px(16);
    const float width = theme.px(208), gap = theme.px(14);
    drawFigures(uiOf(app), corner, width, errorsOf(points.front()));
    corner.x += width + gap;
    drawFigures(uiOf(app), corner, width, costsOf(app, points.front()));
    corner.x += width + gap;
    drawCurves(app, corner, {layout.window.x - theme.px(12) - corner.x, height});
    ImGui::PopFont();
    ImGui::PopStyleVar();
    ImGui::End();
}

}  // namespace pelage
