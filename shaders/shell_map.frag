// shell_map.frag -- one layer of a coat that is cut from a picture: the skin moved along its hair.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "shell_hair.glsl"
#include "shell_shade.glsl"
#include "shell_map.glsl"

layout(location = 0) uniform uint material;  // of the part that is drawn
layout(location = 2) uniform float layerAt;  // t of the hair that is drawn
layout(location = 3) uniform uint layerCoat;
layout(location = 4) uniform uint layer;     // from 1, the outermost
in Ground ground;
in vec2 uv;
in vec3 combed;
out vec4 color;

// The light from what is cut. A photograph has the shade in its fur already.
vec3 mapRadiance(MapCut cut, Ground g) {
    Hit hit = Hit(0.0, layerAt, 0.0, cut.id, g.place, layerCoat == 0u);
    if (mapPhoto == 0u) return radianceOf(hit, g);
    Coat coat = fur.under;
    if (hit.over) coat = fur.over;
    // White in the light of the studio shows the photograph about as it is.
    coat.ambient = vec3(0.45);
    coat.diffuse = vec3(0.6);
    coat.specular = vec3(0.0);
    coat.rootColor = coat.tipColor = vec3(1.0);
    coat.colorNoise = coat.normalRandomness = 0.0;
    return litHair(hit, coat, g.tint * cut.color, 0.0, 1.0, g);
}

void main() {
    Ground g = ground;
    g.normal = safeUnit(g.normal, vec3(0.0, 1.0, 0.0));
    MapCut cut = mapCut(mapPlace(g.place, g.normal, combed), mapLevel(pixelsPerMetreAt(g.outer)),
                        layer, g.density);
    if (!(g.top > 0.0) || !cut.there) discard;
    g.eye = safeUnit(g.eye, g.normal);
    g.bare *= materialColor(material, uv);
    color = vec4(mapRadiance(cut, g), 1.0);
}
