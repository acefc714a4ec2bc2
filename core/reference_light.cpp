// reference_light.cpp -- what hair and skin send to the eye, by the functions of fiber.glsl.
#include <cmath>

#include "reference_scene.h"
#include "strand_inline.h"
#include "stratified.h"

namespace pelage {
namespace {

// Streams of random numbers that a sample draws from its seed.
constexpr uint kStreamSky = 0x51u, kStreamKeyHairs = 0x52u, kStreamSkyHairs = 0x53u;

// A direction of the hemisphere around n, as likely as its cosine with n.
vec3 aroundNormal(vec3 n, vec2 place) {
    const float radius = std::sqrt(place.x), turn = 6.2831853f * place.y;
    const vec3 x = anyTangent(n);
    return radius * (std::cos(turn) * x + std::sin(turn) * cross(n, x)) +
           std::sqrt(std::max(0.0f, 1.0f - place.x)) * n;
}

// What arrives of the key light and, from one direction, of the light from all sides, at a place on
// a skin of normal n. The mean over all directions of light that nothing blocks is skyLight().
Reaching reachingBy(const RayScene& rays, const RayHit& hit, vec3 n, const Light& light,
                    SampleId sample) {
    const uint own = sample.seed ^ pcg(sample.index);
    Reaching reaching;
    reaching.key = rays.blocked(hit, light.toKey, kStraightShare, pcg(own + kStreamKeyHairs))
                       ? 0.0f
                       : light.key;
    const vec3 direction = aroundNormal(n, stratified(sample.index, pcg(sample.seed + kStreamSky)));
    reaching.sky = rays.blocked(hit, direction, kStraightShare, pcg(own + kStreamSkyHairs))
                       ? vec3(0.0f)
                   : direction.y > 0.0f ? light.sky
                                        : light.ground;
    return reaching;
}

struct Corners {
    uvec3 numbers;
    vec3 weights;

    template <typename T>
    auto mixed(const T& valueOf) const {
        return weights.x * valueOf(numbers.x) + weights.y * valueOf(numbers.y) +
               weights.z * valueOf(numbers.z);
    }
};

vec3 hairRadiance(const TracedDocument& scene, const ReferenceView& view, const RayHit& hit,
                  vec3 toEye, SampleId sample) {
    const Growth& growth = scene.growth;
    const Fur& fur = growth.fur;
    const Root& root = growth.roots.roots[scene.rootOf[hit.number]];
    Strand s = grownStrand(growth, scene.rootOf[hit.number]);
    s.style = view.style.value_or(s.coat == 0u ? scene.overStyle : scene.underStyle);
    const Coat& coat = s.coat == 0u ? fur.over : fur.under;
    const Corners corners{growth.skin.triangles[root.triangle], baryWeights(root.bary)};
    const vec3 tint = corners.mixed([&](uint v) { return growth.painted[v].tint; });
    const vec3 base =
        tint * mix(vec3(1.0f), scene.colors.at(root.triangle, corners.weights), fur.skinColor);
    const vec3 tangent = strandTangent(s, hit.t);
    FiberLight light;
    if (view.shadows == Shadows::live) {
        const float painted = s.spineLength / max(coat.relativeLength, 1e-6f);
        const float depth = depthInCoat(fur, scene.hairsPerArea() * s.keep, painted,
                                        growth.overWidth, growth.underWidth, s.coat, hit.t);
        light = fiberLight(s, coat, view.light, base, hit.t, tangent, toEye, depth);
    } else {
        const Reaching reaching = reachingBy(*scene.rays, hit, s.normal, view.light, sample);
        light = fiberLitBy(s, coat, view.light.toKey, reaching, base, hit.t, tangent, toEye);
    }
    const vec3 side = safeUnit(hit.facing - dot(hit.facing, tangent) * tangent, s.binormal);
    return radianceOf(light, sideNormal(s, tangent, side), view.light.toKey);
}

vec3 skinRadianceAt(const TracedDocument& scene, const ReferenceView& view, const RayHit& hit,
                    vec3 toEye, SampleId sample) {
    const Growth& growth = scene.growth;
    const Fur& fur = growth.fur;
    const Corners corners{growth.skin.triangles[hit.number], hit.weights};
    vec3 n =
        safeUnit(corners.mixed([&](uint v) { return growth.skin.vertices[v].normal; }), hit.facing);
    if (dot(n, toEye) < 0.0f) n = -n;  // open meshes are seen from inside too
    const float density = corners.mixed([&](uint v) { return growth.painted[v].density; });
    const float painted = corners.mixed([&](uint v) { return growth.painted[v].furLength; });
    const float depth = depthInCoat(fur, scene.hairsPerArea() * density, painted, growth.overWidth,
                                    growth.underWidth, 0u, 0.0f);
    const vec3 base = scene.colors.at(hit.number, hit.weights);
    if (view.shadows == Shadows::live) return skinRadiance(view.light, fur.under, base, n, depth);
    const Reaching light = reachingBy(*scene.rays, hit, n, view.light, sample);
    return skinColor(fur.under, base, depth) *
           (light.sky + vec3(light.key * max(0.0f, dot(n, view.light.toKey))));
}

}  // namespace

Seen seenAt(const TracedDocument& scene, const ReferenceView& view, const RayHit& hit, vec3 toEye,
            SampleId sample) {
    const auto radiance = hit.onHair ? hairRadiance : skinRadianceAt;
    return {radiance(scene, view, hit, toEye, sample), view.shadows == Shadows::traced ? 2u : 0u};
}

}  // namespace pelage
