// stroke_tools_test.cpp -- what strokes of the tools that look at the path make of the field.
#include <gtest/gtest.h>

#include <cmath>

#include "canvas.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::straight;

// Hair along x on a sheet of side 1 m, and a stroke of radius 0.2 m along the x axis.
struct Lane : Canvas {
    Lane() : Canvas(test::sheet(40)) {
        for (uint v = 0; v < skin->vertices.size(); ++v) {
            groom.fur.edit(v).direction = vec3(0.5f, 0.0f, 0.0f);
            groom.fur.edit(v).furLength = 0.1f;
        }
    }
    Groom after(Tool tool, Mode mode) const {
        Brush brush = brushOf(tool, mode);
        brush.falloff = Falloff::constant;
        return painted(brush, straight({-0.4f, 0.0f, 0.0f}, {0.4f, 0.0f, 0.0f}, 5));
    }
    // Calls check(place, direction after) at the vertices that the stroke covers beside its path.
    template <class Check>
    void eachBeside(const Groom& groomAfter, Check check) const {
        std::size_t count = 0;
        for (uint v = 0; v < skin->vertices.size(); ++v) {
            const vec3 p = skin->vertices[v].position;
            if (std::abs(p.x) > 0.39f || std::abs(p.z) < 0.021f || std::abs(p.z) > 0.19f) continue;
            check(p, groomAfter.fur[v].direction);
            ++count;
        }
        EXPECT_GT(count, 300u);
    }
};

TEST(StrokeTools, PartLaysHairAcrossThePathAwayFromItOnBothSides) {
    const Lane lane;
    for (const Mode mode : {Mode::add, Mode::subtract}) {
        const float way = mode == Mode::add ? 1.0f : -1.0f;
        lane.eachBeside(lane.after(Tool::part, mode), [&](vec3 p, vec3 direction) {
            EXPECT_LT(glm::distance(direction, vec3(0.0f, 0.0f, way * std::copysign(1.0f, p.z))),
                      1e-5f);
        });
    }
}

TEST(StrokeTools, ClumpGathersTipsOverThePathAndKeepsTheHeadingAlongIt) {
    const Lane lane;
    for (const Mode mode : {Mode::add, Mode::subtract}) {
        const float way = mode == Mode::add ? -1.0f : 1.0f;
        lane.eachBeside(lane.after(Tool::clump, mode), [&](vec3 p, vec3 direction) {
            if (std::abs(p.z) > 0.08f) return;  // longer than the hair: leans in full
            EXPECT_LT(glm::distance(direction, vec3(0.5f, 0.0f, way * p.z / 0.1f)), 1e-5f);
        });
    }
}

TEST(StrokeTools, APartByASingleDabIsAWhorl) {
    const Lane lane;
    const Groom after = lane.painted(brushOf(Tool::part), {{0.0f, 0.0f, 0.0f}});
    for (uint v = 0; v < lane.skin->vertices.size(); ++v) {
        const vec3 p = lane.skin->vertices[v].position;
        const float distance = glm::length(p);
        if (distance < 0.021f || distance > 0.1f) continue;
        EXPECT_GT(glm::dot(after.fur[v].direction - lane.groom.fur[v].direction, p / distance),
                  0.0f);
    }
}

TEST(StrokeTools, TwistOfAMirroredStrokeTurnsTheOtherWayOnTheOtherSide) {
    const Lane lane;
    Brush brush = brushOf(Tool::twist);
    brush.mirror.x = true;
    const Groom after = lane.painted(brush, {{0.25f, 0.0f, 0.0f}});
    for (uint v = 0; v < lane.skin->vertices.size(); ++v) {
        const vec3 p = lane.skin->vertices[v].position;
        if (glm::distance(vec3(std::abs(p.x), p.y, p.z), vec3(0.25f, 0.0f, 0.0f)) > 0.1f) continue;
        EXPECT_LT(after.fur[v].direction.z * p.x, 0.0f);  // left of +x is -z
    }
}

}  // namespace
}  // namespace pelage
