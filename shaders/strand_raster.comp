// strand_raster.comp -- hairs to pixels, one invocation a hair, in two passes over the same code.
//
// The first pass (DEPTH_PASS) finds the nearest hair of each pixel with atomicMin on a 32-bit key;
// the second walks the same pixels for the hairs that the skin does not hide, and stores the color
// where its key is the one that won. So each pixel is written once, only the numbers of those hairs
// are kept between the passes, and 64-bit atomics are not needed. A pixel belongs to a hair when its
// center lies inside the hair's outline: averaged over sub-pixel offsets this is the exact coverage,
// also of hairs far thinner than a pixel.
//
// There is one program for each STYLE (kStyle... of types.glsl) with and without SHAPED hair
// (clumps, curls, frizz), RODS and ROUND shading, and for THIN hair, so that what is not used costs
// nothing.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "depth_key.glsl"
#include "segment_color.glsl"

#ifndef STYLE
#define STYLE 1
#endif

layout(local_size_x = 32) in;

struct Run {     // a prefix of a cluster of roots
    uint first;  // into the roots
    uint begin;  // number of its first hair in the dispatch
    uint end;    // and of the first one after it
    float lod;   // share of the hairs that is drawn
    float fade;  // rank at which a hair of density 1 has faded out, >= lod
    float phase; // of the cluster's ranks
    float step;
    uint pad0;
};

struct List {   // of the hairs of one program that the first pass found not hidden
    uint wide;   // groups of 32 that the second pass dispatches, in this and two more dimensions
    uint high;
    uint deep;
    uint count;  // hairs
    uint segments;
};

layout(std430, binding = 7) readonly buffer RootsBuffer { Root roots[]; };
layout(std430, binding = 8) coherent buffer Keys { uint keys[]; };
layout(std430, binding = 9) readonly buffer Runs { Run runs[]; };
layout(std430, binding = 10) buffer Counters { List lists[]; };
layout(std430, binding = 11) buffer Seen { uint seenHairs[]; };  // numbers, list after list
layout(std430, binding = 12) readonly buffer Groups { uint groups[]; };  // run of the first of 32
layout(binding = 1) uniform sampler2D skinDepth;
layout(location = 0) uniform uint coatsHere;  // as frame.coats, of this program
#ifdef DEPTH_PASS
layout(location = 1) uniform uvec2 numbers;   // of the hairs: the first one, a multiple of 32, and
                                              // the one after the last
#endif
layout(location = 2) uniform uvec2 list;      // its number, and where it begins
#ifndef DEPTH_PASS
layout(std430, binding = 6) readonly buffer Mask { float mask[]; };
layout(std430, binding = 13) readonly buffer SegmentOf { uint segmentOf[]; };
layout(rgba16f, binding = 0) writeonly uniform image2D picture;
#endif

#if STYLE == 0 && !defined(SHAPED)
const uint kMostSegments = 1u;
#elif STYLE == 1 && !defined(SHAPED)
const uint kMostSegments = 16u;
#else
const uint kMostSegments = 32u;
#endif
#if STYLE == 4
const uint kCorners = 9u;  // of a ring, the first one again at the end
#else
const uint kCorners = 2u;  // both edges
#endif
// Mean height of a half disc in diameters, pi / 8: so far the front of a round hair stands before its
// axis, and so far the ball at its end reaches beyond it.
const float kMeanBulge = 0.3926991;
const uint kMostWide = 65535u;  // groups in one dimension, as in strand_pass.cpp
const float kWidestHalf = 24.0;  // pixels; a hair before the lens does not stall the frame

#ifdef DEPTH_PASS
// Only these are grown again: in full groups, so that no lane idles for a hair that is hidden.
void keepSeen(uint number) {
    uint place = atomicAdd(lists[list.x].count, 1u);
    seenHairs[list.y + place] = number;
    if (place % 32u != 0u) return;
    uint group = place / 32u;
    if (group < kMostWide) atomicAdd(lists[list.x].wide, 1u);
    if (group % kMostWide == 0u) atomicAdd(lists[list.x].high, 1u);
}
#endif

// Window position (pixels), depth, and width in pixels. In both kinds of projection clip.w is the
// distance by which widths shrink.
vec4 toWindow(vec4 clip, float width) {
    if (!(clip.w > 1e-6)) return vec4(-1e9, -1e9, 2.0, 0.0);
    float inverse = 1.0 / clip.w;
    vec3 window = 0.5 + 0.5 * inverse * clip.xyz;
    return vec4(window.xy * vec2(frame.size), window.z, width * frame.pixelsPerMetre * inverse);
}

// True where the skin does not stand before this point, or where it cannot tell.
bool mayBeSeen(vec4 p) {
    ivec2 at = ivec2(floor(p.xy));
    if (at.x < 0 || at.y < 0 || at.x >= frame.size.x || at.y >= frame.size.y) return false;
    return p.z >= 0.0 && p.z <= texelFetch(skinDepth, at, 0).r;
}

Strand grow(Root root, bool over) {
    uvec4 t = triangles[root.triangle];
    return growStrand(root, skinVertices[t.x], skinVertices[t.y], skinVertices[t.z],
                      furVertices[t.x], furVertices[t.y], furVertices[t.z], fur,
                      over ? frame.overWidth : frame.underWidth, frame.seconds);
}

#if STYLE == 2 || STYLE == 4
// A hair across, at one point of it: its sides seen from the eye.
struct Ring {
    vec3 tangent;
    vec3 right;   // unit, across hair and view
    vec3 toward;  // unit, across the hair, towards the eye
};

Ring ringAt(Strand s, float t, vec3 eye) {
    Ring ring;
    ring.tangent = strandTangent(s, t);
    ring.right = safeUnit(cross(ring.tangent, eye), s.binormal);
    ring.toward = cross(ring.right, ring.tangent);
    return ring;
}
#endif

#if STYLE == 4
// Place of a corner in half widths: to the right and towards the eye.
vec2 cornerPlace(Strand s, Ring ring, uint k, uint sides) {
    vec3 normal = tubeNormal(s, ring.tangent, k, sides);
    return tubeScale(sides) * vec2(dot(normal, ring.right), dot(normal, ring.toward));
}
#endif

#ifndef DEPTH_PASS
vec3 colorAtRoot(Root root, vec3 weights, vec3 field) {
    uvec4 t = triangles[root.triangle];
    if (frame.overlay == kOverlaySegment)
        return weights.x * segmentColor(segmentOf[t.x]) + weights.y * segmentColor(segmentOf[t.y]) +
               weights.z * segmentColor(segmentOf[t.z]);
    if (heated()) return heat(dot(weights, field));
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
    bool wide;       // so many pixels that its sides are told apart
};

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
#endif

void main() {
    uint place = 32u * (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) +
                 gl_LocalInvocationID.x;
#ifdef DEPTH_PASS
    uint number = numbers.x + place;
    if (number >= numbers.y) return;
#else
    if (place >= lists[list.x].count) return;
    uint number = seenHairs[list.y + place];
#endif
    uint which = groups[number / 32u];
    while (number >= runs[which].end) ++which;
    Run run = runs[which];
    uint index = run.first + number - run.begin;
    Root root = roots[index];

    // What the painted density and the level of detail leave out is left before it is shaped.
    bool over = isOvercoat(root.id, fur.share);
    if ((coatsHere & (over ? 1u : 2u)) == 0u) return;
    uvec4 t = triangles[root.triangle];
    vec3 density =
        vec3(furVertices[t.x].density, furVertices[t.y].density, furVertices[t.z].density);
    float keep = keepAt(root, density.x, density.y, density.z);
    float rank = rankOf(number - run.begin, run.phase, run.step);
    if (!(rank < keep * run.fade)) return;

    Strand s = grow(root, over);
    if (!(s.spineLength > 0.0)) return;
    float widened = fadedWidth(rank / keep, run.lod, run.fade);
    s.width *= widened;
    float taper = over ? fur.over.taper : fur.under.taper;
#ifdef SHAPED
    if ((over ? fur.over.clump : fur.under.clump) > 0.0 && root.guide != index) {
        Strand guide = grow(roots[root.guide], over);
        if (over)
            s = gatherStrand(s, guide, fur.over);
        else
            s = gatherStrand(s, guide, fur.under);
    }
#endif

    // What lies behind the skin or outside the picture is left before it is rasterised.
    vec4 origin = frame.viewProjection * vec4(s.origin, 1.0);
#if STYLE == 0 && !defined(SHAPED)
    uint segments = 1u;
#else
    float tolerance = frame.tolerance * max(origin.w, 1e-6) / frame.pixelsPerMetre;
#if STYLE == 1 && !defined(SHAPED)
    uint segments = min(frame.segments, kMostSegments);
    if (frame.adapts != 0u) segments = min(segments, segmentsFor(s, tolerance));
#else
    uint segments = segmentsFor(s, tolerance);
#if STYLE == 1
    if (frame.adapts == 0u) segments = max(segments, min(frame.segments, kMostSegments));
#endif
#endif
#endif
    vec3 eye = toEye(s.origin);
#if !defined(THIN) || STYLE == 4
    vec4 nearer = frame.viewProjection * vec4(eye, 0.0);
    float zPerMetre = 0.5 * (nearer.z * origin.w - origin.z * nearer.w) /
                      max(origin.w * origin.w, 1e-12);
#endif
    vec4 points[kMostSegments + 1u];
    vec4 weightless = frame.viewProjection * vec4(s.scale * s.weightless, 0.0);
    vec4 end = frame.viewProjection * vec4(s.scale * s.end, 0.0);
    float dt = 1.0 / float(segments);
#ifdef DEPTH_PASS
    bool seen = false;
#endif
    for (uint i = 0u; i <= segments; ++i) {
        float at = float(i) * dt;
#if defined(SHAPED) || defined(RODS)
        vec4 clip = origin + frame.viewProjection * vec4(shapedOffset(s, at), 0.0);
#else
        vec2 k = strandWeights(s, at);
        vec4 clip = origin + k.x * weightless + k.y * end;
#endif
        points[i] = toWindow(clip, strandWidth(s, taper, at));
#if defined(DEPTH_PASS) && defined(THIN)
        if (!seen) seen = mayBeSeen(points[i]);
#endif
    }

    // The ends of a hair are balls. One that stands for several is as round as each of them.
    float bulge = kMeanBulge / max(widened, 1e-3);
#ifdef THIN
    vec2 step = points[1].xy - points[0].xy;
    points[0].xy -= bulge * points[0].w * inversesqrt(max(dot(step, step), 1e-12)) * step;
    step = points[segments].xy - points[segments - 1u].xy;
    points[segments].xy +=
        bulge * points[segments].w * inversesqrt(max(dot(step, step), 1e-12)) * step;
#else
    // What is seen of it is its front: towards the root where it points to the eye. Its outline stays
    // where it is. Of narrow hair that is left out.
    float roundness = clamp(3.0 * (points[0].w / kRoundFrom - 1.0), 0.0, 1.0);
    float zPerPixel = zPerMetre * max(origin.w, 1e-6) / frame.pixelsPerMetre;
    float rootWidth = points[0].w;
    float tipWidth = points[segments].w;
    vec2 fronts = vec2(0.0);  // pixels at both ends of the hair that show its first and last point
    vec2 balls = vec2(0.0);   // pixels that have the width of its first and last point
    float pixelsPerZ = 1.0 / zPerPixel;
    vec2 ahead = vec2(0.0);  // unit, of the hair in the window
    float sine = 0.0;        // of its angle with the view
    float cosine = 0.0;
    float narrowing = 0.0;   // from pixel to pixel
    for (uint i = 0u; i <= segments; ++i) {
        vec4 p = points[i];
        if (i < segments) {
            vec4 step = points[i + 1u] - p;
            float across = dot(step.xy, step.xy);
            float towards = step.z * pixelsPerZ;
            float perPixel = inversesqrt(max(across, 1e-12));
            float perLength = inversesqrt(max(across + towards * towards, 1e-12));
            ahead = perPixel * step.xy;
            sine = across * perPixel * perLength;
            cosine = towards * perLength;
            narrowing = -step.w * perPixel;
        }
        float front = bulge * p.w;
        float back = roundness * front * cosine;
        if (i == 0u) {
            fronts.x = front - back;
            balls.x = back = front;
        } else if (i == segments) {
            fronts.y = front + back;
            balls.y = front;
            back = -front;
        } else {
            points[i].w = clamp(p.w + narrowing * back, tipWidth, rootWidth);
        }
        points[i].xy -= back * ahead;
#if STYLE != 4
        if (p.z > 0.0) points[i].z = max(p.z + roundness * sine * front * zPerPixel, 0.0);
#endif
#ifdef DEPTH_PASS
        if (!seen) seen = mayBeSeen(points[i]);
#endif
    }
#endif

    float left[kCorners];  // edges of the bands in half widths, at the ring before and at this one
    float right[kCorners];
    uint bands = 1u;  // side by side across the hair
    left[0] = right[0] = -1.0;
    left[1] = right[1] = 1.0;
#if STYLE == 4
    bands = frame.sides > 0u ? clamp(frame.sides, 3u, 8u) : sidesFor(points[0].w);
    float nearA[kCorners];  // depth of the corners, in half widths towards the eye
    float nearB[kCorners];
    Ring ringB = ringAt(s, 0.0, eye);
    for (uint k = 0u; k <= bands; ++k) {
        vec2 place = cornerPlace(s, ringB, k, bands);
        right[k] = place.x;
        nearB[k] = place.y;
    }
#endif

#ifdef DEPTH_PASS
    if (!seen) return;
    atomicAdd(lists[list.x].segments, segments);
    keepSeen(number);
#else
    vec3 field = density;
    if (frame.overlay == 1u)
        field = vec3(furVertices[t.x].furLength, furVertices[t.y].furLength,
                     furVertices[t.z].furLength);
    if (frame.overlay == 4u) field = vec3(mask[t.x], mask[t.y], mask[t.z]);
    Look look;
    look.base = colorAtRoot(root, baryWeights(root.bary), field);
    look.eye = eye;
    look.perArea = frame.hairsPerArea * keep;
    float relative = over ? fur.over.relativeLength : fur.under.relativeLength;
    look.painted = s.spineLength / max(relative, 1e-6);
    look.wide = points[0].w > kRoundFrom;
    // Color varies slowly along a hair: every second point is enough, and a parabola where those are
    // far apart.
#if STYLE == 3
    Shade lower = meanColor(s, over, look, taper);
    Shade upper = lower;
#else
    Shade upper = shadeAt(s, over, look, 0.0);
    Shade lower = upper;
#endif
    Shade bow = bowOf(upper, upper, upper);
#endif

    for (uint i = 0u; i < segments; ++i) {
#ifndef DEPTH_PASS
        float fromA = 0.5 * float(i & 1u);
        float toB = fromA + 0.5;
#if STYLE == 3
        toB = fromA;
#else
        if ((i & 1u) == 0u) {
            lower = upper;
            float next = min(float(i + 2u) * dt, 1.0);
            upper = shadeAt(s, over, look, next);
            // A loop, because software runs what follows an if in any case.
            for (uint k = segments; k < 8u; k = 8u)
                bow = bowOf(lower, shadeAt(s, over, look, 0.5 * (float(i) * dt + next)), upper);
            if (i + 1u == segments) toB = 1.0;  // the last pair of an odd number is half as long
        }
#endif
#endif
        // u runs along the axis in which the segment is longer: one step of a pixel at a time.
        vec4 a = points[i];
        vec4 b = points[i + 1u];
        bool steep = abs(b.y - a.y) > abs(b.x - a.x);
        float u0 = steep ? a.y : a.x;
        float u1 = steep ? b.y : b.x;
        float v0 = steep ? a.x : a.y;
        float v1 = steep ? b.x : b.y;
        float lengthU = u1 - u0;
#ifndef THIN
        vec2 moves = vec2(0.0, 1.0);    // where the hair moves on: from, and how fast
        vec2 narrows = vec2(0.0, 1.0);  // and where it changes its width
        if (i == 0u || i + 1u == segments) {
            float whole = max(length(b.xy - a.xy), 1e-3);
            vec2 first = i == 0u ? vec2(fronts.x, balls.x) / whole : vec2(0.0);
            vec2 last = i + 1u == segments ? vec2(fronts.y, balls.y) / whole : vec2(0.0);
            vec2 fast = 1.0 / max(1.0 - first - last, 1e-3);
            moves = vec2(first.x, fast.x);
            narrows = vec2(first.y, fast.y);
        }
#endif
        float slope = (v1 - v0) / (abs(lengthU) < 1e-6 ? 1e-6 : lengthU);
        float stretch = 0.5 * sqrt(1.0 + min(slope * slope, 1.0));
        int sizeU = steep ? frame.size.y : frame.size.x;
        int sizeV = steep ? frame.size.x : frame.size.y;
        int first = max(int(ceil(max(min(u0, u1), -1.0) - 0.5)), 0);
        int last = min(int(ceil(min(max(u0, u1), 1e6) - 0.5)), sizeU);
        // The right of the hair lies towards growing v where it runs up, and against it where it
        // runs to the right.
        float side = (lengthU < 0.0) == steep ? -1.0 : 1.0;
#if STYLE == 4
        ringB = ringAt(s, min(float(i + 1u) * dt, 1.0), eye);
        for (uint k = 0u; k <= bands; ++k) {
            left[k] = right[k];
            nearA[k] = nearB[k];
            vec2 place = cornerPlace(s, ringB, k, bands);
            right[k] = place.x;
            nearB[k] = place.y;
        }
#endif
        for (uint band = 0u; band < bands; ++band) {
#if STYLE == 4
            // Corners run around the hair so that of a side that faces the eye the second lies to
            // the right of the first.
            if (left[band + 1u] - left[band] + right[band + 1u] - right[band] <= 0.0) continue;
#endif
            for (int u = first; u < last; ++u) {
                float f = (float(u) + 0.5 - u0) / lengthU;
                float v = v0 + slope * (float(u) + 0.5 - u0);
                float width = mix(a.w, b.w, f);
#ifndef THIN
                width = mix(a.w, b.w, clamp((f - narrows.x) * narrows.y, 0.0, 1.0));
                f = clamp((f - moves.x) * moves.y, 0.0, 1.0);
#endif
                float half_ = min(stretch * width, kWidestHalf);
                float z = mix(a.z, b.z, f);
#if STYLE == 2 || STYLE == 4
                float e0 = side * mix(left[band], right[band], f);
                float e1 = side * mix(left[band + 1u], right[band + 1u], f);
                float edge0 = v + half_ * min(e0, e1);
                float edge1 = v + half_ * max(e0, e1);
#else
                float edge0 = v - half_;
                float edge1 = v + half_;
#endif
#if STYLE == 4
                float near = 0.5 * mix(nearA[band] + nearA[band + 1u],
                                       nearB[band] + nearB[band + 1u], f);
                z += zPerMetre * 0.5 * near * strandWidth(s, taper, (float(i) + f) * dt);
#endif
                if (!(z >= 0.0 && z <= 1.0)) continue;
                uint key = depthKey(z, root.id);
                int from = max(int(ceil(edge0 - 0.5)), 0);
                int to = min(int(ceil(edge1 - 0.5)), sizeV);
                for (int w = from; w < to; ++w) {
                    ivec2 place = steep ? ivec2(w, u) : ivec2(u, w);
                    uint pixel = uint(place.y * frame.size.x + place.x);
#ifdef DEPTH_PASS
                    atomicMin(keys[pixel], key);
#else
                    if (keys[pixel] == key) {
                        float along = mix(fromA, toB, f);
                        float x = clamp(side * (float(w) + 0.5 - v) / half_, -1.0, 1.0);
                        vec3 color = colorAcross(lower, upper, bow, along, x);
                        imageStore(picture, place, vec4(color, 1.0));
                    }
#endif
                }
            }
        }
    }
}
