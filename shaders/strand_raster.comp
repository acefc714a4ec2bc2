// strand_raster.comp -- hairs to pixels, one invocation a hair, in two passes over the same code.
//
// The first pass (DEPTH_PASS) finds the nearest hair of each pixel with atomicMin on a 32-bit key;
// the second walks the same pixels and stores the color where its key is the one that won. So each
// pixel is written once, nothing per hair is kept between the passes, and 64-bit atomics are not
// needed. A pixel belongs to a hair when its center lies inside the hair's outline: averaged over
// sub-pixel offsets this is the exact coverage, also of hairs far thinner than a pixel.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "depth_key.glsl"

layout(local_size_x = 32) in;

struct Job {     // a prefix of a cluster of roots, at most 32 of them
    uint first;
    uint count;
    float lod;   // share of the hairs that is drawn
    float fade;  // rank at which a hair of density 1 has faded out, >= lod
    uint seen;   // bit i: the first pass found that hair i is not hidden
    uint pad0;
    uint pad1;
    uint pad2;
};

layout(std430, binding = 7) readonly buffer RootsBuffer { Root roots[]; };
layout(std430, binding = 8) coherent buffer Keys { uint keys[]; };
layout(std430, binding = 9) buffer Jobs { Job jobs[]; };
layout(std430, binding = 10) buffer Counters { uint drawn; };
layout(binding = 1) uniform sampler2D skinDepth;
#ifndef DEPTH_PASS
layout(std430, binding = 6) readonly buffer Mask { float mask[]; };
layout(rgba16f, binding = 0) writeonly uniform image2D picture;
#endif

const uint kMostSegments = 16u;
const float kWidestHalf = 24.0;  // pixels; a hair before the lens does not stall the frame

// Share of its full width that a hair has at this level of detail: 1 up to a rank, then falling to
// 0. The sum of all widths stays that of the full coat.
float fadedWidth(float rank, float lod, float fade) {
    float full = 2.0 * lod - fade;
    float share = rank <= full ? 1.0 : clamp((fade - rank) / max(fade - full, 1e-9), 0.0, 1.0);
    return share / lod;
}

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

#ifndef DEPTH_PASS
vec3 colorAtRoot(Root root, vec3 weights, vec3 field) {
    if (frame.overlay != 0u && frame.overlay != 3u) return heat(dot(weights, field));
    vec2 uv = vec2(0.0);
    vec3 tint = vec3(1.0);
    if (frame.textured != 0u) {
        Corner a = corners[sourceTriangles[3u * root.triangle]];
        Corner b = corners[sourceTriangles[3u * root.triangle + 1u]];
        Corner c = corners[sourceTriangles[3u * root.triangle + 2u]];
        uv = weights.x * a.uv + weights.y * b.uv + weights.z * c.uv;
        tint = weights.x * unpackUnorm4x8(a.color).rgb + weights.y * unpackUnorm4x8(b.color).rgb +
               weights.z * unpackUnorm4x8(c.color).rgb;
    }
    return tint * materialColor(triangles[root.triangle].w, uv);
}
#endif

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (group >= frame.jobs) return;
    Job job = jobs[group];
    uint lane = gl_LocalInvocationID.x;
    if (lane >= job.count) return;
#ifndef DEPTH_PASS
    if ((job.seen >> lane & 1u) == 0u) return;
#endif
    Root root = roots[job.first + lane];

    // What the painted density and the level of detail leave out is left before it is shaped.
    bool over = isOvercoat(root.id, fur.share);
    if ((frame.coats & (over ? 1u : 2u)) == 0u) return;
    uvec4 t = triangles[root.triangle];
    vec3 weights = baryWeights(root.bary);
    vec3 density = vec3(furVertices[t.x].density, furVertices[t.y].density, furVertices[t.z].density);
    float keep = clamp(dot(weights, density), 0.0, 1.0);
    if (!(root.rank < keep * job.fade)) return;

    Strand s = growStrand(root, skinVertices[t.x], skinVertices[t.y], skinVertices[t.z],
                          furVertices[t.x], furVertices[t.y], furVertices[t.z], fur,
                          over ? frame.overWidth : frame.underWidth);
    if (!(s.spineLength > 0.0)) return;
    s.width *= fadedWidth(root.rank / keep, job.lod, job.fade);
    float taper = over ? fur.over.taper : fur.under.taper;

    // What lies behind the skin or outside the picture is left before it is rasterised.
    uint segments = min(frame.segments, kMostSegments);
    vec4 points[kMostSegments + 1u];
    vec4 origin = frame.viewProjection * vec4(s.origin, 1.0);
    vec4 weightless = frame.viewProjection * vec4(s.scale * s.weightless, 0.0);
    vec4 end = frame.viewProjection * vec4(s.scale * s.end, 0.0);
    float dt = 1.0 / float(segments);
#ifdef DEPTH_PASS
    bool seen = false;
#endif
    for (uint i = 0u; i <= segments; ++i) {
        float at = float(i) * dt;
        vec2 k = strandWeights(at);
        points[i] = toWindow(origin + k.x * weightless + k.y * end, strandWidth(s, taper, at));
#ifdef DEPTH_PASS
        if (!seen) seen = mayBeSeen(points[i]);
#endif
    }

#ifdef DEPTH_PASS
    if (!seen) return;
    atomicAdd(drawn, 1u);
    atomicOr(jobs[group].seen, 1u << lane);
#else
    vec3 field = density;
    if (frame.overlay == 1u)
        field = vec3(furVertices[t.x].furLength, furVertices[t.y].furLength, furVertices[t.z].furLength);
    if (frame.overlay == 4u) field = vec3(mask[t.x], mask[t.y], mask[t.z]);
    vec3 base = colorAtRoot(root, weights, field);
    float perArea = frame.hairsPerArea * keep;
    float painted = s.spineLength / max(over ? fur.over.relativeLength : fur.under.relativeLength, 1e-6);
    vec3 eye = toEye(s.origin);
    // Color varies slowly along a hair: every second point is enough.
    vec3 colors[kMostSegments / 2u + 2u];
    for (uint i = 0u; i <= (segments + 1u) / 2u; ++i) {
        float at = min(2.0 * float(i) * dt, 1.0);
        float depth = depthInCoat(fur, perArea, painted, frame.overWidth, frame.underWidth, s.coat, at);
        if (over)
            colors[i] = fiberRadiance(s, fur.over, frame.light, base, at, eye, depth);
        else
            colors[i] = fiberRadiance(s, fur.under, frame.light, base, at, eye, depth);
    }
#endif

    for (uint i = 0u; i < segments; ++i) {
#ifndef DEPTH_PASS
        uint pair = i / 2u;
        bool whole = 2u * pair + 2u <= segments;  // the last pair of an odd number is half as long
        float scale = whole ? 0.5 : 1.0;
        vec3 colorA = mix(colors[pair], colors[pair + 1u], scale * float(i & 1u));
        vec3 colorB = mix(colors[pair], colors[pair + 1u], scale * float(1u + (i & 1u)));
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
        for (int u = first; u < last; ++u) {
            float f = (float(u) + 0.5 - u0) / lengthU;
            float v = v0 + slope * (float(u) + 0.5 - u0);
            float reach = min(stretch * mix(a.w, b.w, f), kWidestHalf);
            float z = mix(a.z, b.z, f);
            if (!(z >= 0.0 && z <= 1.0)) continue;
            uint key = depthKey(z, root.id);
            int from = max(int(ceil(v - reach - 0.5)), 0);
            int to = min(int(ceil(v + reach - 0.5)), sizeV);
            for (int w = from; w < to; ++w) {
                ivec2 at = steep ? ivec2(w, u) : ivec2(u, w);
                uint pixel = uint(at.y * frame.size.x + at.x);
#ifdef DEPTH_PASS
                atomicMin(keys[pixel], key);
#else
                if (keys[pixel] == key)
                    imageStore(picture, at, vec4(mix(colorA, colorB, f), 1.0));
#endif
            }
        }
    }
}
