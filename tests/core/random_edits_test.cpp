// random_edits_test.cpp -- whatever is done, undone and done again, the lines that remain say all.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/coat.h"
#include "core/script.h"
#include "core/text.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;

// A ball of 320 triangles with three segments.
Workspace onSegmentedBall() {
    Source source = test::ball(2);
    source.segments = {{"head", {0, 0, 1}, {0, 0.2f, 0.3f}},
                       {"left flank", {0.3f, 0, 0.3f}, {0.4f, 0, -1}},
                       {"right", {-0.3f, 0, 0.3f}, {-0.4f, 0, -1}}};
    for (const vec3 p : source.positions)
        source.segmentOf.push_back(p.z > 0.3f ? 0u : p.x > 0.0f ? 1u : 2u);
    Workspace workspace;
    workspace.open(openDocument(std::move(source)));
    return workspace;
}

std::string number(float value) { return ' ' + floatText(value); }

std::string numbers(vec3 v) { return number(v.x) + number(v.y) + number(v.z); }

template <std::size_t count>
std::string anyOf(Draws& draws, const char* const (&words)[count]) {
    return words[draws.below(count)];
}

Brush randomBrush(Draws& draws) {
    Brush brush;
    brush.tool = static_cast<Tool>(draws.below(kToolCount));
    brush.mode = static_cast<Mode>(draws.below(4));
    brush.falloff = static_cast<Falloff>(draws.below(4));
    brush.radius = draws.in(0.1f, 0.9f);
    brush.strength = draws.in(0.0f, 1.0f);
    brush.value = draws.in(0.0f, 1.0f);
    brush.factor = draws.in(0.0f, 2.0f);
    brush.color = 0.5f + draws.inBox(0.5f);
    if (brush.tool == Tool::segment) brush.segment = anyOf(draws, {"head", "left flank", "#2", ""});
    if (draws.below(3) == 0) brush.mirror = {draws.below(2), draws.below(2), draws.below(2)};
    brush.alongSurface = draws.below(4) > 0;
    brush.facingOnly = draws.below(4) > 0;
    return brush;
}

// By hand: its line, or none where it changed nothing or was given up.
std::string randomStroke(Workspace& workspace, Draws& draws) {
    vec3 at = glm::normalize(draws.inBox(1.0f) + vec3(0.0f, 0.01f, 0.0f));
    const bool pen = draws.below(3) == 0;
    const auto pressure = [&] { return pen ? draws.in(0.0f, 1.0f) : 1.0f; };
    workspace.press(randomBrush(draws), at, at, pressure());
    for (uint i = 0, moves = draws.below(5); i < moves; ++i) {
        at = glm::normalize(at + 0.4f * draws.inBox(1.0f));
        workspace.drag(at, at, pressure());
    }
    if (draws.below(20) > 0) return workspace.release();
    workspace.cancelStroke();
    return {};
}

std::string randomRegion(Draws& draws) {
    std::string where;
    switch (draws.below(6)) {
        case 0:
            where = "sphere" + numbers(draws.inBox(1.0f)) + " radius" + number(draws.in(0, 1));
            break;
        case 1:
            where = "box" + numbers(draws.inBox(1.0f)) + " half" +
                    numbers(draws.inBox(0.4f) + 0.5f) + " turn" + numbers(draws.inBox(2.0f));
            break;
        case 2:
            where = "segment " + anyOf(draws, {"head", "left%20flank", "2"});
            break;
        case 3:
            where = anyOf(draws, {"all", "mask"});
            break;
        case 4:
            where = "narrow" + number(draws.in(0.0f, 1.0f)) + " sizes";
            break;
        default:
            where = "curved" + number(draws.in(0.0f, 3.0f));
            break;
    }
    std::string act;
    switch (draws.below(4)) {
        case 0:
            act = "scale" + number(draws.in(0.0f, 2.0f));
            break;
        case 1:
            act = "set" + number(draws.in(0.0f, 1.0f));
            break;
        case 2:
            act = "smooth" + number(draws.in(0.0f, 1.0f));
            break;
        default:
            act = "randomise" + number(draws.in(0.0f, 1.0f)) + " seed " +
                  std::to_string(draws.below(99));
            break;
    }
    const std::string channel = anyOf(draws, {"length", "density", "direction"});
    if (channel == "direction" && act.starts_with("set")) act = "set" + numbers(draws.inBox(1.0f));
    return "region " + where + " falloff" + number(draws.in(0.0f, 0.5f)) + " : " + channel + ' ' +
           act;
}

std::string randomSet(const Fur& fur, Draws& draws) {
    std::string line = "set";
    for (uint i = 0, count = 1 + draws.below(3); i < count; ++i) {
        const std::span<const Parameter> rows = coatParameters();
        const Parameter& row = rows[draws.below(static_cast<uint>(rows.size()))];
        if (row.kind != ParameterKind::scalar) continue;
        line += anyOf(draws, {" over.", " under."}) + row.name +
                number(draws.in(row.least, std::min(row.greatest, 1000.0f)));
    }
    return line == "set" ? "set fur.seed " + std::to_string(fur.seed + 1) : line;
}

// A line that may or may not change something.
std::string randomLine(const Fur& fur, Draws& draws) {
    const uint kind = draws.below(20);
    if (kind < 6) {
        Brush brush = randomBrush(draws);
        while (toolInfo(brush.tool).needsPath) brush = randomBrush(draws);
        return floodLine(brush, draws.inBox(1.0f) + vec3(0.0f, 0.0f, 1.1f));
    }
    if (kind < 8) return std::string("reset ") + tools()[draws.below(kToolCount)].name;
    if (kind < 13) return randomRegion(draws);
    if (kind < 15) return randomSet(fur, draws);
    if (kind < 16)
        return "preset " + presets()[draws.below(static_cast<uint>(presets().size()))].name;
    if (kind < 17) return "comb head-to-tail weight" + number(draws.in(0.0f, 1.0f));
    return "segment " + anyOf(draws, {"head", "left%20flank", "right"}) +
           (draws.below(2) ? " axis" + numbers(draws.inBox(1.0f) + vec3(1.5f, 0, 0)) : "") +
           " weight" + number(draws.in(0.0f, 1.0f));
}

void expectSameBytes(const Document& a, const Document& b, std::string_view when) {
    ASSERT_TRUE(test::sameBits(a.groom, b.groom)) << when;
    for (std::size_t v = 0; v < a.groom.segmentOf.size(); ++v)
        ASSERT_EQ(a.groom.segmentOf[v], b.groom.segmentOf[v]) << when;
    EXPECT_EQ(a.fur, b.fur) << when;
}

TEST(RandomEdits, UndoAndRedoInBetweenLeaveTheBytesOfAStraightReplay) {
    constexpr int kEdits = 10000;
    Workspace workspace = onSegmentedBall();
    Editor& editor = *workspace.editor;
    Draws draws(2024);
    std::vector<std::string> lines;  // as the history has them
    std::size_t done = 0;            // of those, the rest can be redone
    std::size_t undone = 0, redone = 0, idle = 0;
    for (int i = 0; i < kEdits; ++i) {
        const uint kind = draws.below(16);
        if (kind < 3) {
            for (uint k = draws.below(4); k-- > 0 && !editor.undoLabel().empty(); ++undone) {
                runLine(workspace, "undo");
                --done;
            }
        } else if (kind < 5) {
            for (uint k = draws.below(4); k-- > 0 && !editor.redoLabel().empty(); ++redone) {
                runLine(workspace, "redo");
                ++done;
            }
        } else {
            editor.markSaved();
            std::string line;
            if (kind < 10) {
                line = randomStroke(workspace, draws);
            } else {
                line = randomLine(editor.document().fur, draws);
                runLine(workspace, line);
            }
            if (editor.saved()) {
                ++idle;
                continue;
            }
            lines.resize(done);
            lines.push_back(line);
            ++done;
        }
    }
    EXPECT_GT(undone, 1000u);
    EXPECT_GT(redone, 200u);
    EXPECT_LT(idle, 2500u);
    EXPECT_GT(done, 2500u);  // compilers draw in different orders

    Workspace straight = onSegmentedBall();
    for (std::size_t i = 0; i < done; ++i) runLine(straight, lines[i]);
    expectSameBytes(editor.document(), straight.editor->document(), "now");
    // The history itself, as far as it is kept.
    for (std::size_t i = 0; !editor.undoLabel().empty(); ++i) {
        runLine(workspace, "undo");
        ASSERT_TRUE(straight.editor->undo());
        if (i % 16 == 0) expectSameBytes(editor.document(), straight.editor->document(), lines[i]);
    }
}

}  // namespace
}  // namespace pelage
