// shell_curves.comp -- the mean hair of both coats at each vertex of the skin, for shells to cut.
//
// A hair is taken as the parabola through its root, middle and tip: t(1-t) a + t^2 b over its root,
// which the paper's hair is, and a rod nearly.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 8) writeonly buffer ShellVertices { ShellVertex shellVertices[]; };
struct Curvature {  // core/curvature.h
    float xx, xy, xz, yy;
    float yz, zz, pad0, pad1;
};
layout(std430, binding = 9) readonly buffer Curvatures { Curvature curvatures[]; };
struct RestVertex {  // the skin as it was at rest
    vec3 position;   // m
    uint pad0;
    vec4 turn;       // as in ShellVertex
};
layout(std430, binding = 10) readonly buffer RestVertices { RestVertex restVertices[]; };
layout(std430, binding = 11) writeonly buffer ShellCorners { ShellCorner shellCorners[]; };

struct Curve {
    vec3 a, b;
    vec3 across;
};

Curve meanCurve(Coat coat, uint bit, SkinVertex skin, vec3 n, FurVertex painted) {
    if ((shellCoats & bit) == 0u) return Curve(vec3(0.0), vec3(0.0), anyTangent(n));
    coat.endRandomness = 0.0;  // how far single hairs stray from it is up to who draws them
    float furLength = sanitizedLength(sanitizedLength(painted.furLength) * coat.relativeLength);
    Strand s = bendStrand(vec3(0.0), n, painted.direction, furLength, coat, 0u,
                          pullAt(fur, skin.position, frame.seconds));
    vec3 tip = spinePoint(s, 1.0);
    return Curve(4.0 * spinePoint(s, 0.5) - tip, tip, s.binormal);
}

// How high it gets over the skin. Hair that hangs is highest before its tip.
float heightOf(Curve c, vec3 n) {
    float a = dot(c.a, n);
    float b = dot(c.b, n);
    return max(0.0, a > 2.0 * b ? 0.25 * a * a / max(a - b, 1e-20) : b);
}

void main() {
    uint v = gl_GlobalInvocationID.x + 64u * 65535u * gl_GlobalInvocationID.y;
    if (v >= uint(skinVertices.length())) return;
    vec3 n = safeUnit(skinVertices[v].normal, vec3(0.0, 1.0, 0.0));
    Curve over = meanCurve(fur.over, 1u, skinVertices[v], n, furVertices[v]);
    Curve under = meanCurve(fur.under, 2u, skinVertices[v], n, furVertices[v]);
    Curvature bend = curvatures[v];
    RestVertex rest = restVertices[v];
    vec4 q = rest.turn;
    float density = furVertices[v].density;
    float top = max(heightOf(over, n), heightOf(under, n));
    vec3 position = skinVertices[v].position;
    shellCorners[v] = ShellCorner(position + top * n, top, position, 0u, n, 0u);
    shellVertices[v] = ShellVertex(
        position, top, turned(n, q),
        density > 0.0 ? min(density, 1.0) : 0.0, turned(over.a, q), furVertices[v].furLength,
        turned(over.b, q), bend.xx, turned(under.a, q), bend.xy, turned(under.b, q), bend.xz,
        turned(over.across, q), bend.yy, turned(under.across, q), bend.yz, rest.position, bend.zz,
        furVertices[v].tint, packedDirection(turned(furVertices[v].direction, q)), q);
}
