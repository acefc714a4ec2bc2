// depth_keys.comp -- starts the depth of each pixel at that of the skin.
#include "frame.glsl"
#include "depth_key.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 8) writeonly buffer Keys { uint keys[]; };
layout(binding = 1) uniform sampler2D skinDepth;

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= uint(frame.size.x * frame.size.y)) return;
    ivec2 at = ivec2(int(pixel) % frame.size.x, int(pixel) / frame.size.x);
    keys[pixel] = depthKey(texelFetch(skinDepth, at, 0).r, 0u);
}
