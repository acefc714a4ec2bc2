// fins.comp -- which edges of the skin have fins: those near the silhouette, in the picture.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "fin.glsl"

layout(local_size_x = 64) in;
struct Edge {    // core/half_edges.h
    uint side;
    uint other;  // ~0 = none
};
layout(std430, binding = 14) readonly buffer Edges { Edge edges[]; };
layout(location = 0) uniform uint finCoats;   // bits, as of frame.coats
layout(location = 1) uniform uint edgeCount;
layout(binding = 1) uniform sampler2D skinDepth;

// Of shorter edges fewer have fins, which are so long: pixels, and shares of the hair's length.
const float kShortest = 10.0;
const float kShortestOfHair = 0.45;

// Of the triangle of a half-edge: twice its area long.
vec3 faceOf(uint side) {
    if (side == ~0u) return vec3(0.0);
    uvec4 t = triangles[side / 3u];
    vec3 p = skinVertices[t.x].position;
    return cross(skinVertices[t.y].position - p, skinVertices[t.z].position - p);
}

// Sides of the picture beyond which a point lies.
uint beyond(vec3 place) {
    vec4 p = frame.viewProjection * vec4(place, 1.0);
    return uint(p.x < -p.w) | uint(p.x > p.w) << 1u | uint(p.y < -p.w) << 2u |
           uint(p.y > p.w) << 3u | uint(p.z < -p.w) << 4u;
}

// The mean hair of a coat at a vertex, world: t(1-t) a + t^2 b over the root.
struct End {
    vec3 root, a, b;
};
End endOf(ShellVertex v, uint coat) {
    return End(v.position, turnedBack(coat == 0u ? v.overA : v.underA, v.turn),
               turnedBack(coat == 0u ? v.overB : v.underB, v.turn));
}

// The same of a hair, all of which lies between its three control points.
uint beyond(End h) {
    return beyond(h.root) & beyond(h.root + 0.5 * h.a) & beyond(h.root + h.b);
}

// Whether the skin hides a point, moved towards the eye: all four pixels around it do.
bool hidden(vec3 place, float nearer) {
    vec4 p = frame.viewProjection * vec4(place + nearer * toEye(place), 1.0);
    vec2 at = 0.5 + 0.5 * p.xy / p.w;
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) return false;
    vec4 d = textureGather(skinDepth, at);
    return 0.5 + 0.5 * p.z / p.w > max(max(d.x, d.y), max(d.z, d.w));
}
bool hidden(End h, float nearer) {
    return hidden(h.root, nearer) && hidden(h.root + 0.25 * (h.a + h.b), nearer) &&
           hidden(h.root + h.b, nearer);
}

void addFin(Fin fin, End p, End q, bool shown) {
    if (!(dot(p.a, p.a) + dot(p.b, p.b) + dot(q.a, q.a) + dot(q.b, q.b) > 0.0)) return;
    if ((beyond(p) & beyond(q)) != 0u) return;
    if (!shown && hidden(p, fin.reach) && hidden(q, fin.reach)) return;
    fins[atomicAdd(finCount, 1u)] = fin;
}

void main() {
    uint i = gl_GlobalInvocationID.x + 64u * 65535u * gl_GlobalInvocationID.y;
    if (i >= edgeCount) return;
    Edge edge = edges[i];
    uint from = beginOf(edge.side);
    uint to = beginOf(nextOf(edge.side));
    vec3 one = faceOf(edge.side);
    vec3 other = faceOf(edge.other);
    vec3 n = safeUnit(safeUnit(one, vec3(0.0)) + safeUnit(other, vec3(0.0)),
                      safeUnit(skinVertices[from].normal, vec3(0.0, 1.0, 0.0)));
    vec3 place = 0.5 * (skinVertices[from].position + skinVertices[to].position);
    float weight = finWeight(dot(n, toEye(place)));
    if (!(weight > 0.0)) return;
    // An edge stands for a third of both its triangles, so that all fins have each hair once; for
    // twice that, as their weights thin hairs out to half on average.
    float size = distance(skinVertices[from].position, skinVertices[to].position);
    float reach = (length(one) + length(other)) / (6.0 * size);
    if (!(size > 0.0) || !(reach > 0.0)) return;
    ShellVertex p = shellVertex(from);
    ShellVertex q = shellVertex(to);
    if (!(p.density + q.density > 0.0)) return;
    float hairLength = 0.5 * (p.furLength + q.furLength);
    float pixels = size * pixelsPerMetreAt(place);
    float shortest = max(kShortest, kShortestOfHair * hairLength * pixels / size);
    float wide = clamp(shortest / pixels, 1.0, 16.0);
    weight *= clamp(5.0 - 4.0 * rand01(edge.side) * wide * wide, 0.0, 1.0);
    if (!(weight > 0.0)) return;
    for (uint coat = 0u; coat < 2u; ++coat)
        if ((finCoats >> coat & 1u) != 0u)
            addFin(Fin(2u * edge.side + coat, weight, wide * reach, wide), endOf(p, coat),
                   endOf(q, coat), pixels > 3.0 * shortest);
}
