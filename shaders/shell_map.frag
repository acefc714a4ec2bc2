// shell_map.frag -- fur that is cut from a picture, in a single pass: the ray behind a pixel goes from
// layer to layer of a coat until it meets one that is there. With LAYER, one layer only.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_hair.glsl"
#include "shell_shade.glsl"
#include "shell_map.glsl"

in vec3 combed;
out vec4 color;

// The light from a place of the picture in layer k. A photograph has the shade in its fur already.
vec3 mapRadiance(MapCut cut, MapPlace at, float level, uint k, vec3 n, vec3 eye) {
    Hit hit = Hit(0.0, mapLayerAt(k), 0.0, 0u, mapCoat == 0u);
    if (mapPhoto == 0u) {
        hit.id = mapId(mapTexel(at, level));
        return radianceOf(hit, n, eye);
    }
    Coat coat = fur.under;
    if (hit.over) coat = fur.over;
    // White in the light of the studio shows the photograph about as it is.
    coat.ambient = vec3(0.45);
    coat.diffuse = vec3(0.6);
    coat.specular = vec3(0.0);
    coat.rootColor = coat.tipColor = vec3(1.0);
    coat.colorNoise = coat.normalRandomness = 0.0;
    return litHair(hit, coat, tint * cut.color, 0.0, n, eye);
}

#ifdef LAYER
layout(location = 4) uniform uint mapLayer;

void main() {
    vec3 n = safeUnit(normal, vec3(0.0, 1.0, 0.0));
    MapPlace at = mapPlace(place, n, combed);
    float level = mapLevel(pixelsPerMetreAt(outer));
    MapCut cut = mapCut(at, level, mapLayer, density);
    if (!(top > 0.0) || !cut.there) discard;
    color = vec4(mapRadiance(cut, at, level, mapLayer, n, safeUnit(toward, n)), 1.0);
}
#else
#include "shell_ray.glsl"

#ifdef SKIN
layout(early_fragment_tests) in;
#else
layout(depth_greater) out float gl_FragDepth;
#endif

void main() {
    vec3 n = safeUnit(normal, vec3(0.0, 1.0, 0.0));
    vec3 eye = safeUnit(toward, n);
    Entry entry = entryOf(n, eye);
    if (!entry.there) discard;
    Ray ray = entry.ray;
    Hair hair = hairOf(underA, underB, n);
    if (mapCoat == 0u) hair = hairOf(overA, overB, n);
    // Hair that hangs is highest before its tip; what is beyond comes in no order.
    float peak = hair.za > 2.0 * hair.zb ? 0.5 * hair.za / (hair.za - hair.zb) : 1.0;
    float level = mapLevel(pixelsPerMetreAt(outer));
    // Down to the skin, or out of the fur again.
    uint last = wayTo(ray, 0.0, false).there ? mapLayers : 2u * mapLayers - 1u;
    if (!(heightAt(hair, peak) > 0.0)) last = 0u;
    float nearest = 1e30;
    MapPlace where;
    uint found = 0u;
    MapCut seen;
    seen.there = false;
    for (uint i = 1u; i <= last; ++i) {
        bool up = i > mapLayers;
        uint k = up ? 2u * mapLayers - i : i;
        float t = mapLayerAt(k);
        Way at = wayTo(ray, min(heightAt(hair, t), ray.top), up);
        vec3 root = arcOf(ray, at.way) * entry.ahead - asideAt(hair, t);
        // The skin where the root is, about.
        vec3 rootNormal = normalize(n + ray.bend * (root - dot(root, n) * n));
        root = entry.below + root - (0.5 * ray.bend * dot(root, root)) * n;
        MapPlace there = mapPlace(root, rootNormal, combed);
        MapCut cut = mapCut(there, level, k, density);
        if (cut.there && at.there && at.way < nearest) {
            nearest = at.way;
            where = there;
            found = k;
            seen = cut;
        }
        if (nearest <= at.way && t <= peak) break;
    }
    if (!seen.there) discard;
    color = vec4(mapRadiance(seen, where, level, found, n, eye), 1.0);
#ifndef SKIN
    vec4 clip = frame.viewProjection * vec4(outer - nearest * toEye(outer), 1.0);
    gl_FragDepth = max(gl_FragCoord.z, 0.5 + 0.5 * clip.z / clip.w);
#endif
}
#endif
