// fidelity.cpp -- how coarse a picture may be for the FLIP that is asked for.
#include "fidelity.h"

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

constexpr float kAimed = 0.9f;  // share of the error that is planned
constexpr float kFall = 0.25f;  // of the factor at most, from picture to picture
constexpr float kStep = 1.1f;   // of the factor at least, where a picture missed its error

// Of a picture full of fur. Of thinned hair a share of the hairs is missing and what is left is
// wider; the eye averages thin hairs and sees wide ones. Fitted to pictures of the animal, 0.01 to
// 16 pixels off, with hairs of 0.05 to 1.5 pixels.
float guess(float deviation, float pixels) {
    if (!(deviation > 0.0f)) return 0.0f;
    const float wide = pixels + 2.0f * deviation;
    return 0.25f * std::pow(2.0f * deviation / wide, 0.45f) * std::pow(wide, 0.15f);
}

}  // namespace

FurInView furInView(const Roots& roots, const InSight& seen, const Sight& sight, const Pelt& pelt) {
    const vec2 size(sight.size);
    double area = 0.0, width = 0.0;
    vec2 lower = size, upper(0.0f);  // of the box around all
    for (const InSight::Seen& one : seen.clusters) {
        const Cluster& cluster = roots.clusters[one.cluster];
        const float radius =
            cluster.radius + 0.5f * one.pixels * one.distance / sight.pixelsPerMetre;
        const Outline outline = outlineOf(sight, cluster.center, radius);
        const vec2 low = outline.known ? glm::clamp(outline.lower, vec2(0.0f), size) : vec2(0.0f);
        const vec2 high = outline.known ? glm::clamp(outline.upper, vec2(0.0f), size) : size;
        const double box =
            static_cast<double>(high.x - low.x) * static_cast<double>(high.y - low.y);
        area += box;
        width += box * static_cast<double>(pelt.widest * sight.pixelsPerMetre / one.distance);
        lower = glm::min(lower, low);
        upper = glm::max(upper, high);
    }
    if (!(area > 0.0)) return {};
    // What boxes cover that lie at random in the box around them.
    const double around =
        static_cast<double>(upper.x - lower.x) * static_cast<double>(upper.y - lower.y);
    const double share =
        around / static_cast<double>(size.x * size.y) * -std::expm1(-area / around);
    return {static_cast<float>(share), static_cast<float>(width / area)};
}

float Fidelity::flipAt(float deviation, const FurInView& fur) const {
    return factor_ * fur.share * guess(deviation, fur.pixels);
}

float Fidelity::deviationWithin(float flip, const FurInView& fur) const {
    const auto fits = [&](float deviation) { return flipAt(deviation, fur) <= kAimed * flip; };
    if (fits(kCoarsest)) return kCoarsest;
    if (!fits(kFinest)) return 0.0f;
    float fine = kFinest, coarse = kCoarsest;
    for (int i = 0; i < 16; ++i) {
        const float middle = std::sqrt(fine * coarse);
        (fits(middle) ? fine : coarse) = middle;
    }
    return fine;
}

void Fidelity::learn(float asked, float measured, float deviation, const FurInView& fur) {
    const float guessed = flipAt(deviation, fur) / factor_;
    if (!(guessed > 0.0f)) return;
    const float least = (measured > asked ? kStep : kFall) * factor_;
    factor_ = std::max(measured / guessed, least);
}

}  // namespace pelage
