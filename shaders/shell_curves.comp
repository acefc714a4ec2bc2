// shell_curves.comp -- the mean hair of both coats at each vertex of the skin, for shells to cut.
//
// A hair is taken as the parabola through its root, middle and tip: t(1-t) a + t^2 b over its root,
// which the paper's hair is, and a rod nearly.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"
#include "curvature.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 8) writeonly buffer ShellVertices { ShellVertex shellVertices[]; };


struct Curve {
    vec3 a, b;
};

vec3 curveAt(Curve c, float t) { return t * ((1.0 - t) * c.a + t * c.b); }

// m, from the root.
Curve meanCurve(Coat coat, SkinVertex skin, vec3 n, FurVertex painted) {
    coat.endRandomness = 0.0;  // how far single hairs stray from it is up to who draws them
    float furLength = sanitizedLength(sanitizedLength(painted.furLength) * coat.relativeLength);
    Strand s = bendStrand(vec3(0.0), n, painted.direction, furLength, coat, 0u,
                          pullAt(fur, skin.position, frame.seconds));
    vec3 tip = spinePoint(s, 1.0);
    return Curve(4.0 * spinePoint(s, 0.5) - tip, tip);
}

// The ball that the skin is along a hair.
struct Ball {
    vec3 n;      // unit, normal at the root
    float bend;  // 1/m, curvature
};

// Way on the ball from the root to below a place, and as its part along the normal the height there.
vec3 overBall(Ball ball, vec3 place) {
    float z = dot(place, ball.n);
    vec3 o = place - z * ball.n;
    float u = max(1.0 + ball.bend * z, 0.25);
    float square = dot(o, o);
    float x2 = ball.bend * ball.bend * square / (u * u);
    float height = (z * (2.0 + ball.bend * z) + ball.bend * square) / (1.0 + u * sqrt(1.0 + x2));
    return o / (u * (1.0 + 0.28 * x2)) + max(height, 0.0) * ball.n;
}

// v by the turn that takes one unit vector to another.
vec3 turned(vec3 v, vec3 from, vec3 to) {
    vec3 middle = from + to;
    return v - (dot(v, middle) / max(1.0 + dot(from, to), 1e-3)) * middle +
           (2.0 * dot(v, from)) * to;
}

Ball ballAlong(uint v, vec3 n, Curve c) {
    vec3 o = c.b - dot(c.b, n) * n;
    float square = dot(o, o);
    float reach = max(sqrt(dot(c.b, c.b)), 1e-12);
    float bend = square > 1e-6 * reach * reach ? curvatureAlong(curvatures[v], o) / square : 0.0;
    return Ball(n, clamp(bend, -0.15 / reach, 0.5 / reach));
}

Curve bent(Ball ball, Curve c) {
    vec3 tip = overBall(ball, c.b);
    return Curve(4.0 * overBall(ball, curveAt(c, 0.5)) - tip, tip);
}

float peakOf(Curve c, vec3 n) {
    float a = dot(c.a, n);
    float b = dot(c.b, n);
    return a > 2.0 * b ? 0.5 * a / (a - b) : 1.0;
}

void main() {
    uint v = gl_GlobalInvocationID.x + 64u * 65535u * gl_GlobalInvocationID.y;
    if (v >= uint(skinVertices.length())) return;
    vec3 n = safeUnit(skinVertices[v].normal, vec3(0.0, 1.0, 0.0));
    Curve straightOver = meanCurve(fur.over, skinVertices[v], n, furVertices[v]);
    Curve straightUnder = meanCurve(fur.under, skinVertices[v], n, furVertices[v]);
    Ball overBall = ballAlong(v, n, straightOver);
    Ball underBall = ballAlong(v, n, straightUnder);
    Curve over = bent(overBall, straightOver);
    Curve under = bent(underBall, straightUnder);
    if ((shellCoats & 1u) == 0u) over = Curve(vec3(0.0), vec3(0.0));
    if ((shellCoats & 2u) == 0u) under = Curve(vec3(0.0), vec3(0.0));
    float overPeak = peakOf(over, n);
    float underPeak = peakOf(under, n);
    float overTop = dot(curveAt(over, overPeak), n);
    float underTop = dot(curveAt(under, underPeak), n);

    ShellVertex shell;
    bool isOver = overTop >= underTop;
    shell.highest = isOver ? 0u : 1u;
    shell.top = isOver ? overTop : underTop;
    shell.topAt = isOver ? overPeak : underPeak;
    shell.outer = skinVertices[v].position + shell.top * n;
    shell.up = n;
    shell.overA = turned(over.a, n, shell.up);
    shell.overB = turned(over.b, n, shell.up);
    shell.underA = turned(under.a, n, shell.up);
    shell.underB = turned(under.b, n, shell.up);
    shell.pad0 = 0u;
    shell.pad1 = 0u;
    shell.pad2 = 0u;
    shellVertices[v] = shell;
}
