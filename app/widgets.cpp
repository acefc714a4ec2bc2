// widgets.cpp -- the vocabulary of the panels.
#include "app/widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "app/session.h"

namespace pelage {
namespace {

constexpr float kLabelShare = 0.46f;  // of the width of a row
constexpr double kTipDelay = 0.6;     // s

// What artists type and see in a color field is display-encoded; what is stored is linear.
float displayed(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}
float linear(float shown) {
    return shown <= 0.04045f ? shown / 12.92f : std::pow((shown + 0.055f) / 1.055f, 2.4f);
}
vec3 linear(vec3 c) { return {linear(c.x), linear(c.y), linear(c.z)}; }

ImU32 packed(ImVec4 c) { return ImGui::ColorConvertFloat4ToU32(c); }

bool resetClicked() { return ImGui::IsItemClicked(ImGuiMouseButton_Right); }

std::optional<vec3> colorSwatch(Ui ui, const Parameter& row, vec3 value, vec3 fallback) {
    std::optional<vec3> changed;
    const vec3 shown = displayedColor(value);
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::ColorButton("##swatch", {shown.x, shown.y, shown.z, 1.0f},
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {width, ImGui::GetFrameHeight()}))
        ImGui::OpenPopup("picker");
    tip(ui, row.help, "Right click for the default");
    if (resetClicked()) changed = fallback;
    if (ImGui::BeginPopup("picker")) {
        ImGui::TextUnformatted(row.label);
        float edited[3] = {shown.x, shown.y, shown.z};
        ImGui::SetNextItemWidth(ui.theme.px(220));
        if (ImGui::ColorPicker3("##picker", edited,
                                ImGuiColorEditFlags_NoSidePreview |
                                    ImGuiColorEditFlags_PickerHueWheel |
                                    ImGuiColorEditFlags_NoLabel))
            changed = linear(vec3(edited[0], edited[1], edited[2]));
        ImGui::EndPopup();
    }
    return changed;
}

// The whole numbers from which random choices are made: one more gives another animal.
std::optional<vec3> seedRow(Ui ui, const Parameter& row, vec3 value) {
    rowLabel(ui, row.label);
    constexpr float kLargestExact = 16777215.0f;  // that a float can count to
    int edited = static_cast<int>(std::min(value.x, kLargestExact));
    const bool changed = ImGui::InputInt("##seed", &edited, 1, 100);
    tip(ui, row.help);
    if (!changed) return std::nullopt;
    return vec3(static_cast<float>(std::max(edited, 0)), 0.0f, 0.0f);
}

// Lengths are shown in the unit that suits the animal, and a bar over lengths that suit it.
std::optional<vec3> lengthRow(Ui ui, const Parameter& row, vec3 value, vec3 fallback, float size) {
    const LengthUnit unit = unitFor(0.1f * size);
    char format[24];
    std::snprintf(format, sizeof format, value.x > 0.0f ? "%%.3f %s" : "automatic", unit.name);
    const Number number{.least = row.least,
                        .greatest = std::min(row.greatest, 0.02f * size) * unit.perMetre,
                        .fallback = fallback.x * unit.perMetre,
                        .format = format,
                        .help = row.help,
                        .unit = unit.name};
    const auto edited = numberRow(ui, row.label, value.x * unit.perMetre, number);
    if (!edited) return std::nullopt;
    return vec3(*edited / unit.perMetre, 0.0f, 0.0f);
}

}  // namespace

vec3 displayedColor(vec3 color) {
    return {displayed(color.x), displayed(color.y), displayed(color.z)};
}

void beginTips(Tips& tips) {
    if (!tips.seen) tips.over = nullptr;
    tips.seen = false;
    tips.wakeAt = 0.0;
}

void tip(Ui ui, const char* text, const char* detail) {
    if (!*text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    Tips& tips = ui.tips;
    const double now = ImGui::GetTime();
    if (tips.over != text || ImGui::IsAnyMouseDown()) tips.since = now;
    tips.over = text;
    tips.seen = true;
    if (now - tips.since < kTipDelay) {
        tips.wakeAt = tips.since + kTipDelay;
        return;
    }
    // Its first frame is spent on its size, and nothing else may ask for the ones that show it.
    if (now - tips.since - kTipDelay < 2.0 * static_cast<double>(ImGui::GetIO().DeltaTime))
        tips.wakeAt = now;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);  // what it is about may be grey
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ui.theme.px(280));
    ImGui::TextUnformatted(text);
    if (*detail) {
        ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
        ImGui::TextUnformatted(detail);
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

bool section(Ui ui, const char* label, bool open) {
    ImGui::PushFont(ui.theme.strong);
    ImGui::PushStyleColor(ImGuiCol_Header, color::kRaised);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.theme.px(6), ui.theme.px(5)});
    const bool shown = ImGui::CollapsingHeader(
        label, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    return shown;
}

void caption(Ui ui, const char* text) {
    ImGui::Dummy({0, ui.theme.px(2)});
    ImGui::PushFont(ui.theme.small);
    ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void rowLabel(Ui, const char* label) {
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width * kLabelShare);
    ImGui::SetNextItemWidth(width * (1.0f - kLabelShare));
}

std::optional<float> numberBar(Ui ui, const char* id, float value, const Number& number) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::CalcItemWidth(), ImGui::GetFrameHeight()};
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    // Find where in the bar the value stands.
    const float floorOfLog = std::max(number.least, number.greatest * 1e-4f);
    float share = (value - number.least) / (number.greatest - number.least);
    if (number.logarithmic)
        share = std::log(std::max(value, floorOfLog) / floorOfLog) /
                std::log(number.greatest / floorOfLog);
    share = std::clamp(share, 0.0f, 1.0f);

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    const ImVec4 dim{1, 1, 1, ImGui::GetStyle().Alpha};
    const auto tinted = [&](ImVec4 c) { return packed({c.x, c.y, c.z, c.w * dim.w}); };
    draw.AddRectFilled(corner, end, tinted(color::kFrame), rounding);
    draw.PushClipRect(corner, {corner.x + size.x * share, end.y}, true);
    draw.AddRectFilled(corner, end, tinted(color::kAccentDeep), rounding);
    draw.PopClipRect();

    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, ImVec4(1, 1, 1, 0.06f));
    ImGui::PushStyleColor(ImGuiCol_FrameBgActive, ImVec4(1, 1, 1, 0.09f));
    ImGui::SetNextItemWidth(size.x);
    float edited = value;
    constexpr ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    // The bar's end follows the pointer: the derivative of the value by its place in the bar.
    const float perShare =
        number.logarithmic ? std::max(value, floorOfLog) * std::log(number.greatest / floorOfLog)
                           : number.greatest - number.least;
    const bool moved = ImGui::DragFloat(id, &edited, perShare / size.x, number.least,
                                        number.greatest, number.format, flags);
    ImGui::PopStyleColor(3);
    const bool reset = resetClicked();
    const std::string detail = std::string(number.unit) + (*number.unit ? "\n" : "") +
                               "Double click to type, right click for the default";
    tip(ui, number.help, detail.c_str());
    if (reset) return number.fallback;
    if (moved && edited != value) return edited;
    return std::nullopt;
}

std::optional<float> numberRow(Ui ui, const char* label, float value, const Number& number) {
    ImGui::PushID(label);
    rowLabel(ui, label);
    const auto edited = numberBar(ui, "##value", value, number);
    ImGui::PopID();
    return edited;
}

std::optional<vec3> parameterRow(Ui ui, const Parameter& row, vec3 value, vec3 fallback,
                                 float size) {
    std::optional<vec3> changed;
    ImGui::PushID(row.name);
    if (row.kind == ParameterKind::color) {
        rowLabel(ui, row.label);
        changed = colorSwatch(ui, row, value, fallback);
    } else if (row.kind == ParameterKind::direction) {
        rowLabel(ui, row.label);
        float edited[3] = {value.x, value.y, value.z};
        if (ImGui::DragFloat3("##direction", edited, 0.01f, row.least, row.greatest, "%.2f"))
            changed = vec3(edited[0], edited[1], edited[2]);
        tip(ui, row.help, row.unit);
        if (resetClicked()) changed = fallback;
    } else if (row.kind == ParameterKind::choice) {
        rowLabel(ui, row.label);
        if (const auto chosen = choiceList(ui, "##choice", row.choices, static_cast<int>(value.x)))
            changed = vec3(static_cast<float>(*chosen), 0.0f, 0.0f);
        tip(ui, row.help);
    } else if (row.unit == std::string_view("m")) {
        changed = lengthRow(ui, row, value, fallback, size);
    } else if (row.kind == ParameterKind::count && row.greatest > 1e9f) {
        changed = seedRow(ui, row, value);
    } else {
        const bool count = row.kind == ParameterKind::count;
        const std::string whole = grouped(static_cast<std::size_t>(std::max(value.x, 0.0f)));
        const Number number{.least = row.least,
                            .greatest = row.greatest,
                            .fallback = fallback.x,
                            .format = count                 ? whole.c_str()
                                      : row.greatest > 4.0f ? "%.1f"
                                                            : "%.3f",
                            .logarithmic = row.greatest >= 256.0f,
                            .help = row.help,
                            .unit = row.unit};
        if (const auto edited = numberRow(ui, row.label, value.x, number))
            changed = vec3(count ? std::round(*edited) : *edited, 0.0f, 0.0f);
    }
    ImGui::PopID();
    return changed;
}

bool toggleRow(Ui ui, const char* label, bool* on, const char* help) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.theme.px(2), ui.theme.px(2)});
    const bool changed = ImGui::Checkbox(label, on);
    ImGui::PopStyleVar();
    tip(ui, help);
    return changed;
}

std::optional<int> choiceRow(Ui ui, const char* id, std::span<const char* const> labels,
                             int chosen) {
    std::optional<int> clicked;
    const float gap = ui.theme.px(2);
    const float count = static_cast<float>(labels.size());
    const float all = ImGui::GetContentRegionAvail().x - gap * (count - 1.0f);
    float longest = 0.0f, sum = 0.0f;  // of the labels
    for (const char* label : labels) {
        const float text = ImGui::CalcTextSize(label).x;
        longest = std::max(longest, text);
        sum += text;
    }
    const bool equal = longest <= all / count;
    ImGui::PushID(id);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, ImGui::GetStyle().ItemSpacing.y});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
    for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
        if (i > 0) ImGui::SameLine();
        const bool on = i == chosen;
        if (on) ImGui::PushStyleColor(ImGuiCol_Button, color::kAccentDeep);
        if (on) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, color::kAccentDeep);
        const char* label = labels[static_cast<std::size_t>(i)];
        const float width =
            equal ? all / count : ImGui::CalcTextSize(label).x + (all - sum) / count;
        if (ImGui::Button(label, {width, 0}) && !on) clicked = i;
        if (on) ImGui::PopStyleColor(2);
    }
    ImGui::PopStyleVar(2);
    ImGui::PopID();
    return clicked;
}

std::optional<int> choiceList(Ui, const char* id, std::span<const char* const> labels, int chosen) {
    std::optional<int> clicked;
    if (!ImGui::BeginCombo(id, labels[static_cast<std::size_t>(chosen)])) return clicked;
    for (int i = 0; i < static_cast<int>(labels.size()); ++i)
        if (ImGui::Selectable(labels[static_cast<std::size_t>(i)], i == chosen)) clicked = i;
    ImGui::EndCombo();
    return clicked;
}

bool primaryButton(Ui ui, const char* label, float width) {
    ImGui::PushStyleColor(ImGuiCol_Button, color::kAccent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(0.93f, 0.62f, 0.35f, 1.0f));
    ImGui::PushStyleColor(ImGuiCol_Text, color::kBack);
    ImGui::PushFont(ui.theme.strong);
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::PopFont();
    ImGui::PopStyleColor(3);
    return pressed;
}

bool plainButton(Ui, const char* label, float width) { return ImGui::Button(label, {width, 0}); }

bool iconButton(Ui ui, const char* glyph, const char* label, bool on, bool enabled) {
    const float side = ui.theme.px(30);
    const char* shown = ui.theme.icons && *glyph ? glyph : label;
    const float width = shown == glyph ? side : 0.0f;
    ImGui::PushID(label);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? color::kAccentDeep : ImVec4(0, 0, 0, 0));
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(shown, {width, side});
    ImGui::EndDisabled();
    ImGui::PopStyleColor();
    ImGui::PopID();
    return pressed;
}

std::string grouped(std::size_t number) {
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
}

}  // namespace pelage
