// clip.cpp -- steps, straight lines, arcs and cubic curves between keys.
#include "clip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace pelage {
namespace {

enum Part : std::size_t { kInTangent, kValue, kOutTangent };

std::span<const float> keyOf(const Track& track, std::size_t key, Part part) {
    const std::size_t at = track.interpolation == Interpolation::cubic ? 3 * key + part : key;
    return {track.values.data() + at * track.width, track.width};
}

glm::dvec4 asVector(std::span<const float> q) { return {q[0], q[1], q[2], q[3]}; }

std::vector<float> asFloats(glm::dvec4 q) {
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
            static_cast<float>(q.w)};
}

// Shoemake, "Animating Rotation with Quaternion Curves", 1985, the short way around.
std::vector<float> arc(std::span<const float> from, std::span<const float> to, double share) {
    const glm::dvec4 a = asVector(from);
    glm::dvec4 b = asVector(to);
    double cosine = glm::dot(a, b) / std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    if (cosine < 0.0) {
        b = -b;
        cosine = -cosine;
    }
    // Close together the arc is straight; keys without a direction have no arc.
    if (!(cosine < 1.0 - 1e-9)) return asFloats(a + share * (b - a));
    const double angle = std::acos(cosine);
    return asFloats((std::sin((1.0 - share) * angle) * glm::normalize(a) +
                     std::sin(share * angle) * glm::normalize(b)) /
                    std::sin(angle));
}

// Hermite curve between two keys that are `seconds` apart; glTF 2.0, appendix C.5.
std::vector<float> curve(const Track& track, std::size_t key, float share, float seconds) {
    const auto a = keyOf(track, key, kValue), b = keyOf(track, key + 1, kValue);
    const auto leave = keyOf(track, key, kOutTangent);
    const auto arrive = keyOf(track, key + 1, kInTangent);
    const float t = share, t2 = t * t, t3 = t2 * t;
    std::vector<float> value(track.width);
    for (std::size_t i = 0; i < value.size(); ++i)
        value[i] = a[i] + (3.0f * t2 - 2.0f * t3) * (b[i] - a[i]) +
                   seconds * ((t3 - 2.0f * t2 + t) * leave[i] + (t3 - t2) * arrive[i]);
    if (track.path != ClipPath::rotation) return value;
    const glm::dvec4 q = asVector(value);
    const double length = glm::length(q);
    if (!(length > 1e-6)) return {a.begin(), a.end()};
    return asFloats(q / length);
}

}  // namespace

std::vector<float> valueAt(const Track& track, float seconds) {
    const std::vector<float>& times = track.times;
    assert(!times.empty());
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    const auto next = static_cast<std::size_t>(after - times.begin());
    const std::size_t key = next == 0 ? 0 : next - 1;
    const auto a = keyOf(track, key, kValue);
    const bool between = next > 0 && next < times.size() && seconds > times[key];
    if (!between || track.interpolation == Interpolation::step) return {a.begin(), a.end()};

    const float gap = times[next] - times[key];
    const float share = (seconds - times[key]) / gap;
    if (track.interpolation == Interpolation::cubic) return curve(track, key, share, gap);
    const auto b = keyOf(track, next, kValue);
    if (track.path == ClipPath::rotation) return arc(a, b, share);
    std::vector<float> value(track.width);
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = a[i] + share * (b[i] - a[i]);
    return value;
}

}  // namespace pelage
