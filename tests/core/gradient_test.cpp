// gradient_test.cpp -- ramps along a line: their values, their mask, their line of script.
#include "core/gradient.h"

#include <gtest/gtest.h>

#include "bad_lines.h"
#include "canvas.h"

namespace pelage {
namespace {

using test::Canvas;

// Across the sheet from its left border to its right one, in x from -0.25 to 0.25.
Gradient across(Tool tool, float start, float end, bool between = false) {
    Gradient gradient;
    gradient.tool = tool;
    gradient.from = {-0.25f, 0.3f, 0.0f};  // away from the skin: what counts is the place along it
    gradient.to = {0.25f, 0.3f, 0.0f};
    gradient.start = vec3(start);
    gradient.end = vec3(end);
    gradient.between = between;
    return gradient;
}

Groom after(const Canvas& canvas, const Gradient& gradient) {
    Groom groom = canvas.groom;
    applyGradient(*canvas.skin, groom, gradient);
    return groom;
}

TEST(Gradient, ValueIsThatOfThePlaceAlongTheLine) {
    const Canvas canvas(test::sheet(16));
    const Groom length = after(canvas, across(Tool::length, 0.1f, 0.02f));
    const Groom density = after(canvas, across(Tool::density, 0.0f, 1.0f));
    const Groom mask = after(canvas, across(Tool::mask, 1.0f, 0.5f));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const float x = canvas.skin->vertices[v].position.x;
        const float t = glm::clamp((x + 0.25f) / 0.5f, 0.0f, 1.0f);
        EXPECT_NEAR(length.fur[v].furLength, 0.1f - 0.08f * t, 1e-6f);
        EXPECT_NEAR(density.fur[v].density, t, 1e-6f);
        EXPECT_NEAR(mask.mask[v], 1.0f - 0.5f * t, 1e-6f);
        EXPECT_EQ(length.fur[v].density, canvas.groom.fur[v].density) << "nothing else changes";
        EXPECT_EQ(mask.fur[v], canvas.groom.fur[v]);
    }
}

TEST(Gradient, TintMixesTheTwoColors) {
    const Canvas canvas(test::sheet(16));
    Gradient gradient = across(Tool::tint, 0.0f, 0.0f);
    gradient.start = {1.0f, 0.0f, 0.25f};
    gradient.end = {0.0f, 0.5f, 0.75f};
    const Groom groom = after(canvas, gradient);
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const float x = canvas.skin->vertices[v].position.x;
        const float t = glm::clamp((x + 0.25f) / 0.5f, 0.0f, 1.0f);
        EXPECT_LT(glm::distance(groom.fur[v].tint, glm::mix(gradient.start, gradient.end, t)),
                  1e-6f);
    }
}

TEST(Gradient, BetweenLeavesWhatLiesBeyondTheEnds) {
    const Canvas canvas(test::sheet(16));
    const Groom groom = after(canvas, across(Tool::length, 0.1f, 0.02f, true));
    std::size_t changed = 0, kept = 0;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const bool inside = std::abs(canvas.skin->vertices[v].position.x) <= 0.25f;
        if (!inside) {
            EXPECT_EQ(groom.fur[v], canvas.groom.fur[v]);
        }
        (groom.fur[v] == canvas.groom.fur[v] ? kept : changed) += 1;
    }
    EXPECT_GT(changed, 100u);
    EXPECT_GT(kept, 100u);
}

TEST(Gradient, MaskHoldsBack) {
    Canvas canvas(test::sheet(8));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        canvas.groom.mask.edit(v) = 0.5f * static_cast<float>(v % 3);
    const Groom groom = after(canvas, across(Tool::length, 0.1f, 0.1f));
    const Groom mask = after(canvas, across(Tool::mask, 0.25f, 0.25f));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const float held = canvas.groom.mask[v], old = canvas.groom.fur[v].furLength;
        EXPECT_NEAR(groom.fur[v].furLength, glm::mix(0.1f, old, held), 1e-7f);
        EXPECT_EQ(mask.mask[v], 0.25f) << "a gradient of the mask is not held back by it";
    }
}

TEST(Gradient, LengthIsThatInTheWorld) {
    const Canvas canvas(test::sheet(4, mat4(mat3(10.0f))));  // one mesh unit is 10 m
    Gradient gradient = across(Tool::length, 0.5f, 0.5f);
    const Groom groom = after(canvas, gradient);
    EXPECT_NEAR(groom.fur[0].furLength, 0.05f, 1e-7f);
}

TEST(Gradient, LineReplaysBitForBitAsOneStep) {
    test::Draws draws(5);
    for (const Tool tool : {Tool::length, Tool::density, Tool::mask, Tool::tint}) {
        Workspace workspace;
        workspace.open(test::evenDocument(test::ball(3)));
        Gradient gradient = across(tool, 0.0f, 0.0f, draws.below(2) == 1);
        gradient.from = draws.inBox(1.0f);
        gradient.to = draws.inBox(1.0f);
        gradient.start = 0.5f + draws.inBox(0.5f);
        gradient.end = 0.5f + draws.inBox(0.5f);
        const Groom before = workspace.editor->document().groom;
        Groom wanted = before;
        applyGradient(*workspace.editor->document().skin, wanted, gradient);
        runLine(workspace, gradientLine(gradient));
        EXPECT_TRUE(test::equalValues(workspace.editor->document().groom, wanted));
        EXPECT_FALSE(test::equalValues(before, wanted));
        EXPECT_EQ(workspace.editor->currentStep(), 1u);
        runLine(workspace, "undo");
        EXPECT_EQ(workspace.editor->document().groom, before);
    }
}

TEST(Gradient, RefusesInOneLineAndChangesNothing) {
    constexpr test::BadLine kBad[] = {
        {"gradient comb from 0 0 0 1 to 0 1 0 1", "comb has no gradient"},
        {"gradient length to 0 1 0 1", "expects from"},
        {"gradient length from 0 0 0 1", "expects to"},
        {"gradient length from 0 0 0 -1 to 0 1 0 1", "the value"},
        {"gradient density from 0 0 0 1 to 0 1 0 1.5", "from 0 to 1"},
        {"gradient tint from 0 0 0 1 to 0 1 0 1", "the value"},
        {"gradient mask from 0 0 0 1 to 0 1 0 1 2", "does not expect"},
        {"gradient mask from 1 0 0 1 to 1 0 0 0", "the same point"},
        {"gradient mask from nan 0 0 1 to 1 0 0 0", "the end of a gradient"},
    };
    test::expectRefused(kBad);
}

}  // namespace
}  // namespace pelage
