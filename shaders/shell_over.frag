// shell_over.frag -- which triangle comes next behind a pixel: of the surface over the fur, in front of
// what is in the picture; with SKIN of the skin, which is in the picture.
#include "frame.glsl"

in float facing;
layout(location = 0) uniform uint material;  // of the part that is drawn
layout(location = 2) uniform uint first;     // triangle of the part
layout(binding = 1) uniform sampler2D depths;  // of what is in the picture
layout(binding = 2) uniform sampler2D before;  // of the triangles that were found before
out uvec2 found;  // number of the triangle + 1, its material

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depths, pixel, 0).r;
#ifdef SKIN
    if (gl_FragCoord.z > depth + 1e-6) discard;
#else
    if (gl_FragCoord.z >= depth || gl_FragCoord.z <= texelFetch(before, pixel, 0).r) discard;
#endif
    if (!(facing > 1e-3)) discard;
    found = uvec2(first + uint(gl_PrimitiveID) + 1u, material);
}
