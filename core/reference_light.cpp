// reference_light.cpp -- what hair and skin send to the eye, by the functions of fiber.glsl.
#include <cmath>
#include <optional>

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

// Adds what is lit by each lighting: by the light that reaches a place on a skin of normal n, or,
// where that is null, by the functions of the live view.
template <typename LitBy>
uint addEach(std::span<vec4> sums, std::span<const Lighting> lightings, const RayScene& rays,
             const RayHit& hit, vec3 n, const Light& light, SampleId sample, const LitBy& lit) {
    std::optional<Reaching> reaching;  // the same for all that are traced
    for (std::size_t l = 0; l < sums.size(); ++l) {
        const bool traced = lightings[l].shadows == Shadows::traced;
        if (traced && !reaching) reaching = reachingBy(rays, hit, n, light, sample);
        sums[l] += vec4(lit(lightings[l], traced ? &*reaching : nullptr), 1.0f);
    }
    return reaching ? 2u : 0u;
}

uint addHair(std::span<vec4> sums, const TracedDocument& scene, const Light& light,
             std::span<const Lighting> lightings, const RayHit& hit, vec3 toEye, SampleId sample) {
    const Growth& growth = scene.growth;
    const Fur& fur = growth.fur;
    const Root& root = growth.roots.roots[scene.rootOf[hit.number]];
    Strand s = grownStrand(growth, scene.rootOf[hit.number]);
    const Coat& coat = s.coat == 0u ? fur.over : fur.under;
    const Corners corners{growth.skin.triangles[root.triangle], baryWeights(root.bary)};
    const vec3 tint = corners.mixed([&](uint v) { return growth.painted[v].tint; });
    const vec3 base =
        tint * mix(vec3(1.0f), scene.colors.at(root.triangle, corners.weights), fur.skinColor);
    const vec3 tangent = strandTangent(s, hit.t);
    const float painted = s.spineLength / max(coat.relativeLength, 1e-6f);
    const float depth = depthInCoat(fur, scene.hairsPerArea() * s.keep, painted, growth.overWidth,
                                    growth.underWidth, s.coat, hit.t);
    const vec3 side = safeUnit(hit.facing - dot(hit.facing, tangent) * tangent, s.binormal);
    const auto lit = [&](const Lighting& lighting, const Reaching* reaching) {
        s.style = lighting.style.value_or(s.coat == 0u ? scene.overStyle : scene.underStyle);
        const FiberLight fiber =
            reaching ? fiberLitBy(s, coat, light.toKey, *reaching, base, hit.t, tangent, toEye)
                     : fiberLight(s, coat, light, base, hit.t, tangent, toEye, depth);
        return radianceOf(fiber, sideNormal(s, tangent, side), light.toKey);
    };
    return addEach(sums, lightings, *scene.rays, hit, s.normal, light, sample, lit);
}

uint addSkin(std::span<vec4> sums, const TracedDocument& scene, const Light& light,
             std::span<const Lighting> lightings, const RayHit& hit, vec3 toEye, SampleId sample) {
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
    const auto lit = [&](const Lighting&, const Reaching* reaching) {
        if (!reaching) return skinRadiance(light, fur.under, base, n, depth);
        return skinColor(fur.under, base, depth) *
               (reaching->sky + vec3(reaching->key * max(0.0f, dot(n, light.toKey))));
    };
    return addEach(sums, lightings, *scene.rays, hit, n, light, sample, lit);
}

}  // namespace

uint addSeen(std::span<vec4> sums, const TracedDocument& scene, const Light& light,
             std::span<const Lighting> lightings, const RayHit& hit, vec3 toEye, SampleId sample) {
    const auto add = hit.onHair ? addHair : addSkin;
    return add(sums, scene, light, lightings, hit, toEye, sample);
}

}  // namespace pelage
