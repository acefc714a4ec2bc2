// skin.frag -- the skin under the fur: lit as far as the coat lets light through.
#include "frame.glsl"

in vec3 shade;
#ifdef TEXTURED
in vec2 uv;
layout(location = 1) uniform float layer;  // of the base-color textures, -1 = none
#endif
#ifdef OVERLAY
in float field;
#endif
out vec4 color;

void main() {
    vec3 base = vec3(1.0);
#ifdef TEXTURED
    base = textureLod(baseColors, vec3(uv, layer), 0.0).rgb;
#endif
#ifdef OVERLAY
    if (layer < 0.0 || frame.overlay == kOverlaySegment) base = vec3(1.0);
    if (heated()) base = heat(field);
#endif
    color = vec4(base * shade, 1.0);
}
