// tuft.cpp -- the hair of a cluster as a whole.
#include "tuft.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace pelage {
namespace {

constexpr float kPi = 3.14159265f;

// The cone around the mean of unit vectors that holds them; everything where they are scattered.
Cone coneOf(std::span<const vec3> directions) {
    vec3 sum(0.0f);
    for (const vec3& d : directions) sum += d;
    if (!(glm::dot(sum, sum) > 0.0f)) return {};
    const vec3 axis = glm::normalize(sum);
    float least = 1.0f;
    for (const vec3& d : directions) least = std::min(least, glm::dot(d, axis));
    // What lies between directions is in the cone only where it is convex.
    return least > 0.0f ? Cone::of(axis, std::acos(std::min(least, 1.0f)) + 1e-3f) : Cone{};
}

float halfAngle(const Cone& cone) { return std::acos(std::clamp(cone.cosine, -1.0f, 1.0f)); }

float angleBetween(vec3 a, vec3 b) { return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)); }

// How much the direction of a coat's hair may turn away from those at the corners of triangles.
float turnOf(const Coat& coat, const Cone& normals, const Cone& corners, float shortestMix) {
    if (!(normals.cosine > 0.0f) || !(corners.cosine > 0.0f) || coat.endRandomness >= 1.0f)
        return kPi;
    if (coat.droop == kDroopElastica) return kPi;  // a rod may hang down
    // The normal is made unit between the corners, the painted direction is not.
    const float longer = (1.0f - coat.directionWeight) * (1.0f / normals.cosine - 1.0f);
    const float between = longer / std::max(shortestMix * corners.cosine, 1e-6f);
    // What would lie below the skin is mirrored to above it.
    const float below = angleBetween(normals.axis, corners.axis) + halfAngle(normals) - 0.5f * kPi;
    return std::asin(std::min(between, 1.0f)) + std::asin(std::max(coat.endRandomness, 0.0f)) +
           2.0f * std::max(below, 0.0f);
}

float floppinessOf(const Coat& coat) { return std::clamp(1.0f - coat.stiffness, 0.02f, 1.0f); }

bool grows(const Fur& fur, uint bit) {
    return (bit == 1 ? fur.share : 1.0f - fur.share) > 0.0f &&
           (bit == 1 ? fur.over : fur.under).relativeLength > 0.0f;
}

// Strength of what pulls at the softest hair, relative to its direction where it leaves the skin; a
// little of it goes to the combed side.
float loadOf(const Fur& fur, const Coat& coat) {
    const float pull = std::min(fur.gravity + fur.wind * (1.0f + fur.gusts), 1.0f);
    return std::min(1.02f * pull * floppinessOf(coat), 1.0f);
}

// Where hair is pulled; zero where wind may turn it.
vec3 pullOf(const Fur& fur) { return fur.wind > 0.0f ? vec3(0.0f) : fur.gravityDirection; }

// The least length of a unit vector of the cone plus up to `load` along `pull`.
float shortestUnder(const Cone& leaving, float load, vec3 pull) {
    if (!(glm::dot(pull, pull) > 0.0f)) return 1.0f - load;
    const float cosine = -leaving.along(-pull);  // of the largest angle between them
    if (cosine >= 0.0f) return 1.0f;
    if (-cosine <= load) return std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
    return std::sqrt(std::max(1.0f + 2.0f * load * cosine + load * load, 0.0f));
}

}  // namespace

Cone Cone::of(vec3 axis, float halfAngle) {
    if (!(halfAngle < kPi)) return {};
    return {axis, std::cos(halfAngle), std::sin(halfAngle)};
}

float Cone::along(vec3 direction) const {
    const float c = glm::dot(axis, direction);
    return c >= cosine ? 1.0f : c * cosine + std::sqrt(std::max(1.0f - c * c, 0.0f)) * sine;
}

Tuft tuftOf(const Cluster& cluster, const Skin& skin, const Chunked<FurVertex>& painted,
            const Fur& fur) {
    Tuft tuft;
    std::vector<vec3> normals, combed;
    for (const uint t :
         std::span(skin.spatialOrder).subspan(cluster.firstTriangle, cluster.triangleCount))
        for (int c = 0; c < 3; ++c) {
            const uint v = skin.triangles[t][c];
            const FurVertex here = furToWorld(skin, v, painted[v]);
            tuft.longest = std::max(tuft.longest, here.furLength);
            tuft.densest = std::max(tuft.densest, std::min(here.density, 1.0f));
            normals.push_back(skin.vertices[v].normal);
            combed.push_back(here.direction);
        }
    tuft.normals = coneOf(normals);
    std::vector<vec3> leaving;
    float turn = 0.0f, load = 0.0f;
    for (const uint bit : {1u, 2u}) {
        if (!grows(fur, bit)) continue;
        Coat coat = bit == 1 ? fur.over : fur.under;
        load = std::max(load, loadOf(fur, coat));
        std::vector<vec3> ofCoat;
        float shortest = 1.0f;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const vec3 mix = glm::mix(normals[i], combed[i], coat.directionWeight);
            const float length = glm::length(mix);
            shortest = std::min(shortest, length);
            ofCoat.push_back(length > 0.0f ? mix / length : normals[i]);
        }
        turn = std::max(turn, turnOf(coat, tuft.normals, coneOf(ofCoat), shortest));
        leaving.insert(leaving.end(), ofCoat.begin(), ofCoat.end());
    }
    const Cone corners = coneOf(leaving);
    const float half = halfAngle(corners) + turn;
    tuft.leaving = Cone::of(corners.axis, half);
    tuft.tips = Cone::of(corners.axis, half + std::asin(load));
    tuft.shortest = shortestUnder(tuft.leaving, load, pullOf(fur));
    return tuft;
}

bool combsAlike(const Fur& a, const Fur& b) {
    const auto alike = [](const Coat& x, const Coat& y) {
        return x.stiffness == y.stiffness && x.endRandomness == y.endRandomness &&
               x.directionWeight == y.directionWeight && x.droop == y.droop &&
               (x.relativeLength > 0.0f) == (y.relativeLength > 0.0f);
    };
    return alike(a.over, b.over) && alike(a.under, b.under) &&
           a.gravityDirection == b.gravityDirection && a.gravity == b.gravity && a.wind == b.wind &&
           a.gusts == b.gusts && (a.share > 0.0f) == (b.share > 0.0f) &&
           (a.share < 1.0f) == (b.share < 1.0f);
}

float reachAlong(const Tuft& tuft, const Pelt& pelt, vec3 direction) {
    // Hair grows on the outer side of the skin.
    const float facing = tuft.normals.along(direction);
    const float outer = facing >= 0.0f ? 1.0f : std::sqrt(std::max(1.0f - facing * facing, 0.0f));
    const float most = std::max(pelt.reach() * tuft.longest, pelt.clumpReach) * outer;
    if (pelt.clumpReach > 0.0f) return most;
    // A hair lies between its root, where it leaves to, and its tip.
    const float leaving = std::max(tuft.leaving.along(direction), 0.0f);
    const bool steady = glm::dot(pelt.pull, pelt.pull) > 0.0f;
    const float pulled = steady ? std::max(glm::dot(pelt.pull, direction), 0.0f) + 0.02f : 1.0f;
    const float tip = std::min(std::max(tuft.tips.along(direction), 0.0f),
                               (leaving + pelt.load * pulled) / std::max(tuft.shortest, 1e-6f));
    const float along = std::max(leaving, std::min(tip, 1.0f));
    return std::min(most, (pelt.length * along + pelt.aside) * tuft.longest);
}

Pelt peltOf(const Fur& fur, uint coats, float overWidth, float underWidth, double area,
            float longest) {
    Pelt pelt;
    pelt.meanWidth = fur.share * overWidth + (1.0f - fur.share) * underWidth;
    pelt.pull = pullOf(fur);
    for (const uint bit : {1u, 2u}) {
        if (!(coats & bit) || !grows(fur, bit)) continue;
        const Coat& coat = bit == 1 ? fur.over : fur.under;
        pelt.coats |= bit;
        pelt.widest = std::max(pelt.widest, bit == 1 ? overWidth : underWidth);
        pelt.length = std::max(pelt.length, coat.relativeLength);
        // Frizz goes in two directions.
        pelt.aside = std::max(
            pelt.aside, coat.relativeLength * (coat.curlRadius + std::sqrt(2.0f) * coat.frizz));
        if (coat.clump > 0.0f && fur.hairs > 0) {
            const float share = bit == 1 ? fur.share : 1.0f - fur.share;
            const double perClump = static_cast<double>(std::max(coat.clumpSize, 1.0f)) * area /
                                    (static_cast<double>(share) * fur.hairs);
            // A guide is in the next cell at most.
            const float away = 4.0f * static_cast<float>(std::sqrt(perClump));
            pelt.clumpReach = std::max(pelt.clumpReach, away + pelt.reach() * longest);
        }
        pelt.load = std::max(pelt.load, loadOf(fur, coat));
        if (coat.style != kStyleLine)
            pelt.bend = std::max(pelt.bend, 2.0f * std::sin(0.5f * std::asin(loadOf(fur, coat))));
    }
    return pelt;
}

}  // namespace pelage
