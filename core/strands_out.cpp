// strands_out.cpp -- every hair of a document as a polyline.
#include "strands_out.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

namespace pelage {

// Functions of their own, not those of strand.h: the compiler then leaves out what a polyline does
// not need of a hair, which makes the loop a fifth faster.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace {
#include "strand_source.h"
}  // namespace
#pragma GCC diagnostic pop

namespace {

// The points of a hair, root first. What is not shaped is known to be its spine.
void trace(const Strand& s, bool shaped, uint points, vec3* out) {
    const float step = 1.0f / static_cast<float>(points - 1);
    for (uint p = 0; p < points; ++p) {
        const float t = p + 1 < points ? static_cast<float>(p) * step : 1.0f;
        out[p] = shaped ? strandPoint(s, t) : spinePoint(s, t);
    }
}

}  // namespace

Curves growCurves(const Document& document, const Roots& roots, uint segments, float seconds) {
    assert(segments >= 1 && segments <= 64);
    const Skin& skin = *document.skin;
    const Fur& fur = document.fur;
    const float overWidth = autoWidth(skin, fur.hairs, fur.over.taper);
    const float underWidth = autoWidth(skin, fur.hairs, fur.under.taper);

    std::vector<FurVertex> painted(skin.vertices.size());
    tbb::parallel_for(tbb::blocked_range<uint>(0, static_cast<uint>(painted.size()), 4096),
                      [&](const auto& range) {
                          for (uint v = range.begin(); v < range.end(); ++v)
                              painted[v] = furToWorld(skin, v, document.groom.fur[v]);
                      });
    const auto spine = [&](const Root& root) {
        const uvec3 t = skin.triangles[root.triangle];
        return growStrand(root, skin.vertices[t.x], skin.vertices[t.y], skin.vertices[t.z],
                          painted[t.x], painted[t.y], painted[t.z], fur,
                          isOvercoat(root.id, fur.share) ? overWidth : underWidth, seconds);
    };
    const auto grow = [&](std::size_t i) {
        const Root& root = roots.roots[i];
        Strand s = spine(root);
        const Coat& coat = s.coat == 0 ? fur.over : fur.under;
        if (coat.clump > 0.0f && root.guide != i)
            s = gatherStrand(s, spine(roots.roots[root.guide]), coat);
        return s;
    };
    const bool shaped = isShapedCoat(fur.over) || isShapedCoat(fur.under);

    // Every hair has its place by its root; those that do not grow are squeezed out afterwards.
    Curves curves;
    const uint points = segments + 1;
    const std::size_t count = roots.roots.size();
    curves.pointsPerHair = points;
    curves.points.resize(count * points);
    curves.rootWidth.resize(count);
    curves.root.resize(count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, roots.clusters.size(), 4), [&](const auto& range) {
        for (std::size_t c = range.begin(); c < range.end(); ++c) {
            const Cluster& cluster = roots.clusters[c];
            for (uint k = 0; k < cluster.count; ++k) {
                const std::size_t i = cluster.first + k;
                const Strand s = shaped ? grow(i) : spine(roots.roots[i]);
                const bool grows = s.spineLength > 0.0f && cluster.rank(k) < s.keep;
                curves.rootWidth[i] = grows ? s.width : -1.0f;
                curves.root[i] = static_cast<uint>(i);
                if (grows) trace(s, shaped, points, &curves.points[i * points]);
            }
        }
    });

    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (curves.rootWidth[i] < 0.0f) continue;
        if (kept != i) {
            std::copy_n(curves.points.begin() + static_cast<std::ptrdiff_t>(i * points), points,
                        curves.points.begin() + static_cast<std::ptrdiff_t>(kept * points));
            curves.rootWidth[kept] = curves.rootWidth[i];
            curves.root[kept] = curves.root[i];
        }
        ++kept;
    }
    curves.points.resize(kept * points);
    curves.rootWidth.resize(kept);
    curves.root.resize(kept);
    return curves;
}

}  // namespace pelage
