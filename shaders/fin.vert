// fin.vert -- a strip along the mean hair of both ends of an edge.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "fin.glsl"

out vec3 place;  // m, world
out vec2 at;     // share of the way along the edge; t of the hair
out vec2 uv;
out vec3 cornerColor;
flat out uvec2 ends;  // skin vertices
flat out uint material;
flat out uint coatNumber;
flat out float weight;
flat out float reach;

void main() {
    Fin fin = fins[gl_InstanceID];
    uint end = uint(gl_VertexID) & 1u;
    at = vec2(float(end), float(uint(gl_VertexID) >> 1u) / float(kFinQuads));
    uint next = nextOf(fin.side);
    ends = uvec2(beginOf(fin.side), beginOf(next));
    ShellVertex v = shellVertex(ends[end]);
    vec3 a = fin.coat == 0u ? v.overA : v.underA;
    vec3 b = fin.coat == 0u ? v.overB : v.underB;
    place = v.position + turnedBack(at.y * ((1.0 - at.y) * a + at.y * b), v.turn);
    Corner corner = corners[sourceTriangles[end == 0u ? fin.side : next]];
    uv = corner.uv;
    cornerColor = unpackUnorm4x8(corner.color).rgb;
    material = triangles[fin.side / 3u].w;
    coatNumber = fin.coat;
    weight = fin.weight;
    reach = fin.reach;
    gl_Position = frame.viewProjection * vec4(place, 1.0);
}
