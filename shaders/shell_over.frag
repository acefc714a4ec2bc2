// shell_over.frag -- which triangle of the surface over the fur comes next behind a pixel.
#include "frame.glsl"

in float facing;
layout(location = 0) uniform uint material;  // of the part that is drawn
layout(location = 2) uniform uint first;     // triangle of the part
layout(binding = 1) uniform sampler2D depths;  // of what is in the picture
layout(binding = 2) uniform sampler2D before;  // of the triangles that were found before
layout(r8ui, binding = 0) uniform readonly uimage2D seen;  // 1 where a ray came down to the skin
out uvec2 found;  // number of the triangle + 1, its material

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depths, pixel, 0).r;
#ifdef SKIN
    if (gl_FragCoord.z > depth + 1e-6 || imageLoad(seen, pixel).r != 0u) discard;
#else
    if (gl_FragCoord.z >= depth || gl_FragCoord.z <= texelFetch(before, pixel, 0).r) discard;
#endif
    if (!(facing > 1e-3)) discard;
    found = uvec2(first + uint(gl_PrimitiveID) + 1u, material);
}
