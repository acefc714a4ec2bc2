// skin.frag -- the skin under the fur: lit as far as the coat lets light through.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"

in vec3 normal;
in vec2 uv;
in vec3 vertexColor;
in vec3 position;
in float depth;
in float field;
out vec4 color;

void main() {
    vec3 n = safeUnit(normal, vec3(0.0, 1.0, 0.0));
    if (dot(n, toEye(position)) < 0.0) n = -n;  // open meshes are seen from inside too
    vec3 base = frame.overlay != 0u && frame.overlay != 3u
                    ? heat(field)
                    : materialColor(triangles[gl_PrimitiveID].w, uv, vertexColor);
    float coat = frame.overlay == 0u ? depth : 0.0;
    color = vec4(skinRadiance(frame.light, base, n, coat), 1.0);
}
