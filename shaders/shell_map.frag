// shell_map.frag -- one layer of a coat that is cut from a picture: the skin moved along its hair.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "shell_hair.glsl"
#include "shell_shade.glsl"
#include "shell_map.glsl"
#include "shell_map_shade.glsl"

layout(location = 0) uniform uint material;  // of the part that is drawn
layout(location = 2) uniform float layerAt;  // t of the hair that is drawn
layout(location = 3) uniform uint layerCoat;
layout(location = 4) uniform uint layer;     // from 1, the outermost
in Ground ground;
in vec2 uv;
out vec4 color;

void main() {
    Ground g = ground;
    g.normal = safeUnit(g.normal, vec3(0.0, 1.0, 0.0));
    MapCut cut = mapCut(mapPlace(g.place, g.normal, g.combed), mapLevel(pixelsPerMetreAt(g.outer)),
                        layer, g.density);
    if (!(g.top > 0.0) || !cut.there) discard;
    g.eye = safeUnit(g.eye, g.normal);
    g.bare *= materialColor(material, uv);
    Hit hit = Hit(0.0, layerAt, cut.id, g.place, layerCoat == 0u);
    color = vec4(mapRadiance(cut, hit, g), 1.0);
}
