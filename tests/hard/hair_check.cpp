// hair_check.cpp -- a hair, its curve, its root and its rank, each against what is promised.
#include "hair_check.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

#include "core/clumps.h"
#include "core/strands_out.h"
#include "test_skins.h"

namespace pelage::test {
namespace {

constexpr int kPlaces = 8;          // looked at along a hair, besides its root
constexpr double kRounding = 4e-7;  // of three sums of floats
constexpr float kSeconds = 1.7f;    // of wind
constexpr uint kSegments = 3;       // of curves

bool finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <class... Parts>
std::string text(const Parts&... parts) {
    std::ostringstream out;
    out.precision(9);
    (out << ... << parts);
    return out.str();
}

// How far from its root the hair at t can be, whatever its modifiers do.
double reachAt(const Strand& s, float t) {
    const double k = s.clump > 0.0f ? s.clump * std::pow(t, s.clumpShape) : 0.0;
    const vec2 along = strandWeights(t);
    const double guide = glm::length(s.guideOffset) + along.x * glm::length(s.guideWeightless) +
                         along.y * glm::length(s.guideEnd);
    return (1.0 - k) * s.spineLength + k * guide + t * (s.curl + 1.5 * s.frizz);
}

std::string lengthFault(Strand s, const Coat& coat, Worst& worst) {
    s.clump = s.curl = s.frizz = 0.0f;
    // Chords are too short by c/N^2: two sums tell the length without c.
    const double coarse = chordLength(s, 16), fine = chordLength(s, 32);
    const double found = fine + (fine - coarse) / 3.0;
    const double helix =
        coat.curlRadius > 0.0f ? arcOfHelix(coat.curlRadius, coat.curlTurns) : 1.0f;
    const double error = std::abs(found * helix / s.spineLength - 1.0);
    worst.length = std::max(worst.length, error);
    return error <= kLengthBound
               ? ""
               : text("its spine is ", found, " m long, asked ", s.spineLength, " / ", helix);
}

std::string pointFault(const Strand& s, float t, Worst& worst) {
    const vec3 p = strandPoint(s, t);
    if (!finite(p)) return text("not finite at t = ", t);
    const double reach = reachAt(s, t);
    if (!(glm::length(glm::dvec3(p)) <= reach * 1.0001))
        return text("out of reach at t = ", t, ": ", glm::length(p), " of ", reach);
    const double depth = -glm::dot(glm::dvec3(p), glm::dvec3(s.normal)) / std::max(reach, 1e-30);
    worst.depth = std::max(worst.depth, depth);
    if (!(depth <= kDepthBound)) return text("under the skin at t = ", t, " by ", depth, " reach");

    const vec3 tangent = strandTangent(s, t), normal = strandNormal(s, tangent);
    const double off = std::max(std::abs(glm::length(glm::dvec3(tangent)) - 1.0),
                                std::abs(glm::length(glm::dvec3(normal)) - 1.0));
    worst.unit = std::max(worst.unit, off);
    return off <= kUnitBound ? "" : text("tangent or normal not unit at t = ", t, ": ", off);
}

// The place of a root in doubles, and what is wrong with it.
std::string placeFault(const Skin& skin, const Root& root, vec3 origin) {
    const double k[3] = {(root.bary & 65535u) / 65535.0, (root.bary >> 16) / 65535.0,
                         1.0 - (root.bary & 65535u) / 65535.0 - (root.bary >> 16) / 65535.0};
    if (k[2] < -1e-9) return "outside its triangle";
    glm::dvec3 place(0.0);
    double size = 0.0;
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 corner(skin.vertices[skin.triangles[root.triangle][c]].position);
        place += k[c] * corner;
        size = std::max(size, glm::length(corner));
    }
    const double off = glm::distance(place, glm::dvec3(origin));
    return off <= kRounding * size ? "" : text("off its triangle by ", off, " m");
}

std::string curvesFault(const Document& document, const Roots& roots,
                        const std::vector<Strand>& hairs) {
    const Curves curves = growCurves(document, roots, kSegments, kSeconds);
    std::size_t next = 0;
    for (const Cluster& cluster : roots.clusters)
        for (uint k = 0; k < cluster.count; ++k) {
            const uint i = cluster.first + k;
            const Strand& s = hairs[i];
            if (!(cluster.rank(k) < s.keep && s.spineLength > 0.0f)) continue;
            if (next >= curves.root.size() || curves.root[next] != i)
                return text("curve ", next, " is not that of hair ", i);
            const vec3* points = &curves.points[next++ * curves.pointsPerHair];
            if (points[0] != s.origin) return text("curve of hair ", i, " starts off its root");
            if (!std::isfinite(curves.rootWidth[next - 1])) return text("width of hair ", i);
            if (!std::all_of(points, points + curves.pointsPerHair, finite))
                return text("curve of hair ", i, " is not finite");
        }
    return next == curves.root.size() ? "" : text(curves.root.size(), " curves for ", next);
}

std::string guideFault(const Roots& roots, const Fur& fur, uint i) {
    const uint guide = roots.roots[i].guide;
    if (guide >= roots.roots.size()) return text("guide ", guide, " of ", roots.roots.size());
    const auto over = [&](uint k) { return isOvercoat(roots.roots[k].id, fur.share); };
    if (over(guide) != over(i)) return "gathers to hair of the other coat";
    return "";
}

}  // namespace

void print(const Worst& worst) {
    std::cout << worst.hairs << " hairs, " << worst.clumped << " in clumps; worst: length "
              << worst.length << ", depth " << worst.depth << ", unit " << worst.unit << "\n";
}

double chordLength(Strand s, int chords) {
    s.origin = vec3(0.0f);
    double sum = 0.0;
    glm::dvec3 before(0.0);
    for (int i = 1; i <= chords; ++i) {
        const glm::dvec3 p(strandPoint(s, static_cast<float>(i) / static_cast<float>(chords)));
        sum += glm::distance(before, p);
        before = p;
    }
    return sum;
}

std::string faultOf(const Strand& hair, const Coat& coat, Worst& worst) {
    if (!finite(hair.origin)) return "root not finite";
    if (strandPoint(hair, 0.0f) != hair.origin) return "starts off its root";
    const double off = std::abs(glm::length(glm::dvec3(hair.normal)) - 1.0);
    if (!(off <= kUnitBound)) return "skin normal not unit";
    if (!(hair.width >= 0.0f && std::isfinite(hair.width))) return text("width ", hair.width);
    if (!(hair.keep >= 0.0f && hair.keep <= 1.0f)) return text("density ", hair.keep);
    if (!(hair.spineLength >= 0.0f)) return text("length ", hair.spineLength);
    if (hair.spineLength == 0.0f) return "";  // no hair
    Strand s = hair;
    s.origin = vec3(0.0f);
    for (int i = 0; i <= kPlaces; ++i) {
        const std::string fault =
            pointFault(s, static_cast<float>(i) / static_cast<float>(kPlaces), worst);
        if (!fault.empty()) return fault;
    }
    ++worst.hairs;
    if (s.clump > 0.0f) ++worst.clumped;
    return lengthFault(s, coat, worst);
}

std::string faultOf(const Skin& skin, const Roots& roots, uint hairs) {
    std::vector<uint> counts(skin.triangles.size(), 0);
    for (const Root& root : roots.roots) ++counts[root.triangle];
    double variance = 0.0;
    for (uint t = 0; t < counts.size(); ++t) {
        const double expected = skin.area > 0.0 ? hairs / skin.area * skin.areas[t] : 0.0;
        const double part = expected - std::floor(expected);
        if (counts[t] < std::floor(expected) || counts[t] > std::ceil(expected))
            return text("triangle ", t, " has ", counts[t], " hairs, expected ", expected);
        variance += part * (1.0 - part);
    }
    const double wanted = skin.area > 0.0 ? hairs : 0.0;
    const double excess = std::abs(static_cast<double>(roots.roots.size()) - wanted);
    if (!(excess <= 4.0 * std::sqrt(variance) + 1e-3))
        return text(roots.roots.size(), " roots for ", wanted, ", sigma ", std::sqrt(variance));

    uint next = 0;
    for (const Cluster& cluster : roots.clusters) {
        if (cluster.first != next) return text("cluster starts at ", cluster.first);
        next += cluster.count;
        float before = -1.0f;
        for (uint k = 0; k < cluster.count; ++k) {
            const float rank = cluster.rank(k);
            if (!(rank > before && rank >= 0.0f && rank < 1.0f))
                return text("rank ", rank, " after ", before, ", ", k, " of ", cluster.count);
            before = rank;
        }
    }
    return next == roots.roots.size() ? "" : text("clusters hold ", next, " roots");
}

Roots rootsOf(const Document& document, int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    Roots roots = scatterRoots(*document.skin, document.fur.hairs, document.fur.seed);
    assignGuides(roots, *document.skin, document.fur);
    return roots;
}

bool sameRoots(const Roots& a, const Roots& b) {
    return sameBits(a.roots, b.roots) && sameBits(a.clusters, b.clusters);
}

std::string faultOf(const Document& document, Worst& worst) {
    const Skin& skin = *document.skin;
    const Fur& fur = document.fur;
    const Roots roots = rootsOf(document, 1);
    if (!sameRoots(roots, rootsOf(document, 2))) return "two threads make other roots than one";
    const std::string fault = faultOf(skin, roots, fur.hairs);
    if (!fault.empty()) return fault;

    std::vector<FurVertex> painted(skin.vertices.size());
    for (uint v = 0; v < painted.size(); ++v)
        painted[v] = furToWorld(skin, v, document.groom.fur[v]);
    std::vector<Strand> spines, hairs;
    for (const Root& root : roots.roots) {
        const uvec3 t = skin.triangles[root.triangle];
        spines.push_back(growStrand(root, skin.vertices[t.x], skin.vertices[t.y],
                                    skin.vertices[t.z], painted[t.x], painted[t.y], painted[t.z],
                                    fur, 1e-4f, kSeconds));
    }
    for (uint i = 0; i < spines.size(); ++i) {
        const Root& root = roots.roots[i];
        const Coat& coat = spines[i].coat == 0 ? fur.over : fur.under;
        std::string wrong = guideFault(roots, fur, i);
        if (wrong.empty()) wrong = placeFault(skin, root, spines[i].origin);
        if (wrong.empty()) {
            const bool gathers = coat.clump > 0.0f && root.guide != i;
            hairs.push_back(gathers ? gatherStrand(spines[i], spines[root.guide], coat)
                                    : spines[i]);
            wrong = faultOf(hairs.back(), coat, worst);
        }
        if (!wrong.empty()) return text("hair ", i, " of triangle ", root.triangle, ": ", wrong);
    }
    return curvesFault(document, roots, hairs);
}

}  // namespace pelage::test
