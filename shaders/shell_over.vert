// shell_over.vert -- the surface behind which fur is marched: the skin, moved out as high as its hair
// gets; with SKIN as it is.
#include "frame.glsl"

layout(location = 2) in uint skinVertex;  // member of a Corner
layout(binding = 3) uniform samplerBuffer shellCorners;  // the rows of a ShellCorner
out float facing;  // cosine of its angle with the view; 0 where there is no hair

void main() {
    int row = 3 * int(skinVertex);
#ifdef SKIN
    vec3 place = texelFetch(shellCorners, row + 1).xyz;
#else
    vec3 place = texelFetch(shellCorners, row).xyz;
#endif
    float top = texelFetch(shellCorners, row).w;
    vec3 normal = texelFetch(shellCorners, row + 2).xyz;
    facing = top > 0.0 ? dot(normal, toEye(place)) : 0.0;
    gl_Position = frame.viewProjection * vec4(place, 1.0);
}
