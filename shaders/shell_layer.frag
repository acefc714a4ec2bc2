// shell_layer.frag -- one layer of a coat: the skin moved along its hair, opaque where a hair is cut.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "shell_hair.glsl"
#include "shell_shade.glsl"

layout(location = 0) uniform uint material;  // of the part that is drawn
layout(location = 2) uniform float layerAt;  // t of the hair that is drawn
layout(location = 3) uniform uint layerCoat;
in Ground ground;
in vec2 uv;
out vec4 color;

void main() {
    if (!(ground.top > 0.0)) discard;
    Ground g = ground;
    g.normal = safeUnit(g.normal, vec3(0.0, 1.0, 0.0));
    g.eye = safeUnit(g.eye, g.normal);
    g.bare *= materialColor(material, uv);
    ShellCoat coat = shellUnder;
    if (layerCoat == 0u) coat = shellOver;
    Level level = levelFor(coat.width * pixelsPerMetreAt(g.outer));
    Axes axes = axesOf(g.normal, g.density);
    Slab slab = Slab(g.place, g.place, vec2(layerAt), 0.0, 1.0);
    Hit hit;
    hit.way = 1e30;
    hit.t = layerAt;
    hit.root = g.place;
    hit.over = layerCoat == 0u;
    for (uint k = 0u, axis = axes.first; k < axes.count; ++k) {
        TileHit one = tileHit(slab, axis, layerCoat, coat, level, axes);
        if (one.along <= 1.0) {
            hit.way = 0.0;
            hit.id = one.id;
        }
        axis += axes.step;
        axis -= axis > 2u ? 3u : 0u;
    }
    if (hit.way > 1e29) discard;
    color = vec4(radianceOf(hit, g), 1.0);
}
