// shell_curves.comp -- the mean hair of both coats at each vertex of the skin, for shells to cut.
//
// A hair is taken as the parabola through its root, middle and tip: t(1-t) a + t^2 b over its root,
// which the paper's hair is, and a rod nearly.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 8) writeonly buffer ShellVertices { ShellVertex shellVertices[]; };
struct Bend {        // of the skin, smoothed
    vec3 normal;     // unit, or zero
    float pad0;
    float xx, xy, xz, yy;  // core/curvature.h
    float yz, zz, pad1, pad2;
};
layout(std430, binding = 9) readonly buffer Bends { Bend bends[]; };
struct RestVertex {  // the skin as it was at rest
    vec3 position;   // m
    uint pad0;
    vec4 turn;       // as in ShellVertex
};
layout(std430, binding = 10) readonly buffer RestVertices { RestVertex restVertices[]; };
layout(std430, binding = 11) writeonly buffer ShellCorners { ShellCorner shellCorners[]; };

struct MeanHair {
    Curve curve;
    vec3 across;
};

MeanHair meanHair(Coat coat, uint bit, SkinVertex skin, vec3 n, FurVertex painted) {
    if ((shellCoats & bit) == 0u) return MeanHair(Curve(vec3(0.0), vec3(0.0)), anyTangent(n));
    coat.endRandomness = 0.0;  // how far single hairs stray from it is up to who draws them
    float furLength = sanitizedLength(sanitizedLength(painted.furLength) * coat.relativeLength);
    Strand s = bendStrand(vec3(0.0), n, painted.direction, furLength, coat, 0u,
                          pullAt(fur, skin.position, frame.seconds));
    vec3 tip = spinePoint(s, 1.0);
    return MeanHair(Curve(4.0 * spinePoint(s, 0.5) - tip, tip), s.binormal);
}

// How high it gets over the skin. Hair that hangs is highest before its tip.
float heightOf(Curve mean, Coat coat, vec3 n, Bend bend) {
    Curve c = highest(mean, spreadOf(mean, n, coat.endRandomness));
    mat3 bends = mat3(bend.xx, bend.xy, bend.xz, bend.xy, bend.yy, bend.yz, bend.xz, bend.yz,
                      bend.zz);
    vec3 t = safeUnit(c.b - dot(c.b, n) * n, vec3(0.0));
    c = overBent(c, n, dot(t, bends * t));
    float a = dot(c.a, n);
    float b = dot(c.b, n);
    return max(0.0, a > 2.0 * b ? 0.25 * a * a / max(a - b, 1e-20) : b);
}

void main() {
    uint v = gl_GlobalInvocationID.x + 64u * 65535u * gl_GlobalInvocationID.y;
    if (v >= uint(skinVertices.length())) return;
    Bend bend = bends[v];
    vec3 n = safeUnit(bend.normal, vec3(0.0, 1.0, 0.0));
    MeanHair over = meanHair(fur.over, 1u, skinVertices[v], n, furVertices[v]);
    MeanHair under = meanHair(fur.under, 2u, skinVertices[v], n, furVertices[v]);
    RestVertex rest = restVertices[v];
    vec4 q = rest.turn;
    float density = furVertices[v].density;
    float top = max(heightOf(over.curve, fur.over, n, bend),
                    heightOf(under.curve, fur.under, n, bend));
    vec3 position = skinVertices[v].position;
    shellCorners[v] = ShellCorner(position + top * n, top, position, 0u, n, 0u);
    shellVertices[v] = ShellVertex(
        position, top, turned(n, q),
        density > 0.0 ? min(density, 1.0) : 0.0, turned(over.curve.a, q), furVertices[v].furLength,
        turned(over.curve.b, q), bend.xx, turned(under.curve.a, q), bend.xy,
        turned(under.curve.b, q), bend.xz,
        turned(over.across, q), bend.yy, turned(under.across, q), bend.yz, rest.position, bend.zz,
        furVertices[v].tint, packedDirection(turned(furVertices[v].direction, q)), q);
}
