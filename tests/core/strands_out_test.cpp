// strands_out_test.cpp -- hairs as curves.
#include "core/strands_out.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/clumps.h"
#include "core/strand.h"
#include "test_skins.h"

namespace pelage {
namespace {

Document furry(float clump) {
    Document document = test::evenDocument(test::ball(3));
    document.fur = defaultFur();
    document.fur.hairs = 4000;
    document.fur.over.clump = clump;
    document.fur.under.frizz = clump;
    // Density falls from one side of the ball to the other, and is nothing at its end.
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        FurVertex& fur = document.groom.fur.edit(v);
        fur.density = glm::clamp(document.skin->vertices[v].position.x + 0.5f, 0.0f, 1.0f);
        if (v % 7 == 0) fur.furLength = 0.0f;
    }
    return document;
}

Roots rootsOf(const Document& document) {
    Roots roots = scatterRoots(*document.skin, document.fur.hairs, document.fur.seed);
    assignGuides(roots, *document.skin, document.fur);
    return roots;
}

TEST(StrandsOut, CurvesAreTheHairsThatGrowPointByPoint) {
    for (const float clump : {0.0f, 0.7f}) {
        const Document document = furry(clump);
        const Skin& skin = *document.skin;
        const Roots roots = rootsOf(document);
        const uint segments = 5;
        const Curves curves = growCurves(document, roots, segments);
        ASSERT_EQ(curves.pointsPerHair, segments + 1);
        const auto grow = [&](uint i) {
            const Root& root = roots.roots[i];
            const uvec3 t = skin.triangles[root.triangle];
            const auto fur = [&](uint v) { return furToWorld(skin, v, document.groom.fur[v]); };
            const float taper = isOvercoat(root.id, document.fur.share)
                                    ? document.fur.over.taper
                                    : document.fur.under.taper;
            return growStrand(root, skin.vertices[t.x], skin.vertices[t.y], skin.vertices[t.z],
                              fur(t.x), fur(t.y), fur(t.z), document.fur,
                              autoWidth(skin, document.fur.hairs, taper), 0.0f);
        };
        std::size_t k = 0;
        for (const Cluster& cluster : roots.clusters)
            for (uint c = 0; c < cluster.count; ++c) {
                const uint i = cluster.first + c;
                Strand s = grow(i);
                if (!(s.spineLength > 0.0f) || !(cluster.rank(c) < s.keep)) continue;
                ASSERT_LT(k, curves.root.size());
                ASSERT_EQ(curves.root[k], i);
                ASSERT_EQ(curves.rootWidth[k], s.width);
                const Coat& coat = s.coat == 0 ? document.fur.over : document.fur.under;
                const uint guide = roots.roots[i].guide;
                if (guide != i) s = gatherStrand(s, grow(guide), coat);
                for (uint p = 0; p <= segments; ++p) {
                    const float t = static_cast<float>(p) / static_cast<float>(segments);
                    ASSERT_LT(glm::distance(curves.points[k * (segments + 1) + p], strandPoint(s, t)),
                              1e-6f);
                }
                ++k;
            }
        EXPECT_EQ(k, curves.root.size());
        EXPECT_EQ(curves.points.size(), k * (segments + 1));
        EXPECT_GT(k, 1000u);
        EXPECT_LT(k, roots.roots.size());
    }
}

TEST(StrandsOut, NoRootsGiveNoCurves) {
    Document document = furry(0.0f);
    document.fur.hairs = 0;
    const Curves curves = growCurves(document, rootsOf(document), 8);
    EXPECT_TRUE(curves.points.empty());
    EXPECT_TRUE(curves.root.empty());
}

}  // namespace
}  // namespace pelage
