// brush_table_test.cpp -- what the README's table of brushes says, brush by brush: its effect on
// the field, Ctrl, set, scale, the mask, Flood and Reset.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::equalValues;
using test::straight;

struct Values {
    FurVertex fur;
    float mask = 0.0f;
};

enum class Ctrl { opposite, same };

// What a brush does to a vertex beside a stroke along +x; greater where it did more.
struct Row {
    Tool tool;
    const char* paints;  // of: length, density, direction, tint, mask
    Ctrl ctrl;
    std::function<float(const Values& before, const Values& after)> effect;
};

constexpr vec3 kAway(0.0f, 0.0f, 1.0f);  // from the stroke, at the vertex

const std::vector<Row> kRows{
    {Tool::length, "l", Ctrl::opposite,
     [](auto& a, auto& b) { return b.fur.furLength - a.fur.furLength; }},
    {Tool::cut, "l", Ctrl::same,
     [](auto& a, auto& b) { return a.fur.furLength - b.fur.furLength; }},
    {Tool::density, "d", Ctrl::opposite,
     [](auto& a, auto& b) { return b.fur.density - a.fur.density; }},
    {Tool::comb, "v", Ctrl::opposite,
     [](auto& a, auto& b) { return b.fur.direction.x - a.fur.direction.x; }},
    {Tool::part, "v", Ctrl::opposite,
     [](auto& a, auto& b) { return glm::dot(b.fur.direction - a.fur.direction, kAway); }},
    {Tool::twist, "v", Ctrl::opposite,
     [](auto& a, auto& b) { return glm::cross(a.fur.direction, b.fur.direction).y; }},
    {Tool::clump, "v", Ctrl::opposite,
     [](auto& a, auto& b) { return glm::dot(a.fur.direction - b.fur.direction, kAway); }},
    {Tool::puff, "v", Ctrl::opposite,
     [](auto& a, auto& b) { return glm::length(a.fur.direction) - glm::length(b.fur.direction); }},
    {Tool::flatten, "v", Ctrl::opposite,
     [](auto& a, auto& b) { return glm::length(b.fur.direction) - glm::length(a.fur.direction); }},
    {Tool::smooth, "ldvt", Ctrl::same,
     [](auto& a, auto& b) { return a.fur.furLength - b.fur.furLength; }},
    {Tool::tint, "t", Ctrl::opposite, [](auto& a, auto& b) { return a.fur.tint.r - b.fur.tint.r; }},
    {Tool::mask, "m", Ctrl::opposite, [](auto& a, auto& b) { return b.mask - a.mask; }},
};

// A sheet on which one vertex beside the x axis has longer hair than the others.
struct Table : Canvas {
    uint there = 0;

    Table() : Canvas(test::sheet(30)) {
        std::vector<uint> found;
        query.within({0.0f, 0.0f, 1.0f / 15.0f}, 1e-4f, found);
        there = found.at(0);
        for (uint v = 0; v < skin->vertices.size(); ++v) {
            FurVertex& fur = groom.fur.edit(v);
            fur.direction = {0.3f, 0.2f, 0.1f};
            fur.furLength = v == there ? 0.3f : 0.2f;
            fur.density = 0.5f;
            fur.tint = vec3(0.9f, 0.5f, 0.5f);
            groom.mask.edit(v) = 0.0f;
        }
    }

    Values valuesOf(const Groom& of) const { return {of.fur[there], of.mask[there]}; }
    Groom stroke(const Brush& brush, const Groom& before) const {
        Groom after = before;
        Stroke stroke(query, before, brush);
        for (const vec3 p : straight({-0.3f, 0, 0}, {0.3f, 0, 0}, 6))
            stroke.dab(after, p, test::kUp);
        return after;
    }
    // Half masked for the mask tool, so that it works both ways.
    Groom start(Tool tool) const {
        Groom first = groom;
        for (uint v = 0; v < skin->vertices.size(); ++v)
            if (tool == Tool::mask) first.mask.edit(v) = 0.5f;
        return first;
    }
    Values after(const Brush& brush) const { return valuesOf(stroke(brush, start(brush.tool))); }
    float effect(const Row& row, Mode mode) const {
        return row.effect(valuesOf(start(row.tool)), after(brushOf(row.tool, mode, 0.2f, 0.5f)));
    }
};

TEST(BrushTable, HasARowForEachBrush) {
    // Segment stands last: there is nothing between two segments to tend to (body_test.cpp).
    ASSERT_EQ(kRows.size(), kToolCount - 1);
    for (std::size_t i = 0; i < kRows.size(); ++i) EXPECT_EQ(kRows[i].tool, tools()[i].tool);
    EXPECT_EQ(tools().back().tool, Tool::segment);
}

TEST(BrushTable, EachBrushDoesWhatItSaysAndWithCtrlTheOpposite) {
    const Table table;
    for (const Row& row : kRows) {
        SCOPED_TRACE(toolInfo(row.tool).name);
        const float with = table.effect(row, Mode::add);
        const float against = table.effect(row, Mode::subtract);
        EXPECT_GT(with, 0.01f);
        if (row.ctrl == Ctrl::opposite) {
            EXPECT_LT(against, -0.01f);
        } else {
            EXPECT_EQ(against, with);
        }
        EXPECT_EQ(toolInfo(row.tool).subtract != nullptr, row.ctrl == Ctrl::opposite);
    }
}

TEST(BrushTable, EachBrushPaintsItsChannelsAndNoOther) {
    const Table table;
    for (const Row& row : kRows) {
        SCOPED_TRACE(toolInfo(row.tool).name);
        const std::string paints = row.paints;
        const Values before = table.valuesOf(table.start(row.tool));
        const Values after = table.after(brushOf(row.tool));
        const auto has = [&](char channel) { return paints.find(channel) != std::string::npos; };
        if (!has('l')) {
            EXPECT_EQ(after.fur.furLength, before.fur.furLength);
        }
        if (!has('d')) {
            EXPECT_EQ(after.fur.density, before.fur.density);
        }
        if (!has('v')) {
            EXPECT_EQ(after.fur.direction, before.fur.direction);
        }
        if (!has('t')) {
            EXPECT_EQ(after.fur.tint, before.fur.tint);
        }
        if (!has('m')) {
            EXPECT_EQ(after.mask, before.mask);
        }
    }
}

TEST(BrushTable, SetReachesTheValueAndScaleMultipliesWhereTheyAreOffered) {
    const Table table;
    for (const Row& row : kRows) {
        SCOPED_TRACE(toolInfo(row.tool).name);
        const ToolInfo& info = toolInfo(row.tool);
        const auto painted = [&](const Values& values) {
            return row.tool == Tool::mask      ? values.mask
                   : row.tool == Tool::density ? values.fur.density
                                               : values.fur.furLength;
        };
        Brush brush = brushOf(row.tool, Mode::set);
        brush.falloff = Falloff::constant;
        brush.factor = 0.25f;
        const float before = painted(table.valuesOf(table.start(row.tool)));
        if (info.hasSet) {
            EXPECT_FLOAT_EQ(painted(table.after(brush)), brush.value);
        }
        brush.mode = Mode::scale;
        if (info.hasScale) {
            EXPECT_FLOAT_EQ(painted(table.after(brush)), 0.25f * before);
        }
        brush.strength = 0.5f;
        if (info.hasScale) {
            EXPECT_FLOAT_EQ(painted(table.after(brush)), 0.625f * before);
        }
        EXPECT_EQ(info.hasScale, row.tool == Tool::length || row.tool == Tool::density);
    }
}

TEST(BrushTable, TheMaskHoldsEachBrushBackByItsShare) {
    const Table table;
    for (const Row& row : kRows) {
        if (row.tool == Tool::mask) continue;
        SCOPED_TRACE(toolInfo(row.tool).name);
        const auto masked = [&](float share) {
            Groom before = table.groom;
            for (uint v = 0; v < table.skin->vertices.size(); ++v) before.mask.edit(v) = share;
            return table.valuesOf(table.stroke(brushOf(row.tool), before));
        };
        const Values before = table.valuesOf(table.groom), free = masked(0.0f), half = masked(0.5f);
        EXPECT_EQ(masked(1.0f).fur, before.fur);
        EXPECT_NEAR(half.fur.furLength, 0.5f * (before.fur.furLength + free.fur.furLength), 1e-6f);
        EXPECT_NEAR(half.fur.density, 0.5f * (before.fur.density + free.fur.density), 1e-6f);
        EXPECT_LT(
            glm::distance(half.fur.direction, 0.5f * (before.fur.direction + free.fur.direction)),
            1e-6f);
        EXPECT_LT(glm::distance(half.fur.tint, 0.5f * (before.fur.tint + free.fur.tint)), 1e-6f);
    }
}

TEST(BrushTable, FloodDoesTheSameEverywhereButWhatNeedsAStroke) {
    const Table table;
    for (const Row& row : kRows) {
        SCOPED_TRACE(toolInfo(row.tool).name);
        const Groom before = table.start(row.tool);
        Groom flooded = before;
        flood(table.query, flooded, brushOf(row.tool, Mode::add, 0.2f, 0.5f), {1, 0, 0});
        if (toolInfo(row.tool).needsPath) {
            EXPECT_EQ(flooded, before);
            continue;
        }
        EXPECT_GT(row.effect(table.valuesOf(before), table.valuesOf(flooded)), 0.01f);
        if (row.tool == Tool::smooth) continue;  // the field is even elsewhere
        for (uint v = 0; v < table.skin->vertices.size(); ++v)
            EXPECT_GT(
                row.effect({before.fur[v], before.mask[v]}, {flooded.fur[v], flooded.mask[v]}),
                0.01f);
    }
}

TEST(BrushTable, ResetBringsBackWhatEachBrushPainted) {
    const Table table;
    const Groom first = initialGroom(*table.skin);
    for (const Row& row : kRows) {
        SCOPED_TRACE(toolInfo(row.tool).name);
        Groom before = first;
        for (uint v = 0; v < table.skin->vertices.size(); v += 7)  // uneven, for smooth
            if (row.tool == Tool::smooth) before.fur.edit(v).furLength *= 2.0f;
        Brush brush = brushOf(row.tool, row.tool == Tool::density ? Mode::subtract : Mode::add);
        brush.value = 0.001f;
        Groom after = table.stroke(brush, before);
        EXPECT_FALSE(equalValues(after, before));
        reset(*table.skin, after, row.tool);
        EXPECT_TRUE(equalValues(after, first));
    }
}

}  // namespace
}  // namespace pelage
