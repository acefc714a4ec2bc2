// shells_panel.cpp -- what fur in shells is cut from: hairs, a photograph with its histogram and
// layers, or a grey picture.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "app/panels/panels.h"
#include "core/srgb.h"

namespace pelage {
namespace {

using From = ShellRecipe::From;

// Of each region of color; Okabe and Ito, 2008.
constexpr Rgba kRegionColors[] = {{0.34f, 0.71f, 0.91f, 1.0f}, {0.84f, 0.37f, 0.0f, 1.0f}};

ImTextureID handle(unsigned texture) { return (ImTextureID) static_cast<std::intptr_t>(texture); }

std::string percent(std::size_t part, std::size_t all) {
    char text[32];
    std::snprintf(
        text, sizeof text, "%.1f %%",
        100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1)));
    return text;
}

// The photograph, its histogram below it, and in that a line for each threshold.
void drawHistogram(const Ui& ui, const PhotoLayers& layers) {
    const float width = ImGui::GetContentRegionAvail().x, height = ui.theme.px(72);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("histogram", {width, height});
    tip(ui,
        "Pixels by luminance, dark to bright. From each line on a layer holds what is as bright: "
        "the one to the right is the outermost.");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + width, corner.y + height};
    draw.AddRectFilled(corner, end, ImGui::GetColorU32(color::kBack), ui.theme.px(3));
    // A few tones may hold most of the pixels: their bars are cut off.
    std::array<std::size_t, 256> sorted = layers.histogram;
    std::ranges::nth_element(sorted, sorted.begin() + 251);
    const auto highest = static_cast<float>(std::max<std::size_t>(sorted[251], 1));
    for (std::size_t i = 0; i < 256; ++i) {
        const float share = std::min(static_cast<float>(layers.histogram[i]) / highest, 1.0f);
        const float left = corner.x + width * static_cast<float>(i) / 256.0f;
        draw.AddRectFilled({left, end.y - share * (height - ui.theme.px(4))},
                           {left + width / 256.0f, end.y}, ImGui::GetColorU32(color::kDim));
    }
    // One below the other, so that the lines of both regions can be told apart.
    const float part = height / static_cast<float>(layers.regions.size());
    for (std::size_t r = 0; r < layers.regions.size(); ++r) {
        ImVec4 ink = kRegionColors[r];
        ink.w = layers.layers > 32 ? 0.5f : 0.9f;
        for (const float threshold : layers.regions[r].thresholds) {
            const float x = corner.x + width * srgbFromLinear(threshold);
            const float top = corner.y + static_cast<float>(r) * part;
            draw.AddLine({x, top}, {x, top + part}, ImGui::GetColorU32(ink));
        }
    }
}

void drawPhoto(const Ui& ui, ShellChoice& choice) {
    const ShellTextures textures = texturesOf(choice);
    const ivec2 size = choice.layers.size;
    const float width = ImGui::GetContentRegionAvail().x, high = ui.theme.px(110);
    const float scale =
        std::min(width / static_cast<float>(size.x), high / static_cast<float>(size.y));
    const ImVec2 shown{scale * static_cast<float>(size.x), scale * static_cast<float>(size.y)};
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5f * (width - shown.x));
    ImGui::Image(handle(textures.photo), shown);
    drawHistogram(ui, choice.layers);
    for (const std::string& warning : choice.layers.warnings)
        ImGui::TextWrapped("%s", warning.c_str());
}

// The layers as small pictures, from the outermost; the pixels of all outside it are in each.
void drawLayers(const Ui& ui, ShellChoice& choice) {
    const ShellTextures textures = texturesOf(choice);
    const PhotoLayers& layers = choice.layers;
    std::size_t all = 0;
    for (const std::size_t count : layers.populations) all += count;
    const float width = ImGui::GetContentRegionAvail().x, gap = ui.theme.px(3);
    const int columns = layers.layers > 48 ? 12 : layers.layers > 24 ? 8 : 6;
    const float side =
        (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const ImVec2 first = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (int i = 0; i < layers.layers; ++i) {
        const ImVec2 corner{first.x + static_cast<float>(i % columns) * (side + gap),
                            first.y + static_cast<float>(i / columns) * (side + gap)};
        const ImVec2 end{corner.x + side, corner.y + side};
        ImGui::SetCursorScreenPos(corner);
        ImGui::PushID(i);
        ImGui::InvisibleButton("layer", {side, side});
        ImGui::PopID();
        draw.AddRectFilled(corner, end, ImGui::GetColorU32(color::kBack));
        const auto u = [&](int column) {
            return static_cast<float>(column) / static_cast<float>(textures.columns);
        };
        const auto v = [&](int row) {
            return static_cast<float>(row) / static_cast<float>(textures.rows);
        };
        const int column = i % textures.columns, row = i / textures.columns;
        draw.AddImage(handle(textures.layers), corner, end, {u(column), v(row)},
                      {u(column + 1), v(row + 1)}, IM_COL32_WHITE);
        if (!ImGui::IsItemHovered()) continue;
        draw.AddRect(corner, end, ImGui::GetColorU32(color::kAccent));
        ImGui::SetTooltip("Layer %d of %d adds %s of the pixels to those outside it", i + 1,
                          layers.layers,
                          percent(layers.populations[static_cast<std::size_t>(i)], all).c_str());
    }
}

// One number of a recipe.
void numberOf(const Ui& ui, const char* label, float& value, const Number& number) {
    if (const auto other = numberRow(ui, label, value, number)) value = *other;
}

// The same of a share, in percent; as it was, to the bit, where it is not edited.
void percentOf(const Ui& ui, const char* label, float& share, const Number& number) {
    if (const auto other = numberRow(ui, label, 100.0f * share, number)) share = 0.01f * *other;
}

void layerRows(const Ui& ui, ShellRecipe& recipe) {
    auto layers = static_cast<float>(recipe.photo.layers);
    numberOf(ui, "Layers", layers,
             {.least = 1,
              .greatest = static_cast<float>(kMostLayers),
              .fallback = 16,
              .format = "%.0f",
              .logarithmic = true,
              .help = "More layers are smoother from the side, and slower."});
    recipe.photo.layers = static_cast<int>(layers + 0.5f);
    percentOf(
        ui, "Spacing", recipe.gap,
        {.least = 1,
         .greatest = 100,
         .fallback = 100,
         .format = "%.0f %%",
         .help = "Between layers; at 100 % they fill the coat, with less the fur is flatter."});
}

void sizeRow(App& app, ShellRecipe& recipe) {
    const float size = app.skin().size();
    const LengthUnit unit = unitFor(size);
    const std::string format = numberFormat(unit);
    const float automatic = 0.2f * size * unit.perMetre;
    const float side = recipe.side > 0.0f ? recipe.side * unit.perMetre : automatic;
    if (const auto other = numberRow(uiOf(app), "Size", side,
                                     {.least = 0.01f * size * unit.perMetre,
                                      .greatest = size * unit.perMetre,
                                      .fallback = automatic,
                                      .format = format.c_str(),
                                      .logarithmic = true,
                                      .help = "Of the picture on the skin: its shorter side."}))
        recipe.side = *other / unit.perMetre;
}

void photoRows(const Ui& ui, PhotoOptions& photo) {
    percentOf(ui, "Darkest", photo.darkest,
              {.greatest = 49,
               .fallback = 1,
               .format = "%.1f %%",
               .help = "Share of the pixels that are darker than the tone of the last layer."});
    percentOf(ui, "Brightest", photo.brightest,
              {.least = 51,
               .greatest = 100,
               .fallback = 99,
               .format = "%.1f %%",
               .help = "Share of the pixels that are darker than the tone of the tips."});
    toggleRow(
        ui, "Two colors", &photo.twoColors,
        "Tells the two colors of a spotted or striped fur apart, and gives each its own range "
        "of tones: dark fur is then as high as light fur.");
}

void cutRows(const Ui& ui, ShellRecipe& recipe) {
    if (recipe.from == From::noise) {
        constexpr const char* kMasks[] = {"1", "3", "5", "7", "9"};
        rowLabel(ui, "Mask");
        if (const auto other = choiceRow(ui, "mask", kMasks, recipe.noise.mask / 2))
            recipe.noise.mask = 2 * *other + 1;
    }
    numberOf(
        ui, "Coverage", recipe.cut.coverage,
        {.least = 0.01f, .fallback = 0.5f, .format = "%.2f", .help = "Of the skin, at the root."});
    numberOf(ui, "Taper", recipe.cut.taper,
             {.fallback = 1.0f, .format = "%.2f", .help = "1 ends hairs in points."});
}

void drawFile(App& app, const ShellRecipe& recipe) {
    const std::string name = std::filesystem::path(recipe.file).filename().string();
    if (plainButton(uiOf(app), (name + "...").c_str(), ImGui::GetContentRegionAvail().x))
        askForShellPicture(app, recipe.from);
    tip(uiOf(app), "Takes another file, a PNG or a JPEG. It can also be dropped on the window.");
}

}  // namespace

void drawShells(App& app) {
    const Ui ui = uiOf(app);
    if (!section(ui, "Shells", false)) return;
    ImGui::PushID("shells");
    ShellChoices& shells = app.shells;
    constexpr const char* kCoats[] = {"Both", "Overcoat", "Undercoat"};
    if (const auto other = choiceRow(ui, "coat", kCoats, shells.shown)) shells.shown = *other;
    ShellChoice& choice = shells.coats[shells.shown == 2 ? 1 : 0];
    ShellRecipe recipe = choice.recipe;
    constexpr const char* kFrom[] = {"Hairs", "Photograph", "Grey picture", "Noise"};
    ImGui::SetNextItemWidth(-1);
    if (const auto other = choiceList(ui, "##from", kFrom, static_cast<int>(recipe.from))) {
        const auto from = static_cast<From>(*other);
        if (from == From::photo || from == From::picture)
            askForShellPicture(app, from);
        else
            recipe.from = from;
    }
    tip(ui, "What layers of fur are cut from. In a photograph what is bright lies high.");
    if (recipe.from != From::hairs) {
        if (recipe.from != From::noise) drawFile(app, recipe);
        if (recipe.from == From::photo && choice.layers.layers > 0) drawPhoto(ui, choice);
        layerRows(ui, recipe);
        if (recipe.from == From::photo)
            photoRows(ui, recipe.photo);
        else
            cutRows(ui, recipe);
        sizeRow(app, recipe);
        if (recipe.from == From::photo && choice.layers.layers > 0) drawLayers(ui, choice);
        ImGui::TextDisabled("%.0f KiB of texture; %d layers stored: %.0f KiB",
                            static_cast<double>(choice.picture.texture->bytes()) / 1024.0,
                            recipe.photo.layers,
                            static_cast<double>(choice.picture.texture->levels[0].size() *
                                                static_cast<std::size_t>(recipe.photo.layers)) /
                                256.0);
        const std::string halved = halvedText(*choice.picture.texture);
        if (!halved.empty()) ImGui::TextWrapped("%s", halved.c_str());
    }
    ImGui::PopID();
    if (!(recipe == choice.recipe)) chooseShells(app, recipe);
}

}  // namespace pelage
