// fin.vert -- a strip along the mean hair of both ends of an edge.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "fin.glsl"

out Ground ground;  // of the end; its outer place is on the fin
out vec2 uv;
out float at;  // t of the hair
flat out uint material;
flat out uint coatNumber;
flat out float weight;
flat out float reach;

void main() {
    Fin fin = fins[gl_InstanceID];
    uint side = fin.edge >> 1u;
    uint next = nextOf(side);
    bool begins = (uint(gl_VertexID) & 1u) == 0u;
    Corner corner = corners[sourceTriangles[begins ? side : next]];
    ShellVertex v = shellVertex(corner.skinVertex);
    ShellVertex other = shellVertex(beginOf(begins ? next : side));
    coatNumber = fin.edge & 1u;
    at = float(uint(gl_VertexID) >> 1u) / float(kFinQuads);
    vec3 a = coatNumber == 0u ? v.overA : v.underA;
    vec3 b = coatNumber == 0u ? v.overB : v.underB;
    vec3 hair = turnedBack(at * ((1.0 - at) * a + at * b), v.turn);
    ground = groundOf(v, v, v, vec3(1.0, 0.0, 0.0), unpackUnorm4x8(corner.color).rgb);
    float longer = 0.5 * fin.wide - 0.5;
    ground.outer = v.position + longer * (v.position - other.position) + hair;
    ground.place += longer * (v.place - other.place);
    ground.eye = turned(toEye(ground.outer), v.turn);
    uv = corner.uv;
    material = triangles[side / 3u].w;
    weight = fin.weight;
    reach = fin.reach;
    gl_Position = frame.viewProjection * vec4(ground.outer, 1.0);
}
