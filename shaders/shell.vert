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
    vec4 xxyy;      // xx, xy, xz, yy
    vec4 yzzz;      // yz, zz
};
layout(std430, binding = 9) readonly buffer Curvatures { Curvature curvatures[]; };

out vec3 place;     // of the skin, world
out vec3 normal;
out vec3 overA;     // as in ShellVertex
out vec3 overB;
out vec3 underA;
out vec3 underB;
out float top;      // m, height over the skin
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
    top = max((shellCoats & 1u) != 0u ? shell.overHeight : 0.0,
              (shellCoats & 2u) != 0u ? shell.underHeight : 0.0);
    density = painted.density > 0.0 ? min(painted.density, 1.0) : 0.0;
    furLength = painted.furLength;
    uv = cornerUv;
    tint = painted.tint;
    bare = materials[material].color * cornerColor.rgb;

    vec3 outer = v.position + top * v.normal;
    vec3 eye = toEye(outer);
    vec3 along = eye - dot(eye, v.normal) * v.normal;
    float square = max(dot(along, along), 1e-12);
    Curvature c = curvatures[skinVertex];
    bend = (c.xxyy.x * along.x * along.x + c.xxyy.w * along.y * along.y +
            c.yzzz.y * along.z * along.z +
            2.0 * (c.xxyy.y * along.x * along.y + c.xxyy.z * along.x * along.z +
                   c.yzzz.x * along.y * along.z)) / square;
    gl_Position = frame.viewProjection * vec4(outer, 1.0);
}
