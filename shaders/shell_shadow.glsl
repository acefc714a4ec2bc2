// shell_shadow.glsl -- the shadows that single hairs in shells cast on hair below them.
//
// After Papaioannou, "A Simple and Fast Technique for Fur Rendering", 2002: layer j of N darkens
// layer i below it, moved aside by h tan(theta) (j - i) / N. Here what stands in the way is looked
// for between layers too, as a ray looks for what it meets, and for the nearest roots only: further
// up the mean of the coat (keyThroughCoat in fiber.glsl) is as good. That mean stays what it is:
// each hair in the way stops kStraightShare of the light, and what as many hairs stop on average is
// given back.
//
// The skin is taken as flat as far as a shadow falls aside. So that it nearly is, hairs are looked
// for only so high that no shadow falls aside by more than kMostTurn of the skin's radius of
// curvature.

#include "shell_curve.glsl"

const uint kShadowSlabs = 4u;  // each from root to root
const float kMostTurn = 0.25;  // radians, by which the skin turns where it is a ball
// Roots are evenly spread: so far from one, in ways from root to root, there is hardly another.
const float kAlone = 0.6;

// How far aside along a skin of unit normal n a shadow falls from a height, in light that comes
// from the unit direction l: towards the light.
vec3 shadowShift(vec3 n, vec3 l, float height) {
    float up = dot(n, l);
    return (height / max(up, 0.05)) * (l - up * n);
}

// The height up to which hairs are looked for over a skin of this curvature (1/m) towards the
// light.
float shadowHeight(vec3 n, vec3 l, float bend) {
    vec3 shift = shadowShift(n, l, 1.0);
    return kMostTurn / max(abs(bend) * sqrt(dot(shift, shift)), 1e-20);
}

struct ShadowRay {  // from a place in the fur towards the key light
    vec3 root;      // m, on the skin
    vec3 normal;    // unit, of the skin there
    vec3 toKey;     // unit
    vec3 aside;     // m, of the place from above the root
    float height;   // m
    float highest;  // m, that is looked at
};

// The root of the hair that stands in the way with its point at t. `strayed`: how far hairs here
// stray at the tip, `at`: the t of this coat at the ray's beginning.
vec3 rootInWay(ShadowRay ray, Hair h, vec3 strayed, float at, float t) {
    return ray.root + shadowShift(ray.normal, ray.toKey, heightAt(h, t) - ray.height) + ray.aside -
           asideAt(h, t) - (t - at) * strayed;
}

// The logarithm of the light past the hairs of one coat, as a share of what passes on average.
float logPast(ShadowRay ray, Hair h, ShellCoat coat, uint coatNumber, Ground g,
              float pixelsPerMetre) {
    Level level = levelFor(coat.width * pixelsPerMetre);
    Axes axes = axesOf(ray.normal, g.density);
    Stray stray = strayOf(coat, g.furLength);
    vec3 lean = waves(stray.perMetre * ray.root);
    vec3 strayed = stray.reach * (lean - dot(lean, ray.normal) * ray.normal);
    float end = min(peakOf(h), tAtHeight(h, ray.height + ray.highest));
    float at = min(tAtHeight(h, ray.height), end);
    float way = distance(rootInWay(ray, h, strayed, at, at), rootInWay(ray, h, strayed, at, end));
    float spacing = spacingOf(coat, level);
    // Out of the hair that the ray begins at.
    float reached = max(kAlone * spacing, coat.width / level.share);
    float perArea = g.density * float(kTileHairs) / (kTileExcess * coat.period * coat.period);
    Slab slab;
    slab.spread = 0.0;
    slab.t.y = mix(at, end, min(reached / max(way, 1e-20), 1.0));
    slab.to = rootInWay(ray, h, strayed, at, slab.t.y);
    float past = 0.0;
    for (uint i = 0u; i < kShadowSlabs; ++i) {
        reached += spacing;
        slab.from = slab.to;
        slab.t.x = slab.t.y;
        slab.t.y = mix(at, end, min(reached / max(way, 1e-20), 1.0));
        slab.to = rootInWay(ray, h, strayed, at, slab.t.y);
        if (!(slab.t.y > slab.t.x)) break;
        vec3 step = slab.to - slab.from;
        slab.stretch = stretchOf(ray.normal, heightAt(h, slab.t.y) - heightAt(h, slab.t.x),
                                 asideAt(h, slab.t.y) - asideAt(h, slab.t.x), step);
        float met = 0.0;
        for (uint k = 0u, axis = axes.first; k < axes.count; ++k) {
            met += tileHit(slab, axis, coatNumber, coat, level, axes).met;
            axis += axes.step;
            axis -= axis > 2u ? 3u : 0u;
        }
        float width = coat.width * (1.0 - 0.5 * coat.taper * (slab.t.x + slab.t.y));
        float mean = perArea * width * sqrt(slab.stretch * dot(step, step));
        past += met * log(1.0 - kStraightShare) + kStraightShare * mean;
    }
    return past;
}

// How many times as much of the key light arrives at a hair as on average in its coat.
float keyPast(Hit hit, Ground g) {
    ShadowRay ray;
    ray.root = hit.root;
    ray.normal = g.normal;
    ray.toKey = safeUnit(g.toKey, g.normal);
    Hair over = hairOf(Curve(g.overA, g.overB), 0.0, ray.normal, 0.0);
    Hair under = hairOf(Curve(g.underA, g.underB), 0.0, ray.normal, 0.0);
    Hair own = under;
    if (hit.over) own = over;
    ray.aside = asideAt(own, hit.t);
    ray.height = heightAt(own, hit.t);
    ray.highest = shadowHeight(ray.normal, ray.toKey, g.bendToKey);
    float pixelsPerMetre = pixelsPerMetreAt(g.outer);
    float past = 0.0;
    if ((shellCoats & 1u) != 0u) past += logPast(ray, over, shellOver, 0u, g, pixelsPerMetre);
    if ((shellCoats & 2u) != 0u) past += logPast(ray, under, shellUnder, 1u, g, pixelsPerMetre);
    return exp(past);
}
