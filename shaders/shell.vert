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

out vec3 place;     // of the skin, world
out vec3 normal;
out vec3 overA;     // as in ShellVertex
out vec3 overB;
out vec3 underA;
out vec3 underB;
out float top;
out float bend;     // 1/m, curvature of the skin in the direction of the view
out float density;
out float furLength;
out vec3 tint;
out vec3 bare;      // color of the skin without its texture
out vec2 uv;

void main() {
    SkinVertex v = skinVertices[skinVertex];
    FurVertex painted = furVertices[skinVertex];
    ShellVertex shell = shellVertices[skinVertex];
    place = v.position;
    normal = v.normal;
    overA = shell.overA;
    overB = shell.overB;
    underA = shell.underA;
    underB = shell.underB;
    top = shell.top;
    density = painted.density > 0.0 ? min(painted.density, 1.0) : 0.0;
    furLength = painted.furLength;
    uv = cornerUv;
    tint = painted.tint;
    bare = materials[material].color * cornerColor.rgb;

    vec3 outer = v.position + top * v.normal;
    vec3 eye = toEye(outer);
    vec3 along = eye - dot(eye, v.normal) * v.normal;
    bend = curvatureAlong(curvatures[skinVertex], along) / max(dot(along, along), 1e-12);
    gl_Position = frame.viewProjection * vec4(outer, 1.0);
}
