// shell_over.vert -- the surface behind which fur is marched: the skin, moved out as high as its hair
// gets; with SKIN as it is.
#include "frame.glsl"

layout(location = 0) in vec3 place;  // members of a ShellCorner; m, world
layout(location = 1) in float top;
layout(location = 2) in vec3 normal;
out float facing;  // cosine of its angle with the view; 0 where there is no hair

void main() {
    facing = top > 0.0 ? dot(normal, toEye(place)) : 0.0;
    gl_Position = frame.viewProjection * vec4(place, 1.0);
}
