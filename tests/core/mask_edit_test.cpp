// mask_edit_test.cpp -- what each operation makes of the mask, one step and one line each.
#include "core/mask_edit.h"

#include <gtest/gtest.h>

#include "bad_lines.h"
#include "canvas.h"

namespace pelage {
namespace {

using test::Canvas;

// The sheet with the mask painted where x < 0, half of it where x is 0.
Canvas halfMasked() {
    Canvas canvas(test::sheet(16));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const float x = canvas.skin->vertices[v].position.x;
        canvas.groom.mask.edit(v) = x < 0.0f ? 1.0f : x == 0.0f ? 0.5f : 0.0f;
    }
    return canvas;
}

Groom after(const Canvas& canvas, const MaskEdit& change) {
    Groom groom = canvas.groom;
    applyMaskEdit(canvas.query, groom, change);
    return groom;
}

Groom after(const Canvas& canvas, MaskAct act, int rings = 1) {
    return after(canvas, MaskEdit{act, rings, {}});
}

TEST(MaskEdit, InvertClearAndFill) {
    const Canvas canvas = halfMasked();
    const Groom inverted = after(canvas, MaskAct::invert), cleared = after(canvas, MaskAct::clear),
                filled = after(canvas, MaskAct::fill);
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        EXPECT_EQ(inverted.mask[v], 1.0f - canvas.groom.mask[v]);
        EXPECT_EQ(cleared.mask[v], 0.0f);
        EXPECT_EQ(filled.mask[v], 1.0f);
        EXPECT_EQ(inverted.fur[v], canvas.groom.fur[v]);
    }
}

TEST(MaskEdit, GrowAndShrinkMoveTheBorderByRings) {
    const Canvas canvas = halfMasked();
    const Groom grown = after(canvas, MaskAct::grow, 3), shrunk = after(canvas, MaskAct::shrink, 3);
    const float cell = 1.0f / 16.0f;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        const float x = canvas.skin->vertices[v].position.x;
        const float g = grown.mask[v], s = shrunk.mask[v];
        EXPECT_EQ(g, x < 2.5f * cell ? 1.0f : x < 3.5f * cell ? 0.5f : 0.0f) << x;
        EXPECT_EQ(s, x < -3.5f * cell ? 1.0f : x < -2.5f * cell ? 0.5f : 0.0f) << x;
    }
}

TEST(MaskEdit, SmoothSoftensTheBorderAndKeepsAnEvenMask) {
    const Canvas canvas = halfMasked();
    const Groom smooth = after(canvas, MaskAct::smooth, 4);
    std::size_t soft = 0;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        EXPECT_GE(smooth.mask[v], 0.0f);
        EXPECT_LE(smooth.mask[v], 1.0f);
        soft += smooth.mask[v] > 0.01f && smooth.mask[v] < 0.99f;
    }
    EXPECT_GT(soft, 17u * 4u);
    Canvas even(test::sheet(4));
    for (uint v = 0; v < even.skin->vertices.size(); ++v) even.groom.mask.edit(v) = 0.3f;
    EXPECT_EQ(after(even, MaskAct::smooth, 5), even.groom) << "not even a chunk is written";
}

TEST(MaskEdit, FromLengthAndDensity) {
    Canvas canvas(test::sheet(8));
    test::shuffle(canvas, 3);
    float longest = 0.0f;
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        longest = std::max(longest, canvas.groom.fur[v].furLength);
    const Groom length = after(canvas, MaskAct::length), density = after(canvas, MaskAct::density);
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        EXPECT_FLOAT_EQ(length.mask[v], canvas.groom.fur[v].furLength / longest);
        EXPECT_EQ(density.mask[v], canvas.groom.fur[v].density);
    }
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) canvas.groom.fur.edit(v) = kBareFur;
    EXPECT_EQ(after(canvas, MaskAct::length), canvas.groom) << "no hair, no mask";
}

TEST(MaskEdit, FromARegionIsItsWeights) {
    Canvas canvas(test::ball(3));
    MaskEdit change{MaskAct::region, 1, {}};
    change.region.where = Where::sphere;
    change.region.center = {1.0f, 0.0f, 0.0f};
    change.region.radius = 0.5f;
    change.region.falloff = 0.4f;
    const Groom groom = after(canvas, change);
    const std::vector<float> weights = regionWeights(canvas.query, canvas.groom, change.region);
    for (uint v = 0; v < weights.size(); ++v) EXPECT_EQ(groom.mask[v], weights[v]);
}

TEST(MaskEdit, RingsReachEquallyFarOnADenseMesh) {
    const Canvas coarse(test::sheet(8)), dense(test::sheet(400));
    EXPECT_EQ(ringsOf(*coarse.skin), 1);
    const float reach = static_cast<float>(ringsOf(*dense.skin)) / 400.0f;
    EXPECT_NEAR(reach, 0.01f * dense.skin->size(), 0.003f);
}

TEST(MaskEdit, EachLineIsOneStepThatUndoesAndReplays) {
    Workspace workspace;
    workspace.open(test::evenDocument(test::ball(3)));
    const Editor& editor = *workspace.editor;
    MaskEdit region{MaskAct::region, 1, {}};
    region.region.where = Where::box;
    region.region.half = {0.4f, 2.0f, 2.0f};
    region.region.falloff = 0.3f;
    const MaskEdit steps[] = {region,
                              {MaskAct::grow, 2, {}},
                              {MaskAct::smooth, 3, {}},
                              {MaskAct::shrink, 1, {}},
                              {MaskAct::invert, 1, {}},
                              {MaskAct::fill, 1, {}},
                              {MaskAct::density, 1, {}},
                              {MaskAct::length, 1, {}},
                              {MaskAct::clear, 1, {}}};
    std::size_t count = 0;
    for (const MaskEdit& change : steps) {
        const Groom before = editor.document().groom;
        Groom wanted = before;
        applyMaskEdit(*workspace.query, wanted, change);
        ASSERT_FALSE(test::equalValues(wanted, before)) << maskLine(change);
        runLine(workspace, maskLine(change));
        EXPECT_TRUE(test::equalValues(editor.document().groom, wanted)) << maskLine(change);
        EXPECT_EQ(editor.currentStep(), ++count);
        runLine(workspace, "undo");
        EXPECT_EQ(editor.document().groom, before);
        runLine(workspace, "redo");
    }
}

TEST(MaskEdit, RefusesInOneLineAndChangesNothing) {
    constexpr test::BadLine kBad[] = {
        {"mask", "it has invert"},
        {"mask length", "it has invert"},
        {"mask grow 0", "from 1 to 1000"},
        {"mask from", "there are all"},
        {"mask invert 2", "does not expect"},
        {"mask from segment none", "no body segments"},
        {"mask from grow", "there are all"},
        {"mask from all : length scale 2", "does not expect"},
    };
    test::expectRefused(kBad);
}

}  // namespace
}  // namespace pelage
