// shell.frag -- fur in a single pass: the ray behind a pixel goes through the layers of both coats
// until it meets a hair.
//
// A layer is the surface that the points at t of all hairs make, z(t) over the skin. Between two
// layers the ray is tested against the hairs' whole cross-sections (with PLAIN only at the layers):
// seen along its hairs, a slab is a short way on the skin, and what it touches are the roots within a
// hair's radius of that way.
//
// The skin is taken as a ball whose curvature is that of the skin in the direction of the ray, so that
// a ray at the silhouette leaves the fur again. Only the hair's place is wrong where the skin bends
// another way: never the depth of the skin, which hides what lies behind it.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_hair.glsl"
#include "shell_shade.glsl"
#include "shell_ray.glsl"

#ifdef SKIN
layout(early_fragment_tests) in;
#else
layout(depth_greater) out float gl_FragDepth;
#endif
out vec4 color;

const uint kMostSteps = 256u;
#ifdef PLAIN
const float kInSlab = 0.5;  // where a layer lies in its slab
#else
const float kInSlab = 0.0;
#endif
// Of the way from root to root that a slab is long at most: two roots of a texel are then enough.
const float kLongestSlab = 1.0;

// How hairs lean apart: together with their neighbors, so that none has to be looked for.
struct Stray {
    float reach;      // m, at the tip
    float perMetre;   // waves
};

// Waves of ten hairs; as far as a random end takes a hair on average, but never so far that hairs
// would fold over each other.
Stray strayOf(ShellCoat coat) {
    const float kMeanOfBall = 0.4472136;  // root mean square of each coordinate, 1 / sqrt(5)
    const float kMeanOfWave = 0.7302967;  // of a parabola's waves, sqrt(8 / 15)
    float wave = 10.0 * coat.period / sqrt(float(kTileHairs));
    return Stray(min(coat.stray * furLength * (kMeanOfBall / kMeanOfWave), 0.1 * wave), 1.0 / wave);
}

// The place on the skin whose hair the ray touches with its point at t.
vec3 rootAt(Ray ray, vec3 place, Hair hair, Stray stray, vec3 n, vec3 ahead, float way, float t) {
    vec3 root = arcOf(ray, way) * ahead - asideAt(hair, t);
    vec3 lean = waves(stray.perMetre * (place + root));
    root -= (t * stray.reach) * (lean - dot(lean, n) * n);
    return place + root - (0.5 * ray.bend * dot(root, root)) * n;
}

// Slabs that a coat needs where the way on the skin is so many times that from root to root.
float stepsFor(Ray ray, ShellCoat coat, float highest, float spacings) {
    float asked = float(shellLayers) * min(1.0, highest / ray.top);
#ifdef PLAIN
    // A hair that is cut into discs q of their diameter apart keeps 1 - q^2 / 6 of its depth.
    const float kApart = 0.5;
    if (shellLayers == 0u) asked = spacings * coat.period / (32.0 * kApart * coat.width);
#else
    asked = max(asked, max(spacings / kLongestSlab, 4.0));
#endif
    return asked;
}

Hit march(Ray ray, vec3 place, Hair hair, ShellCoat coat, uint coatNumber, vec3 n, vec3 ahead, float pixels,
          Hit hit) {
    // Hair that hangs is highest before its tip; what is beyond comes in no order.
    float peak = hair.za > 2.0 * hair.zb ? 0.5 * hair.za / (hair.za - hair.zb) : 1.0;
    float highest = heightAt(hair, peak);
    Level level = levelFor(pixels);
    Stray stray = strayOf(coat);
    Way at = wayTo(ray, min(heightAt(hair, 1.0), ray.top), false);
    Way skin = wayTo(ray, 0.0, false);
    Slab slab;
    slab.to = rootAt(ray, place, hair, stray, n, ahead, at.way, 1.0);
    slab.t.y = 1.0;
    vec3 end = rootAt(ray, place, hair, stray, n, ahead, skin.way, 0.0);
    // The normal where the roots are, about.
    Axes axes = axesOf(normalize(n + ray.bend * (0.5 * (slab.to + end) - place)), density);

    float spacing = coat.period * exp2(0.5 * float(level.tile)) / sqrt(float(kTileHairs));
    float asked = stepsFor(ray, coat, highest, distance(slab.to, end) / spacing);
    uint steps = uint(clamp(ceil(asked), 1.0, float(kMostSteps)));
    uint last = skin.there ? steps : 2u * steps;  // or out of the fur again
    if (!(highest > 0.0)) last = 0u;
    float dt = 1.0 / float(steps);
    vec3 aside = asideAt(hair, 1.0);
    float height = heightAt(hair, 1.0);
    for (uint i = 1u; i <= last; ++i) {
        Way before = at;
        vec3 asideBefore = aside;
        float heightBefore = height;
        slab.from = slab.to;
        slab.t.x = slab.t.y;
        slab.t.y = abs(1.0 - (float(i) - kInSlab) * dt);
        aside = asideAt(hair, slab.t.y);
        height = heightAt(hair, slab.t.y);
        at = wayTo(ray, min(height, ray.top), i > steps);
        slab.to = rootAt(ray, place, hair, stray, n, ahead, at.way, slab.t.y);
#ifdef PLAIN
        slab.from = slab.to;
        slab.t.x = slab.t.y;
        before = at;
        slab.stretch = 1.0;
#else
        // A hair that leans across the ray is cut into an ellipse.
        vec3 step = slab.to - slab.from;
        float rise = height - heightBefore;
        float slant = dot(n, cross(aside - asideBefore, step));
        slab.stretch = 1.0 + min(slant * slant / max(rise * rise * dot(step, step), 1e-20), 15.0);
#endif
        bool crossed = before.there || at.there;
        for (uint k = 0u, axis = axes.first; k < axes.count; ++k) {
            TileHit one = tileHit(slab, axis, coatNumber, coat, level, axes);
            float way = mix(before.way, at.way, one.along);
            if (one.along <= 1.0 && way < hit.way && crossed) {
                hit.way = way;
                hit.t = mix(slab.t.x, slab.t.y, one.along);
                hit.across = one.across;
                hit.id = one.id;
                hit.over = coatNumber == 0u;
            }
            axis += axes.step;
            axis -= axis > 2u ? 3u : 0u;
        }
        if (hit.way <= at.way && slab.t.x <= peak) break;
    }
    return hit;
}

void main() {
    vec3 n = safeUnit(normal, vec3(0.0, 1.0, 0.0));
    vec3 eye = safeUnit(toward, n);
    Entry entry = entryOf(n, eye);
    if (!entry.there) discard;
    float pixelsPerMetre = pixelsPerMetreAt(outer);
    Hit hit;
    hit.way = 1e30;
    for (uint c = 0u; c < 2u; ++c) {
        if ((shellCoats >> c & 1u) == 0u) continue;
        Hair hair = hairOf(underA, underB, n);
        if (c == 0u) hair = hairOf(overA, overB, n);
        ShellCoat coat = shellUnder;
        if (c == 0u) coat = shellOver;
        hit = march(entry.ray, entry.below, hair, coat, c, n, entry.ahead, coat.width * pixelsPerMetre, hit);
    }
    if (hit.way > 1e29) discard;
    color = vec4(radianceOf(hit, n, eye), 1.0);
#ifndef SKIN
    vec4 clip = frame.viewProjection * vec4(outer - hit.way * toEye(outer), 1.0);
    gl_FragDepth = max(gl_FragCoord.z, 0.5 + 0.5 * clip.z / clip.w);
#endif
}
