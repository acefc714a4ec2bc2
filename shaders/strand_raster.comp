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

#ifndef STYLE
#define STYLE 1
#endif

layout(local_size_x = 32) in;

layout(std430, binding = 7) readonly buffer RootsBuffer { Root roots[]; };
layout(std430, binding = 8) coherent buffer Keys { uint keys[]; };
layout(binding = 1) uniform sampler2D skinDepth;
layout(location = 0) uniform uint coatsHere;  // as frame.coats, of this program
#ifndef DEPTH_PASS
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
const float kWidestHalf = 24.0;  // pixels; a hair before the lens does not stall the frame

vec4 points[kMostSegments + 1u];  // of this hair in the window, see toWindow

#include "strand_ends.glsl"
#include "strand_seen.glsl"
#if STYLE == 2 || STYLE == 4
#include "strand_ring.glsl"
#endif
#ifndef DEPTH_PASS
#include "strand_color.glsl"
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

void main() {
    uint number = hairNumber();
    if (number == kNoHair) return;
    Run run = runOf(number);
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
    vec4 nearer = frame.viewProjection * vec4(eye, 0.0);
    float zPerMetre = 0.5 * (nearer.z * origin.w - origin.z * nearer.w) /
                      max(origin.w * origin.w, 1e-12);
    // A hair that stands for several has fronts and ends as round as each of them.
    float bulge = kMeanBulge / max(widened, 1e-3);
#ifdef THIN
    Front front = frontOf(s, bulge, eye);
#endif
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
        float across = strandWidth(s, taper, at);
        points[i] = toWindow(clip, across);
#if defined(THIN) && STYLE != 4
        if (points[i].z > 0.0) points[i].z = max(points[i].z + front.rise * zPerMetre * across, 0.0);
#endif
#if defined(DEPTH_PASS) && defined(THIN)
        // Before its ends move, by less than .6 pixels: afterwards it would take a loop of its own.
        if (!seen) seen = mayBeSeen(points[i]);
#endif
    }

#ifdef THIN
    roundEnds(segments, bulge);
#else
    Ends ends =
        roundEnds(segments, bulge, zPerMetre * max(origin.w, 1e-6) / frame.pixelsPerMetre);
#ifdef DEPTH_PASS
    for (uint i = 0u; i <= segments && !seen; ++i) seen = mayBeSeen(points[i]);
#endif
#endif
#ifdef DEPTH_PASS
    if (!seen) return;
    keepSeen(number, segments);
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

#ifndef DEPTH_PASS
    Look look = lookOf(root, s, over, keep, eye, points[0].w);
#if defined(THIN) && STYLE != 3
    look.ahead = front.ahead * s.width / s.spineLength;
#endif
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
        Along shares = alongSegment(ends, i, segments, length(b.xy - a.xy));
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
                width = mix(a.w, b.w, clamp((f - shares.narrows.x) * shares.narrows.y, 0.0, 1.0));
                f = clamp((f - shares.moves.x) * shares.moves.y, 0.0, 1.0);
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
