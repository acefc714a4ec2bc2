// shell.vert -- the surface behind which fur is marched: the skin, moved out as high as its hair gets.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"

layout(location = 0) in vec2 cornerUv;  // members of a Corner
layout(location = 1) in vec4 cornerColor;
layout(location = 2) in uint skinVertex;
layout(location = 0) uniform uint material;  // of the part that is drawn
layout(std430, binding = 8) readonly buffer ShellVertices { ShellVertex shellVertices[]; };
struct Curvature {  // core/curvature.h
    vec4 first;   // xx, xy, xz, yy of a symmetric map
    vec4 second;  // yz, zz
};
layout(std430, binding = 9) readonly buffer Curvatures { Curvature curvatures[]; };

// 1/m, times the square of the length of t: that of the skin's section along the tangent t.
float curvatureAlong(Curvature c, vec3 t) {
    return c.first.x * t.x * t.x + c.first.w * t.y * t.y + c.second.y * t.z * t.z +
           2.0 * (c.first.y * t.x * t.y + c.first.z * t.x * t.z + c.second.x * t.y * t.z);
}

// The skin as it was at rest, where the tile of roots lies on it.
struct RestVertex {
    vec3 position;  // m
    uint pad0;
    vec4 turn;      // unit quaternion: from the skin as it stands to the skin at rest
};
layout(std430, binding = 10) readonly buffer RestVertices { RestVertex restVertices[]; };
#ifdef LAYER
layout(location = 2) uniform float layerAt;  // t of the hair that is drawn
layout(location = 3) uniform uint layerCoat;
#endif

out vec3 outer;     // world, where the fur begins
out vec3 place;     // of the skin below; this and all that follows as at rest
out vec3 normal;
out vec3 toward;    // to the eye
out vec3 toKey;
out vec3 overA;     // as in ShellVertex
out vec3 overB;
out vec3 underA;
out vec3 underB;
out vec3 overAcross;
out vec3 underAcross;
out float top;
out float bend;     // 1/m, curvature of the skin in the direction of the view
out float skyward;  // how far the skin looks up
out float density;
out float furLength;
out vec3 tint;
out vec3 bare;      // color of the skin without its texture
out vec2 uv;
#ifdef MAP
out vec3 combed;    // where hair is combed
#endif

vec3 turned(vec3 v, vec4 q) {
    vec3 c = 2.0 * cross(q.xyz, v);
    return v + q.w * c + cross(q.xyz, c);
}

void main() {
    SkinVertex v = skinVertices[skinVertex];
    FurVertex painted = furVertices[skinVertex];
    ShellVertex shell = shellVertices[skinVertex];
    RestVertex rest = restVertices[skinVertex];
#if defined(LAYER)
    vec3 a = layerCoat == 0u ? shell.overA : shell.underA;
    vec3 b = layerCoat == 0u ? shell.overB : shell.underB;
    outer = v.position + layerAt * ((1.0 - layerAt) * a + layerAt * b);
#elif defined(SKIN)
    outer = v.position;
#else
    outer = v.position + shell.top * v.normal;
#endif
    vec3 eye = toEye(outer);
    vec3 along = eye - dot(eye, v.normal) * v.normal;
    bend = curvatureAlong(curvatures[skinVertex], along) / max(dot(along, along), 1e-12);
    skyward = v.normal.y;
    top = shell.top;
    density = painted.density > 0.0 ? min(painted.density, 1.0) : 0.0;
    furLength = painted.furLength;
    place = rest.position;
    normal = turned(v.normal, rest.turn);
    toward = turned(eye, rest.turn);
    toKey = turned(frame.light.toKey, rest.turn);
    overA = turned(shell.overA, rest.turn);
    overB = turned(shell.overB, rest.turn);
    underA = turned(shell.underA, rest.turn);
    underB = turned(shell.underB, rest.turn);
    overAcross = turned(shell.overAcross, rest.turn);
    underAcross = turned(shell.underAcross, rest.turn);
#ifdef MAP
    combed = turned(painted.direction, rest.turn);
#endif
    uv = cornerUv;
    tint = painted.tint;
    bare = materials[material].color * cornerColor.rgb;
    gl_Position = frame.viewProjection * vec4(outer, 1.0);
}
