// flood_test.cpp -- what a flood promises beyond a stroke.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;

// Metres over which a step in length, at x = 0 of a sheet, is spread by flooding with smooth: the
// hair that moved, as a share of the step.
double widthOfStep(uint cells) {
    Canvas canvas(test::sheet(cells));
    const auto& vertices = canvas.skin->vertices;
    for (uint v = 0; v < vertices.size(); ++v)
        canvas.groom.fur.edit(v).furLength = vertices[v].position.x < 0.0f ? 0.1f : 0.0f;
    Groom after = canvas.groom;
    flood(canvas.query, after, brushOf(Tool::smooth));
    double moved = 0.0;
    std::size_t count = 0;
    for (uint v = 0; v < vertices.size(); ++v) {
        if (std::abs(vertices[v].position.z) > 0.3f) continue;  // borders have fewer neighbours
        moved += std::abs(after.fur[v].furLength - canvas.groom.fur[v].furLength) / 0.1;
        ++count;
    }
    return moved / static_cast<double>(count);  // of a sheet of 1 m
}

TEST(Flood, SmoothSpreadsAStepAsWideOnAFinerMesh) {
    const double coarse = widthOfStep(40);
    EXPECT_GT(coarse, 0.01);
    EXPECT_NEAR(widthOfStep(80), coarse, 0.25 * coarse);
    EXPECT_NEAR(widthOfStep(160), coarse, 0.25 * coarse);
}

TEST(Flood, SmoothDoesNotMixTheSidesOfAThinSheet) {
    Canvas canvas(test::twoSheets(60, 0.004f));
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        canvas.groom.fur.edit(v).furLength =
            canvas.skin->vertices[v].position.y < 0.0f ? 0.1f : 0.3f;
    Groom after = canvas.groom;
    flood(canvas.query, after, brushOf(Tool::smooth));
    EXPECT_EQ(after, canvas.groom);
}

}  // namespace
}  // namespace pelage
