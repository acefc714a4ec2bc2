// shell_share.cpp -- how much of a coat is better drawn in shells than as strands.
#include "shell_share.h"

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

// s, measured with software OpenGL on two cores at the animal of 2,000 to 100,000 triangles.
constexpr double kPerWork = 5e-8;                                          // for a unit of workOf
constexpr double kPerPixel = 8e-7, kPerVertex = 1.1e-6, kPerFrame = 7e-3;  // of a coat in shells
constexpr double kFacing = 0.5;  // of the hair in the window is not hidden by the skin

// Mean FLIP of a picture full of fur, in shells against strands.
constexpr float kFlipOfShells = 0.3f;

// From 0 at a ratio of 1 to 1 at 2.
float fadeIn(double ratio) {
    const float x = std::clamp(static_cast<float>(std::log2(std::max(ratio, 1e-30))), 0.0f, 1.0f);
    return x * x * (3.0f - 2.0f * x);
}

// Share of the ball around a cluster and its hair that the window shows.
float shareInWindow(const Cluster& cluster, const InSight::Seen& seen, const Sight& sight) {
    const float radius = cluster.radius + 0.5f * seen.pixels * seen.distance / sight.pixelsPerMetre;
    const Outline outline = outlineOf(sight, cluster.center, radius);
    if (!outline.known) return 1.0f;
    const vec2 all = outline.upper - outline.lower;
    const vec2 part = glm::min(outline.upper, vec2(sight.size)) - glm::max(outline.lower, vec2(0));
    if (!(all.x > 0.0f && all.y > 0.0f)) return 0.0f;
    return std::max(part.x, 0.0f) / all.x * std::max(part.y, 0.0f) / all.y;
}

}  // namespace

CoatInView coatInView(const Roots& roots, InSight seen, const Sight& sight, const Pelt& pelt,
                      const Detail& detail, const Fineness& otherwise, float share, float perArea,
                      std::size_t vertices) {
    const FurInView fur = furInView(roots, seen, sight, pelt);
    if (!(fur.share > 0.0f) || !(share > 0.0f)) return {};
    for (InSight::Seen& one : seen.clusters)
        one.hairs *= shareInWindow(roots.clusters[one.cluster], one, sight);
    const float deviation =
        detail.rule == Detail::Rule::flip ? Fidelity().deviationWithin(detail.limit, fur) : 0.0f;
    const double pixels = static_cast<double>(fur.share) * sight.size.x * sight.size.y;
    const float perMetre = fur.pixels / pelt.widest;
    return {.apart = perMetre / std::sqrt(share * perArea),
            .flip = kFlipOfShells * fur.share,
            .strandSeconds = kPerWork * kFacing * static_cast<double>(share) *
                             workOf(seen, sight, pelt, detail, deviation, otherwise),
            .shellSeconds =
                kPerFrame + kPerPixel * pixels + kPerVertex * static_cast<double>(vertices)};
}

float shellShare(const Detail& detail, const CoatInView& coat) {
    if (detail.rule == Detail::Rule::all || !(coat.shellSeconds > 0.0)) return 0.0f;
    const bool flip = detail.rule == Detail::Rule::flip;
    const float allowed = flip || detail.rule == Detail::Rule::pixels ? detail.limit : 1.0f;
    const float error = std::max(flip ? coat.flip : coat.apart, 1e-12f);
    return fadeIn(static_cast<double>(allowed / error)) *
           fadeIn(coat.strandSeconds / coat.shellSeconds);
}

}  // namespace pelage
