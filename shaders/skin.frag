// skin.frag -- the skin under the fur: lit as far as the coat lets light through.
#include "frame.glsl"

in vec2 uv;
in vec3 shade;
in float field;
flat in float layer;  // of the base-color textures, -1 = none
out vec4 color;

void main() {
    vec3 base = vec3(1.0);
    if (heated())
        base = heat(field);
    else if (layer >= 0.0)
        base = textureLod(baseColors, vec3(uv, layer), 0.0).rgb;
    color = vec4(base * shade, 1.0);
}
