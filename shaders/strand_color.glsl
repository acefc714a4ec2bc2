// strand_color.glsl -- the light that a hair sends to the eye: from point to point along it, and of
// ribbons and tubes across it.
#include "segment_color.glsl"

layout(std430, binding = 6) readonly buffer Mask { float mask[]; };
layout(std430, binding = 13) readonly buffer SegmentOf { uint segmentOf[]; };

// What a heat overlay shows, at the corners of a triangle.
vec3 fieldOf(uvec4 t) {
    if (frame.overlay == 1u)
        return vec3(furVertices[t.x].furLength, furVertices[t.y].furLength,
                    furVertices[t.z].furLength);
    if (frame.overlay == 4u) return vec3(mask[t.x], mask[t.y], mask[t.z]);
    return vec3(furVertices[t.x].density, furVertices[t.y].density, furVertices[t.z].density);
}

vec3 colorAtRoot(Root root, vec3 weights) {
    uvec4 t = triangles[root.triangle];
    if (frame.overlay == kOverlaySegment)
        return weights.x * segmentColor(segmentOf[t.x]) + weights.y * segmentColor(segmentOf[t.y]) +
               weights.z * segmentColor(segmentOf[t.z]);
    if (heated()) return heat(dot(weights, fieldOf(t)));
    vec2 uv = vec2(0.0);
    vec3 painted = weights.x * furVertices[t.x].tint + weights.y * furVertices[t.y].tint +
                   weights.z * furVertices[t.z].tint;
    vec3 skin = vec3(1.0);
    if (frame.textured != 0u) {
        Corner a = corners[sourceTriangles[3u * root.triangle]];
        Corner b = corners[sourceTriangles[3u * root.triangle + 1u]];
        Corner c = corners[sourceTriangles[3u * root.triangle + 2u]];
        uv = weights.x * a.uv + weights.y * b.uv + weights.z * c.uv;
        skin = weights.x * unpackUnorm4x8(a.color).rgb + weights.y * unpackUnorm4x8(b.color).rgb +
               weights.z * unpackUnorm4x8(c.color).rgb;
    }
    return painted * mix(vec3(1.0), skin * materialColor(t.w, uv), fur.skinColor);
}

struct Look {  // what the colors of one hair are made from
    vec3 base;
    vec3 eye;        // unit, towards it
    float perArea;   // hairs of both coats, 1/m^2
    float painted;   // m, length of the overcoat here
    float ahead;     // t that is seen before t = 0 of the axis, less where the hair is narrower
    bool wide;       // so many pixels that its sides are told apart
};

// Of a hair that is drawn up to the rank `keep`, so many pixels wide.
Look lookOf(Root root, Strand s, bool over, float keep, vec3 eye, float pixels) {
    Look look;
    look.base = colorAtRoot(root, baryWeights(root.bary));
    look.eye = eye;
    look.perArea = frame.hairsPerArea * keep;
    float relative = over ? fur.over.relativeLength : fur.under.relativeLength;
    look.ahead = 0.0;
    look.painted = s.spineLength / max(relative, 1e-6);
    look.wide = pixels > kRoundFrom;
    return look;
}

float depthAt(Strand s, Look look, float t) {
    return depthInCoat(fur, look.perArea, look.painted, frame.overWidth, frame.underWidth, s.coat,
                       t);
}

#ifdef ROUND
#define RADIANCE roundRadiance
#else
#define RADIANCE fiberRadiance
#endif

// Radiance of a hair at t, as a whole.
vec3 wholeColor(Strand s, bool over, Look look, float t) {
    t = clamp(t + look.ahead * (1.0 - (over ? fur.over.taper : fur.under.taper) * t), 0.0, 1.0);
    float depth = depthAt(s, look, t);
    if (over) return RADIANCE(s, fur.over, frame.light, look.base, t, look.eye, depth);
    return RADIANCE(s, fur.under, frame.light, look.base, t, look.eye, depth);
}

#if STYLE == 3
// One color for the entire hair: the mean of what the coat above leaves to be seen of it.
vec3 meanColor(Strand s, bool over, Look look, float taper) {
    const uint kPlaces = 4u;
    const float kStep = 1.0 / float(kPlaces);
    vec4 sum = vec4(0.0);
    for (uint k = 0u; k < kPlaces; ++k) {
        float t = (float(k) + 0.5) * kStep;
        float slant = sineBetween(strandTangent(s, t), look.eye) / max(dot(s.normal, look.eye), 0.05);
        float above = depthAt(s, look, t) - depthAt(s, look, 1.0 - 0.5 * kStep);
        float weight = (1.0 - taper * t) * exp(-above * slant);
        sum += weight * vec4(wholeColor(s, over, look, t), 1.0);
    }
    return sum.rgb / sum.a;
}
#endif

#if STYLE == 2 || STYLE == 4
// Light on a hair across it, at one point of it.
struct Shade {
    vec3 even;      // radiance that is the same all around
    vec3 diffuse;   // and of a side that faces the key light
    vec3 specular;  // and of one that faces halfway
    vec2 key;       // cosines of the key light with the normals of the right side and the middle
    vec2 halfway;
};

Shade shadeAt(Strand s, bool over, Look look, float t) {
    if (!look.wide)
        return Shade(wholeColor(s, over, look, t), vec3(0.0), vec3(0.0), vec2(0.0), vec2(0.0));
    float depth = depthAt(s, look, t);
    Ring ring = ringAt(s, t, look.eye);
    FiberLight f;
    if (over)
        f = fiberLight(s, fur.over, frame.light, look.base, t, ring.tangent, look.eye, depth);
    else
        f = fiberLight(s, fur.under, frame.light, look.base, t, ring.tangent, look.eye, depth);
    vec3 right = sideNormal(s, ring.tangent, ring.right);
    vec3 middle = sideNormal(s, ring.tangent, ring.toward);
    Shade shade;
    shade.even = radianceFacing(f, 0.0, 0.0);
    shade.diffuse = radianceFacing(f, 1.0, 0.0) - shade.even;
    shade.specular = f.specular;
    shade.key = vec2(dot(right, frame.light.toKey), dot(middle, frame.light.toKey));
    shade.halfway = vec2(dot(right, f.halfway), dot(middle, f.halfway));
    return shade;
}

// What is missing in the middle of two points, four times.
Shade bowOf(Shade a, Shade middle, Shade b) {
    return Shade(4.0 * middle.even - 2.0 * (a.even + b.even),
                 4.0 * middle.diffuse - 2.0 * (a.diffuse + b.diffuse),
                 4.0 * middle.specular - 2.0 * (a.specular + b.specular), vec2(0.0), vec2(0.0));
}

// Radiance so far along from one point to another, x half widths to the right.
vec3 colorAcross(Shade a, Shade b, Shade bow, float along, float x) {
    vec2 normal = vec2(x, sqrt(max(1.0 - x * x, 0.0)));
    float key = max(0.0, dot(normal, mix(a.key, b.key, along)));
    float halfway = max(0.0, dot(normal, mix(a.halfway, b.halfway, along)));
    float bent = along * (1.0 - along);
    return max(vec3(0.0), mix(a.even, b.even, along) + bent * bow.even) +
           key * max(vec3(0.0), mix(a.diffuse, b.diffuse, along) + bent * bow.diffuse) +
           halfway * max(vec3(0.0), mix(a.specular, b.specular, along) + bent * bow.specular);
}
#else
#define Shade vec3
#define shadeAt wholeColor
vec3 bowOf(vec3 a, vec3 middle, vec3 b) { return 4.0 * middle - 2.0 * (a + b); }

vec3 colorAcross(vec3 a, vec3 b, vec3 bow, float along, float x) {
    return max(vec3(0.0), mix(a, b, along) + along * (1.0 - along) * bow);
}
#endif
