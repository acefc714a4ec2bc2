// tool_icons.cpp -- small drawings on a unit square, y down.
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

// Hairs up to a line, and scraps above it.
void cutIcon(const Pen& pen) {
    pen.line(0.08f, 0.90f, 0.92f, 0.90f);
    for (const float x : {0.22f, 0.50f, 0.78f}) {
        pen.line(x, 0.88f, x, 0.54f);
        pen.line(x + 0.03f, 0.30f, x + 0.08f, 0.12f);
    }
    pen.line(0.06f, 0.42f, 0.94f, 0.42f);
}

void partIcon(const Pen& pen) {
    pen.line(0.5f, 0.08f, 0.5f, 0.92f);
    for (const float y : {0.30f, 0.55f, 0.80f}) {
        pen.hair(0.42f, y, 0.28f, y - 0.18f, 0.08f, y);
        pen.hair(0.58f, y, 0.72f, y - 0.18f, 0.92f, y);
    }
}

void twistIcon(const Pen& pen) {
    constexpr float kPi = 3.14159265f;
    pen.draw.PathArcTo(pen.at(0.5f, 0.5f), 0.36f * pen.side, -0.4f * kPi, 1.2f * kPi, 32);
    pen.draw.PathStroke(pen.color, 0, pen.width());
    pen.line(0.61f, 0.16f, 0.82f, 0.08f);
    pen.line(0.61f, 0.16f, 0.76f, 0.34f);
    pen.dot(0.5f, 0.5f);
}

void clumpIcon(const Pen& pen) {
    pen.line(0.08f, 0.90f, 0.92f, 0.90f);
    for (const float x : {0.14f, 0.32f, 0.50f, 0.68f, 0.86f})
        pen.hair(x, 0.88f, x, 0.45f, 0.5f, 0.10f);
}

void puffIcon(const Pen& pen) {
    pen.line(0.08f, 0.90f, 0.92f, 0.90f);
    for (const float x : {0.18f, 0.39f, 0.61f, 0.82f}) pen.line(x, 0.88f, x, 0.16f);
}

void flattenIcon(const Pen& pen) {
    pen.line(0.08f, 0.90f, 0.92f, 0.90f);
    for (const float x : {0.12f, 0.34f, 0.56f})
        pen.hair(x, 0.86f, x + 0.06f, 0.62f, x + 0.36f, 0.62f);
}

// A drop.
void tintIcon(const Pen& pen) {
    constexpr float kPi = 3.14159265f;
    pen.draw.PathArcTo(pen.at(0.5f, 0.62f), 0.28f * pen.side, -0.12f * kPi, 1.12f * kPi, 28);
    pen.draw.PathLineTo(pen.at(0.5f, 0.08f));
    pen.draw.PathFillConvex(pen.color);
}

void maskIcon(const Pen& pen) {
    constexpr float kPi = 3.14159265f;
    const ImVec2 center = pen.at(0.5f, 0.5f);
    const float radius = 0.38f * pen.side;
    pen.draw.AddCircle(center, radius, pen.color, 40, pen.width());
    pen.draw.PathArcTo(center, radius, 0.5f * kPi, 1.5f * kPi, 24);
    pen.draw.PathFillConvex(pen.color);
}

// Two pieces of a limb, one of them filled.
void segmentIcon(const Pen& pen) {
    pen.draw.AddRectFilled(pen.at(0.10f, 0.10f), pen.at(0.48f, 0.90f), pen.color, 0.16f * pen.side);
    pen.draw.AddRect(pen.at(0.56f, 0.10f), pen.at(0.92f, 0.90f), pen.color, 0.16f * pen.side, 0,
                     pen.width());
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
        case Tool::cut:
            return cutIcon(pen);
        case Tool::part:
            return partIcon(pen);
        case Tool::twist:
            return twistIcon(pen);
        case Tool::clump:
            return clumpIcon(pen);
        case Tool::puff:
            return puffIcon(pen);
        case Tool::flatten:
            return flattenIcon(pen);
        case Tool::tint:
            return tintIcon(pen);
        case Tool::mask:
            return maskIcon(pen);
        case Tool::segment:
            return segmentIcon(pen);
    }
}

}  // namespace pelage
