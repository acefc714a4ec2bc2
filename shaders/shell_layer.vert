// shell_layer.vert -- the skin moved along its hair.
#include "frame.glsl"
#include "strand.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"

layout(location = 0) in vec2 cornerUv;  // members of a Corner
layout(location = 1) in vec4 cornerColor;
layout(location = 2) in uint skinVertex;
layout(location = 2) uniform float layerAt;  // t of the hair that is drawn
layout(location = 3) uniform uint layerCoat;
out Ground ground;
out vec2 uv;

void main() {
    ShellVertex v = shellVertex(skinVertex);
    ground = groundOf(v, v, v, vec3(1.0, 0.0, 0.0), cornerColor.rgb);
    vec3 a = layerCoat == 0u ? v.overA : v.underA;
    vec3 b = layerCoat == 0u ? v.overB : v.underB;
    vec3 hair = layerAt * ((1.0 - layerAt) * a + layerAt * b);
    ground.outer = v.position + turnedBack(hair, v.turn);
    ground.eye = turned(toEye(ground.outer), v.turn);
    uv = cornerUv;
    gl_Position = frame.viewProjection * vec4(ground.outer, 1.0);
}
