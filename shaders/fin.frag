// fin.frag -- the hairs that stand near an edge of the silhouette, where the view goes through the
// fin.
//
// The view runs along the skin there: what it meets at t are the roots within a hair's radius of
// its way on the skin, in the same tile as those of shells. The way is as long as the edge stands
// for, and no longer than hairs reach so high on a skin that bends away.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "shell_hair.glsl"
#include "shell_curve.glsl"
#include "shell_shade.glsl"
#include "fin.glsl"

in Ground ground;
in vec2 uv;
in float at;
flat in uint material;
flat in uint coatNumber;
flat in float weight;
flat in float reach;
layout(binding = 1) uniform sampler2D skinDepth;
layout(binding = 2) uniform sampler2D depths;  // of what is in the picture
out vec4 color;

const uint kMostSlabs = 24u;

// Of a slab: a hair that leans across the ray is cut into an ellipse, and over a ball hairs stand
// further apart than their roots.
float stretchOf(Hair hair, Ground g, vec3 ahead, float height) {
    vec3 slope = (1.0 - 2.0 * at) * hair.a + (2.0 * at) * hair.b;
    float rise = (1.0 - 2.0 * at) * hair.za + (2.0 * at) * hair.zb;
    float spread = max(1.0 + g.bendAcross * height, 0.3);
    return stretchOf(g.normal, rise, slope, ahead) / (spread * spread);
}

// The first hair of the fin behind a pixel, so deep to both sides. Its way is that on the skin.
Hit firstHit(Ground g, ShellCoat coat, vec3 ahead, float deep, float stretch) {
    Level level = levelFor(coat.width * pixelsPerMetreAt(g.outer));
    Axes axes = axesOf(g.normal, g.density);
    Stray stray = strayOf(coat, g.furLength);
    vec3 lean = waves(stray.perMetre * g.place);
    vec3 middle = g.place - (at * stray.reach) * (lean - dot(lean, g.normal) * g.normal);
    uint slabs = uint(clamp(ceil(2.0 * deep / spacingOf(coat, level)), 1.0, float(kMostSlabs)));
    vec3 step = ahead * (2.0 * deep / float(slabs));
    Slab slab;
    slab.t = vec2(at);
    slab.spread = 0.0;
    slab.to = middle - deep * ahead;
    slab.stretch = stretch;
    Hit hit;
    hit.way = 1e30;
    hit.t = at;
    hit.over = coatNumber == 0u;
    for (uint i = 0u; i < slabs; ++i) {
        slab.from = slab.to;
        slab.to += step;
        float first = 2.0;
        for (uint k = 0u, axis = axes.first; k < axes.count; ++k) {
            TileHit one = tileHit(slab, axis, coatNumber, coat, level, axes);
            if (one.along < first && abs(one.across) <= finWidth(weight, rand01(one.id))) {
                first = one.along;
                hit.id = one.id;
                hit.root = mix(slab.from, slab.to, one.along);
            }
            axis += axes.step;
            axis -= axis > 2u ? 3u : 0u;
        }
        if (first <= 1.0) {
            hit.way = (float(i) + first) * 2.0 * deep / float(slabs) - deep;
            break;
        }
    }
    return hit;
}

void main() {
    Ground g = ground;
    // However far before the fin its hair stands, it is hidden; or shells show this fur here.
    vec3 eye = toEye(g.outer);
    float shown = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    bool hairy = shown < texelFetch(skinDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (windowDepth(g.outer + 2.0 * reach * eye) > shown) discard;
    if (hairy && windowDepth(g.outer - (g.top + 2.0 * reach) * eye) > shown) discard;

    g.normal = safeUnit(g.normal, vec3(0.0, 1.0, 0.0));
    g.eye = safeUnit(g.eye, g.normal);
    g.bare *= materialColor(material, uv);
    ShellCoat coat = shellUnder;
    if (coatNumber == 0u) coat = shellOver;
    Hair hair = hairOf(Curve(coatNumber == 0u ? g.overA : g.underA,
                             coatNumber == 0u ? g.overB : g.underB), 0.0, g.normal, 0.0);
    vec3 across = dot(g.normal, g.eye) * g.normal - g.eye;
    float sine = max(length(across), 0.5);
    vec3 ahead = safeUnit(across, vec3(0.0));
    // On a ball hair reaches so high so far to either side.
    float height = heightAt(hair, at);
    float room = max(heightAt(hair, peakOf(hair)) - height, 0.0);
    float deep = min(reach, sqrt(2.0 * room / max(g.bend, 1e-6 / g.top)));

    Hit hit = firstHit(g, coat, ahead, deep, stretchOf(hair, g, ahead, height));
    if (hit.way > 1e29) discard;
    color = vec4(radianceOf(hit, g), 1.0);
    gl_FragDepth = windowDepth(g.outer - (hit.way / sine) * eye);
}
