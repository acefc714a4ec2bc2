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

// The same of a hair, all of which lies between its three control points.
uint beyond(ShellVertex v, vec3 a, vec3 b) {
    return beyond(v.position) & beyond(v.position + turnedBack(0.5 * a, v.turn)) &
           beyond(v.position + turnedBack(b, v.turn));
}

void addFin(uint side, ShellVertex p, ShellVertex q, uint coat, float weight, float reach) {
    vec3 pa = coat == 0u ? p.overA : p.underA;
    vec3 pb = coat == 0u ? p.overB : p.underB;
    vec3 qa = coat == 0u ? q.overA : q.underA;
    vec3 qb = coat == 0u ? q.overB : q.underB;
    if (!(dot(pa, pa) + dot(pb, pb) + dot(qa, qa) + dot(qb, qb) > 0.0)) return;
    if ((beyond(p, pa, pb) & beyond(q, qa, qb)) != 0u) return;
    fins[atomicAdd(finCount, 1u)] = Fin(side, coat, weight, reach);
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
    // An edge stands for a third of both its triangles, so that all fins have each hair once.
    float size = distance(skinVertices[from].position, skinVertices[to].position);
    float reach = (length(one) + length(other)) / (12.0 * size);
    if (!(size > 0.0) || !(reach > 0.0)) return;
    ShellVertex p = shellVertex(from);
    ShellVertex q = shellVertex(to);
    if (!(p.density + q.density > 0.0)) return;
    for (uint coat = 0u; coat < 2u; ++coat)
        if ((finCoats >> coat & 1u) != 0u) addFin(edge.side, p, q, coat, weight, reach);
}
