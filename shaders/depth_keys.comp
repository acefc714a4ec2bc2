// depth_keys.comp -- starts the depth of each pixel at that of the skin, and finds how far the skin is
// at most in every strip of pixels. One invocation a strip.
#include "frame.glsl"
#include "depth_key.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 8) writeonly buffer Keys { uint keys[]; };
layout(std430, binding = 14) writeonly buffer Strips { float strips[]; };
layout(binding = 1) uniform sampler2D skinDepth;
layout(location = 0) uniform ivec4 window;  // corner and size of the pixels that hair may reach

const int kTile = 8;  // pixels, height of a strip; SkinDepth in core/lod.h

void main() {
    int strip = int(gl_GlobalInvocationID.x);
    int row = strip / window.z;
    int above = min(kTile, window.w - kTile * row);
    ivec2 at = window.xy + ivec2(strip % window.z, kTile * row);
    float farthest = 0.0;
    for (int i = 0; i < above; ++i, ++at.y) {
        float depth = texelFetch(skinDepth, at, 0).r;
        keys[at.y * frame.size.x + at.x] = depthKey(depth, 0u);
        farthest = max(farthest, depth);
    }
    if (above > 0) strips[strip] = farthest;
}
