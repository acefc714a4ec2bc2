// tool_icons.cpp -- five small drawings on a unit square, y down.
#include "app/tool_icons.h"

#include <array>
#include <cmath>

namespace pelage {
namespace {

struct Pen {
    ImDrawList& draw;
    ImVec2 corner;
    float side;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {corner.x + x * side, corner.y + y * side}; }
    float width() const { return 0.075f * side; }
    void line(float ax, float ay, float bx, float by) const {
        draw.AddLine(at(ax, ay), at(bx, by), color, width());
    }
    // A hair: from its root over a bend to the tip.
    void hair(float ax, float ay, float bx, float by, float cx, float cy) const {
        draw.AddBezierQuadratic(at(ax, ay), at(bx, by), at(cx, cy), color, width());
    }
    void dot(float x, float y) const { draw.AddCircleFilled(at(x, y), 0.06f * side, color); }
};

void lengthIcon(const Pen& pen) {
    pen.line(0.08f, 0.90f, 0.92f, 0.90f);
    pen.hair(0.20f, 0.88f, 0.18f, 0.70f, 0.28f, 0.58f);
    pen.hair(0.45f, 0.88f, 0.42f, 0.55f, 0.56f, 0.36f);
    pen.hair(0.70f, 0.88f, 0.66f, 0.40f, 0.86f, 0.10f);
}

void densityIcon(const Pen& pen) {
    constexpr std::array<vec2, 11> kDots{{{0.15f, 0.30f},
                                          {0.25f, 0.72f},
                                          {0.42f, 0.48f},
                                          {0.50f, 0.84f},
                                          {0.50f, 0.16f},
                                          {0.66f, 0.34f},
                                          {0.66f, 0.64f},
                                          {0.82f, 0.20f},
                                          {0.84f, 0.48f},
                                          {0.80f, 0.82f},
                                          {0.92f, 0.66f}}};
    for (const vec2 dot : kDots) pen.dot(dot.x, dot.y);
}

void combIcon(const Pen& pen) {
    pen.draw.AddRectFilled(pen.at(0.08f, 0.18f), pen.at(0.92f, 0.36f), pen.color, 0.07f * pen.side);
    for (int tooth = 0; tooth < 5; ++tooth) {
        const float x = 0.14f + 0.18f * static_cast<float>(tooth);
        pen.line(x, 0.34f, x, 0.84f);
    }
}

void smoothIcon(const Pen& pen) {
    for (int row = 0; row < 3; ++row) {
        const float y = 0.26f + 0.24f * static_cast<float>(row);
        const float swing = 0.15f * (1.0f - 0.45f * static_cast<float>(row));
        pen.draw.AddBezierCubic(pen.at(0.06f, y), pen.at(0.36f, y - 2.0f * swing),
                                pen.at(0.62f, y + 2.0f * swing), pen.at(0.94f, y), pen.color,
                                pen.width());
    }
}

void maskIcon(const Pen& pen) {
    constexpr float kPi = 3.14159265f;
    const ImVec2 center = pen.at(0.5f, 0.5f);
    const float radius = 0.38f * pen.side;
    pen.draw.AddCircle(center, radius, pen.color, 40, pen.width());
    pen.draw.PathArcTo(center, radius, 0.5f * kPi, 1.5f * kPi, 24);
    pen.draw.PathFillConvex(pen.color);
}

}  // namespace

void drawToolIcon(ImDrawList& draw, Tool tool, ImVec2 corner, float side, ImU32 color) {
    const Pen pen{draw, corner, side, color};
    switch (tool) {
        case Tool::length:
            return lengthIcon(pen);
        case Tool::density:
            return densityIcon(pen);
        case Tool::comb:
            return combIcon(pen);
        case Tool::smooth:
            return smoothIcon(pen);
        case Tool::mask:
            return maskIcon(pen);
    }
}

}  // namespace pelage
