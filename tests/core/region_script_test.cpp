// region_script_test.cpp -- regions as lines of script.
#include <gtest/gtest.h>

#include "canvas.h"
#include "core/region_text.h"
#include "core/script.h"
#include "core/script_text.h"
#include "reading.h"
#include "regions.h"

namespace pelage {
namespace {

using test::Draws;
using test::edit;
using test::regionOf;
using test::segmentedBall;
using test::viewFromFront;

Region randomRegion(Draws& draws) {
    Region region = regionOf(static_cast<Where>(draws.below(8)));
    const auto number = [&] { return draws.in(0.0f, 1.5f); };
    region.falloff = draws.below(2) ? number() : 0.0f;
    region.sizes = draws.below(2);
    switch (region.where) {
        case Where::box:
            region.half = {number(), number(), number()};
            if (draws.below(2)) region.turn = draws.inBox(3.0f);
            [[fallthrough]];
        case Where::sphere:
            region.center = draws.inBox(1.0f);
            if (region.where == Where::sphere) region.radius = number();
            break;
        case Where::segment:
            region.segment = draws.below(2) ? "left ear" : "head";
            break;
        case Where::narrow:
            region.width = number();
            break;
        case Where::curved:
            region.curvature = number();
            break;
        case Where::lasso:
            region.viewProjection = viewFromFront();
            region.eye = {0.0f, 0.0f, 5.0f};
            for (uint i = 0, n = 2 + draws.below(9); i < n; ++i)
                region.polygon.push_back(vec2(draws.inBox(1.0f)));
            break;
        default:
            break;
    }
    return region;
}

RegionEdit randomEdit(Draws& draws) {
    constexpr Channel kChannels[] = {Channel::length, Channel::density, Channel::direction};
    RegionEdit change = edit(kChannels[draws.below(3)], static_cast<RegionAct>(draws.below(4)),
                             draws.in(0.0f, 1.0f));
    if (change.act == RegionAct::randomise) change.seed = draws.below(0xffffffffu);
    if (change.act == RegionAct::set && change.channel == Channel::direction) {
        change.value = 1.0f;
        change.direction = draws.inBox(1.0f);
    }
    return change;
}

Workspace onSegmentedBall() {
    Workspace workspace;
    Document document = test::evenDocument(segmentedBall());
    for (uint v = 0; v < document.groom.mask.size(); v += 3) document.groom.mask.edit(v) = 0.6f;
    workspace.open(std::move(document));
    return workspace;
}

TEST(RegionScript, LineReadsBackBitForBit) {
    Draws draws(21);
    for (int i = 0; i < 500; ++i) {
        const Region region = randomRegion(draws);
        const RegionEdit change = randomEdit(draws);
        const std::string line = regionLine(region, change);
        Words words(line);
        ASSERT_EQ(words.next(), "region");
        const RegionWords read = regionFromWords(words);
        EXPECT_TRUE(words.done()) << line;
        EXPECT_EQ(read.region, region) << line;
        EXPECT_EQ(read.change, change) << line;
        EXPECT_EQ(regionLine(read.region, read.change), line);
    }
}

TEST(RegionScript, EachLineIsOneStepThatUndoesExactly) {
    Draws draws(22);
    Workspace workspace = onSegmentedBall();
    Editor& editor = *workspace.editor;
    int steps = 0;
    for (int i = 0; i < 60; ++i) {
        const Document before = editor.document();
        const std::size_t step = editor.currentStep();
        const Region region = randomRegion(draws);
        const RegionEdit change = randomEdit(draws);
        Groom expected = before.groom;
        applyRegion(*workspace.query, expected, region, change);
        runLine(workspace, regionLine(region, change));
        EXPECT_TRUE(test::equalValues(editor.document().groom, expected));
        if (editor.currentStep() == step) continue;
        ++steps;
        ASSERT_EQ(editor.currentStep(), step + 1);
        runLine(workspace, "undo");
        ASSERT_EQ(editor.document(), before);
        runLine(workspace, "redo");
    }
    EXPECT_GT(steps, 20);
}

TEST(RegionScript, LinesOfTheManualWork) {
    Workspace workspace = onSegmentedBall();
    for (const char* line :
         {"region sphere 0 0.9 0 radius 0.4 falloff 0.05 : length scale 0.5",
          "region narrow 2.1 : length set 0.005",
          "region segment head : density randomise 0.3 seed 4",
          "region segment left%20ear falloff 0.1 : direction set 0 -1 0",
          "region curved 0.1 falloff 0.05 sizes : length smooth",
          "region box 0 0 0 half 1 1 0.2 turn 0 0.5 0 : direction scale 0.5",
          "region all : direction randomise 0.1", "region mask : density set 0.3"}) {
        const std::size_t step = workspace.editor->currentStep();
        runLine(workspace, line);
        EXPECT_TRUE(workspace.editor->currentStep() == step + 1 ||
                    std::string_view(line).find("smooth") != std::string_view::npos)
            << line;
    }
    EXPECT_EQ(workspace.editor->undoLabel(), "Region mask: density set");
}

TEST(RegionScript, WhatIsWrongIsNamedAndChangesNothing) {
    Workspace workspace = onSegmentedBall();
    const Document before = workspace.editor->document();
    const std::pair<const char*, const char*> lines[] = {
        {"region", "no region \"\""},
        {"region cone 1 2 3 : length scale 1", "\"cone\""},
        {"region sphere 0 0 radius 1 : length scale 1", "\"radius\""},
        {"region sphere 0 0 0 radius -1 : length scale 1", "\"-1\""},
        {"region sphere 0 0 0 radius nan : length scale 1", "\"nan\""},
        {"region all length scale 1", "\"length\""},
        {"region all", "no :"},
        {"region all : tail scale 1", "\"tail\""},
        {"region all : length cut 1", "\"cut\""},
        {"region all : length scale", "\"\""},
        {"region all : density set 1.5", "\"1.5\""},
        {"region all : direction set 1 0", "\"\""},
        {"region all : length randomise 0.5 seed -4", "\"-4\""},
        {"region all : length scale 0.5 twice", "\"twice\""},
        {"region segment tail : length scale 0.5", "\"tail\""},
        {"region segment a%2 : length scale 0.5", "%2"},
        {"region lasso view 1 2 3 : length scale 0.5", "\":\""},
        {"region lasso view 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 points 1 : length scale 1", "\":\""},
    };
    for (const auto& [line, named] : lines) {
        const std::string problem = test::refusal([&, text = line] { runLine(workspace, text); });
        EXPECT_NE(problem.find("region: "), std::string::npos) << line;
        EXPECT_NE(problem.find(named), std::string::npos) << line << '\n' << problem;
        EXPECT_EQ(workspace.editor->document(), before) << line;
    }
}

}  // namespace
}  // namespace pelage
