// strands_out.cpp -- every hair of a document as a polyline.
#include "strands_out.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>
#include <numeric>

// A fifth faster than by calls of strand.h.
#include "strand_inline.h"

namespace pelage {
namespace {

bool grows(const Growth& growth, const Cluster& cluster, uint k) {
    const Root& root = growth.roots.roots[cluster.first + k];
    const uvec3 t = growth.skin.triangles[root.triangle];
    const FurVertex &a = growth.painted[t.x], &b = growth.painted[t.y], &c = growth.painted[t.z];
    return cluster.rank(k) < keepAt(root, a.density, b.density, c.density) &&
           lengthAt(root, a.furLength, b.furLength, c.furLength, growth.fur) > 0.0f;
}

bool hasRods(const Fur& fur) { return isRodCoat(fur.over) || isRodCoat(fur.under); }

template <bool kRod>
Strand spine(const Growth& growth, const Root& root) {
    assert(kRod || !hasRods(growth.fur));  // from which the compiler sees what it may leave out
    const uvec3 t = growth.skin.triangles[root.triangle];
    const auto& vertices = growth.skin.vertices;
    return growStrand(root, vertices[t.x], vertices[t.y], vertices[t.z], growth.painted[t.x],
                      growth.painted[t.y], growth.painted[t.z], growth.fur,
                      isOvercoat(root.id, growth.fur.share) ? growth.overWidth : growth.underWidth,
                      growth.seconds);
}

template <bool kRod>
Strand gathered(const Growth& growth, uint i) {
    const Root& root = growth.roots.roots[i];
    const Strand s = spine<kRod>(growth, root);
    const Coat& coat = s.coat == 0 ? growth.fur.over : growth.fur.under;
    if (!(coat.clump > 0.0f) || root.guide == i) return s;
    return gatherStrand(s, spine<kRod>(growth, growth.roots.roots[root.guide]), coat);
}

// The curves of a cluster from number `next` on. Coats that do not shape their hair, or have no
// rods, have functions of their own, in which the compiler sees that the spine is all there is;
// flat, so that it sees through all calls which parts of a hair nobody asks for.
template <bool kShaped, bool kRod>
[[gnu::flatten]] void growCluster(const Growth& growth, const Cluster& cluster,
                                  const std::vector<char>& growing, std::size_t next,
                                  Curves& curves) {
    const uint points = curves.pointsPerHair;
    const float step = 1.0f / static_cast<float>(points - 1);
    for (uint k = 0; k < cluster.count; ++k) {
        const uint i = cluster.first + k;
        if (!growing[i]) continue;
        Strand s = kShaped ? gathered<kRod>(growth, i) : spine<kRod>(growth, growth.roots.roots[i]);
        if (!kRod) s.droop = kDroopPaper;
        curves.rootWidth[next] = s.width;
        curves.root[next] = i;
        vec3* out = &curves.points[next++ * points];
        for (uint p = 0; p < points; ++p) {
            const float t = p + 1 < points ? static_cast<float>(p) * step : 1.0f;
            out[p] = kShaped ? strandPoint(s, t) : spinePoint(s, t);
        }
    }
}

}  // namespace

Growth growthOf(const Document& document, const Roots& roots, float seconds) {
    const Skin& skin = *document.skin;
    const Fur& fur = document.fur;
    Growth growth{skin,
                  fur,
                  roots,
                  std::vector<FurVertex>(skin.vertices.size()),
                  coatWidth(skin, fur.hairs, fur.over),
                  coatWidth(skin, fur.hairs, fur.under),
                  seconds};
    tbb::parallel_for(tbb::blocked_range<uint>(0, static_cast<uint>(skin.vertices.size()), 4096),
                      [&](const auto& range) {
                          for (uint v = range.begin(); v < range.end(); ++v)
                              growth.painted[v] = furToWorld(skin, v, document.groom.fur[v]);
                      });
    return growth;
}

Strand grownStrand(const Growth& growth, uint root) {
    return hasRods(growth.fur) ? gathered<true>(growth, root) : gathered<false>(growth, root);
}

Curves growCurves(const Document& document, const Roots& roots, uint segments, float seconds) {
    return growCurves(growthOf(document, roots, seconds), segments);
}

Curves growCurves(const Growth& growth, uint segments) {
    assert(segments >= 1 && segments <= 64);
    const Roots& roots = growth.roots;
    const Fur& fur = growth.fur;
    // First which of them grow and how many of each cluster, then the hairs, each at its place.
    const tbb::blocked_range<std::size_t> clusters(0, roots.clusters.size(), 8);
    std::vector<char> growing(roots.roots.size());
    std::vector<std::size_t> first(roots.clusters.size() + 1, 0);
    tbb::parallel_for(clusters, [&](const auto& range) {
        for (std::size_t c = range.begin(); c < range.end(); ++c) {
            const Cluster& cluster = roots.clusters[c];
            for (uint k = 0; k < cluster.count; ++k) {
                growing[cluster.first + k] = grows(growth, cluster, k);
                first[c + 1] += static_cast<std::size_t>(growing[cluster.first + k]);
            }
        }
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    Curves curves;
    curves.pointsPerHair = segments + 1;
    curves.points.resize(first.back() * curves.pointsPerHair);
    curves.rootWidth.resize(first.back());
    curves.root.resize(first.back());
    const bool shaped = isShapedCoat(fur.over) || isShapedCoat(fur.under), rods = hasRods(fur);
    const auto grow = shaped ? (rods ? growCluster<true, true> : growCluster<true, false>)
                             : (rods ? growCluster<false, true> : growCluster<false, false>);
    tbb::parallel_for(clusters, [&](const auto& range) {
        for (std::size_t c = range.begin(); c < range.end(); ++c)
            grow(growth, roots.clusters[c], growing, first[c], curves);
    });
    return curves;
}

}  // namespace pelage
