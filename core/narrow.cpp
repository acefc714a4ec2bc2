// narrow.cpp -- rays through the body, and fits to one-rings.
#include "narrow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "strand.h"

namespace pelage {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr int kMostCrossings = 64;
constexpr double kFlatDetail = 1e-4;  // of the skin's size
constexpr double kRidge = 1e-3;       // share of the squared edges
constexpr float kOnTop = 1e-6f;       // of the skin's size; nearer faces lie on the vertex

bool isFinite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

float largestOf(vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Whether a ray leaves the body here. The side on which the hair grows decides, not the winding: it
// may be the other way round in a mirrored part.
bool leaves(const Skin& skin, const SkinHit& hit, vec3 direction) {
    const uvec3 corners = skin.triangles[hit.triangle];
    const vec3 outside = skin.vertices[corners.x].normal + skin.vertices[corners.y].normal +
                         skin.vertices[corners.z].normal;
    // The normal of a hit is turned against the ray.
    const float along = glm::dot(outside, hit.normal);
    return along != 0.0f ? along < 0.0f : glm::dot(outside, direction) > 0.0f;
}

}  // namespace

float thicknessAt(const SkinQuery& query, uint v, float farthest) {
    const Skin& skin = query.skin();
    const SkinVertex& vertex = skin.vertices[v];
    if (vertex.normal == vec3(0.0f) || !isFinite(vertex.normal) || !isFinite(vertex.position))
        return kInfinite;
    const vec3 inwards = -vertex.normal;
    // At least some steps of the numbers that positions are made of.
    const float step = std::max(kOnTop * skin.size(), 1e-6f * largestOf(vertex.position));
    int depth = 1;  // bodies around the ray
    float passed = step;
    for (int crossing = 0; crossing < kMostCrossings; ++crossing) {
        const auto hit = query.cast(vertex.position + passed * inwards, inwards);
        if (!hit || !(passed + hit->distance <= farthest)) return kInfinite;
        passed += hit->distance;
        const uvec3 corners = skin.triangles[hit->triangle];
        const bool own = corners.x == v || corners.y == v || corners.z == v;
        if (!own) depth += leaves(skin, *hit, inwards) ? -1 : 1;
        if (depth == 0) return passed;
        passed += step;
    }
    return kInfinite;
}

float curvatureAt(const Skin& skin, uint v) {
    const SkinVertex& here = skin.vertices[v];
    if (here.normal == vec3(0.0f)) return 0.0f;
    const vec3 tangent = anyTangent(here.normal);
    const glm::dvec3 x(tangent), y(glm::cross(here.normal, tangent));

    // The symmetric shape operator (a b; b c) takes an edge to the change of the normal along it.
    double xx = 0.0, yy = 0.0, xy = 0.0;                  // sums of edge x edge
    double towardsX = 0.0, towardsY = 0.0, across = 0.0;  // sums of edge x change of normal
    for (const uint u : skin.ring(v)) {
        const SkinVertex& there = skin.vertices[u];
        if (there.normal == vec3(0.0f)) continue;
        const glm::dvec3 edge = glm::dvec3(there.position) - glm::dvec3(here.position);
        const glm::dvec3 change = glm::dvec3(there.normal) - glm::dvec3(here.normal);
        const double p = glm::dot(edge, x), q = glm::dot(edge, y);
        const double s = glm::dot(change, x), t = glm::dot(change, y);
        xx += p * p;
        yy += q * q;
        xy += p * q;
        towardsX += p * s;
        towardsY += q * t;
        across += q * s + p * t;
    }
    // A ridge makes the least of what the edges hardly tell.
    const double detail = kFlatDetail * static_cast<double>(skin.size());
    const double ridge = detail * detail + kRidge * (xx + yy);
    xx += ridge;
    yy += ridge;
    // The normal equations
    //   xx a        + xy b = towardsX
    //   xy a + (xx + yy) b + xy c = across
    //          xy b + yy c = towardsY
    // by elimination of a and c.
    const double b = (across - xy * towardsX / xx - xy * towardsY / yy) /
                     (xx + yy - xy * xy / xx - xy * xy / yy);
    const double a = (towardsX - xy * b) / xx;
    const double c = (towardsY - xy * b) / yy;
    const double mean = 0.5 * std::abs(a + c);
    return std::isfinite(mean) ? static_cast<float>(mean) : 0.0f;
}

}  // namespace pelage
