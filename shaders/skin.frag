// skin.frag -- the skin under the fur: lit as far as the coat lets light through.
#include "frame.glsl"

in vec2 uv;
in vec3 shade;
in float field;
layout(location = 0) uniform uint material;  // of the part that is drawn
out vec4 color;

void main() {
    vec3 base = frame.overlay != 0u && frame.overlay != 3u
                    ? heat(field)
                    : materialColor(material, uv);
    color = vec4(base * shade, 1.0);
}
