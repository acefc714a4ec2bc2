// strand_plan.cpp -- which hairs a frame draws: cull before you shape.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/render/strand_pass.h"

namespace pelage {
namespace {

constexpr std::size_t kGroupSize = 32;  // local_size_x of strand_raster.comp
constexpr float kLeastShare = 0.01f;    // some hair is drawn at any distance
constexpr float kFadeWindow = 0.4f;     // share of the level of detail over which hairs fade

// Planes of the view volume, pointing inwards, normalised so that they measure metres. Gribb and
// Hartmann, "Fast Extraction of Viewing Frustum Planes", 2001. The near plane is left out: a
// cluster around the eye is always kept.
std::array<vec4, 4> sidePlanes(const mat4& m) {
    const mat4 rows = glm::transpose(m);
    std::array<vec4, 4> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                               rows[3] - rows[1]};
    for (vec4& plane : planes) plane /= std::max(glm::length(vec3(plane)), 1e-30f);
    return planes;
}

bool outside(const std::array<vec4, 4>& planes, vec3 center, float radius) {
    return std::any_of(planes.begin(), planes.end(),
                       [&](const vec4& p) { return glm::dot(vec3(p), center) + p.w < -radius; });
}

}  // namespace

StrandPlan planStrands(const Roots& roots, const FrameData& frame, float rootWidth, float reach,
                       float share, bool byDistance) {
    StrandPlan plan;
    const auto planes = sidePlanes(frame.viewProjection);
    for (const Cluster& cluster : roots.clusters) {
        const float radius = cluster.radius + reach;
        if (outside(planes, cluster.center, radius)) continue;

        float lod = share;
        if (byDistance) {
            const float distance =
                frame.perspective > 0.0f
                    ? std::max(glm::dot(cluster.center - frame.eye, frame.forward), 1e-6f)
                    : 1.0f;
            lod *= std::min(1.0f, rootWidth * frame.pixelsPerMetre / distance);
        }
        lod = std::clamp(lod, kLeastShare, 1.0f);
        const float fade = std::min(1.0f, lod * (1.0f + 0.5f * kFadeWindow));
        const auto wanted = static_cast<uint>(std::ceil(fade * static_cast<float>(cluster.count)));
        const uint count = std::min(wanted, cluster.count);
        if (count == 0) continue;
        const auto run = static_cast<uint>(plan.runs.size());
        plan.runs.push_back({.first = cluster.first,
                             .begin = plan.hairs,
                             .end = plan.hairs + count,
                             .lod = lod,
                             .fade = fade,
                             .phase = cluster.phase,
                             .step = 1.0f / static_cast<float>(cluster.count)});
        plan.hairs += count;
        while (plan.groups.size() * kGroupSize < plan.hairs) plan.groups.push_back({.run = run});
    }
    return plan;
}

}  // namespace pelage
