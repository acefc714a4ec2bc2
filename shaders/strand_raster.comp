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
// (clumps, curls, frizz) and RODS, so that what a coat does not use costs nothing.
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
const uint kColumns = 9u;  // corners of a ring, the first one again at the end
#elif STYLE == 2
const uint kColumns = 3u;  // left edge, middle and right edge of a ribbon
#else
const uint kColumns = 2u;  // both edges
#endif
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
    bool round;      // a ribbon wide enough to look round
    uint sides;      // of a tube
};

// Radiance of a hair at t, column by column.
void colorColumns(Strand s, bool over, Look look, float t, inout vec3 colors[kColumns]) {
    float depth = depthInCoat(fur, look.perArea, look.painted, frame.overWidth, frame.underWidth,
                              s.coat, t);
#if STYLE == 2 || STYLE == 4
    Ring ring = ringAt(s, t, look.eye);
    vec3 tangent = ring.tangent;
#else
    vec3 tangent = strandTangent(s, t);
#endif
    FiberLight f;
    if (over)
        f = fiberLight(s, fur.over, frame.light, look.base, t, tangent, look.eye, depth);
    else
        f = fiberLight(s, fur.under, frame.light, look.base, t, tangent, look.eye, depth);
#if STYLE == 4
    for (uint k = 0u; k <= look.sides; ++k)
        colors[k] = radianceOf(f, tubeNormal(s, tangent, k, look.sides), frame.light.toKey);
#else
    colors[0] = radianceOf(f, strandNormal(s, tangent), frame.light.toKey);
    colors[1] = colors[0];
#if STYLE == 2
    colors[2] = colors[0];
    if (look.round) {
        for (uint k = 0u; k < 3u; ++k) {
            vec3 normal = k == 1u ? ring.toward : (float(k) - 1.0) * ring.right;
            normal = s.cosTwist * normal + s.sinTwist * cross(tangent, normal);
            colors[k] = radianceOf(f, normal, frame.light.toKey);
        }
    }
#endif
#endif
}
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
    s.width *= fadedWidth(rank / keep, run.lod, run.fade);
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
#ifdef DEPTH_PASS
        if (!seen) seen = mayBeSeen(points[i]);
#endif
    }

    vec3 eye = toEye(s.origin);
    float left[kColumns];  // edges of the bands in half widths, at the ring before and at this one
    float right[kColumns];
    uint bands = 1u;
    left[0] = right[0] = -1.0;
    left[1] = right[1] = 1.0;
#if STYLE == 2
    bool isRound = points[0].w > kRoundFrom;
#ifndef DEPTH_PASS
    if (isRound) {
        bands = 2u;
        left[1] = right[1] = 0.0;
        left[2] = right[2] = 1.0;
    }
#endif
#elif STYLE == 4
    bands = frame.sides > 0u ? clamp(frame.sides, 3u, 8u) : sidesFor(points[0].w);
    vec4 nearer = frame.viewProjection * vec4(eye, 0.0);
    float zPerMetre = 0.5 * (nearer.z * origin.w - origin.z * nearer.w) /
                      max(origin.w * origin.w, 1e-12);
    float nearA[kColumns];  // depth of the corners, in half widths towards the eye
    float nearB[kColumns];
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
#if STYLE == 2
    look.round = isRound;
#else
    look.round = false;
#endif
    look.sides = bands;
    // Color varies slowly along a hair: every second point is enough.
    vec3 lower[kColumns];
    vec3 upper[kColumns];
#if STYLE == 3
    colorColumns(s, over, look, 0.5, lower);  // one color for the entire hair
    upper = lower;
#else
    colorColumns(s, over, look, 0.0, upper);
#endif
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
            colorColumns(s, over, look, min(float(i + 2u) * dt, 1.0), upper);
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
        float slope = (v1 - v0) / (abs(lengthU) < 1e-6 ? 1e-6 : lengthU);
        float stretch = 0.5 * sqrt(1.0 + min(slope * slope, 1.0));
        int sizeU = steep ? frame.size.y : frame.size.x;
        int sizeV = steep ? frame.size.x : frame.size.y;
        int first = max(int(ceil(max(min(u0, u1), -1.0) - 0.5)), 0);
        int last = min(int(ceil(min(max(u0, u1), 1e6) - 0.5)), sizeU);
#if STYLE == 2 || STYLE == 4
        // The right of the hair lies towards growing v where it runs up, and against it where it
        // runs to the right.
        float side = (lengthU < 0.0) == steep ? -1.0 : 1.0;
#endif
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
                float half_ = min(stretch * mix(a.w, b.w, f), kWidestHalf);
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
                    ivec2 at = steep ? ivec2(w, u) : ivec2(u, w);
                    uint pixel = uint(at.y * frame.size.x + at.x);
#ifdef DEPTH_PASS
                    atomicMin(keys[pixel], key);
#else
                    if (keys[pixel] == key) {
                        float along = mix(fromA, toB, f);
                        vec3 color = mix(lower[band], upper[band], along);
#if STYLE == 2 || STYLE == 4
                        float x = ((float(w) + 0.5 - v) / half_ - e0) / (e1 - e0);
                        color = mix(color, mix(lower[band + 1u], upper[band + 1u], along),
                                    clamp(x, 0.0, 1.0));
#endif
                        imageStore(picture, at, vec4(color, 1.0));
                    }
#endif
                }
            }
        }
    }
}
