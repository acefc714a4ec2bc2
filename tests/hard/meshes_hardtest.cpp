// meshes_hardtest.cpp -- hair on broken, huge, tiny, far and distorted meshes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/animal.h"
#include "core/subdivide.h"
#include "core/transfer.h"
#include "hair_check.h"
#include "hard_cases.h"

namespace pelage {
namespace {

using test::Worst;

TEST(HardMeshes, HairGrowsRightOnEachOfThem) {
    Worst worst;
    for (test::HardMesh& mesh : test::hardMeshes()) {
        const auto skin = makeSkin(std::move(mesh.source));
        test::Draws draws(3);
        for (int i = 0; i < 4; ++i) {
            Document document{skin, test::drawnGroom(*skin, skin->size(), draws), defaultFur()};
            if (i > 0) document.fur = test::drawnFur(draws);
            document.fur.over.clump = 0.5f * static_cast<float>(i % 3);
            document.fur.hairs = 3000;
            EXPECT_EQ(test::faultOf(document, worst), "") << mesh.name << ", fur " << i;
        }
    }
    test::print(worst);
}

TEST(HardMeshes, AMillionTriangles) {
    Document document = test::evenDocument(makeAnimal(1'000'000));
    document.fur.hairs = 200'000;  // most triangles have none
    document.fur.over.clump = document.fur.under.clump = 0.7f;
    Worst worst;
    EXPECT_EQ(test::faultOf(document, worst), "");
    EXPECT_GT(worst.hairs, 199'000u);
}

TEST(HardMeshes, AMillionHairsOnOneTriangle) {
    Document document =
        test::evenDocument(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, 1, 2}}));
    document.fur.hairs = 1'000'000;
    document.fur.over.clump = 1.0f;
    const Roots roots = test::rootsOf(document, 1);
    EXPECT_EQ(test::faultOf(*document.skin, roots, document.fur.hairs), "");
    EXPECT_TRUE(test::sameRoots(roots, test::rootsOf(document, 2)));
    EXPECT_EQ(roots.roots.size(), 1'000'000u);
}

TEST(HardMeshes, EachOfThemCanBeSubdividedAndTakesItsGroomBack) {
    for (test::HardMesh& mesh : test::hardMeshes()) {
        SCOPED_TRACE(mesh.name);
        const Document before = openDocument(std::move(mesh.source));
        const Document after = subdivided(before, 2);
        const Source& source = *after.skin->source;
        EXPECT_EQ((MeshSize{source.positions.size(), source.triangles.size()}),
                  sizesAfterCuts(*before.skin->source, 2).back());
        const vec3 slack(1e-5f * before.skin->size());
        for (const uvec3 t : after.skin->triangles) {
            for (int k = 0; k < 3; ++k) {
                const vec3 p = after.skin->vertices[t[k]].position;
                ASSERT_EQ(glm::clamp(p, before.skin->lower - slack, before.skin->upper + slack), p);
            }
        }
        const Document back = transferred(before, after).document;
        for (std::size_t v = 0; v < back.groom.fur.size(); ++v) {
            const FurVertex& fur = back.groom.fur[v];
            ASSERT_TRUE(fur.furLength >= 0.0f && std::isfinite(fur.furLength));
            ASSERT_LE(glm::length(fur.direction), 1.0001f);
        }
    }
}

// A ball's hair points out of the ball, whatever becomes of the ball.
TEST(HardMeshes, HairStandsOnTheOuterSideOfEveryNode) {
    for (test::HardMesh& mesh : test::hardMeshes()) {
        const mat3 toWorld(mesh.source.parts[0].toWorld);
        if (mesh.name.rfind("ball", 0) != 0 || glm::determinant(toWorld) == 0.0f) continue;
        const glm::dmat3 outward = glm::transpose(glm::inverse(glm::dmat3(toWorld)));
        const std::vector<vec3> inMesh = mesh.source.positions;
        const auto skin = makeSkin(std::move(mesh.source));
        if (skin->report.degenerateFaces > 0) continue;  // crushed by rounding
        for (std::size_t v = 0; v < inMesh.size(); ++v) {
            const glm::dvec3 normal(skin->vertices[skin->weld[v]].normal);
            if (normal == glm::dvec3(0.0)) continue;  // the faces around it cancel
            const glm::dvec3 out = glm::normalize(outward * glm::dvec3(inMesh[v]));
            ASSERT_GT(glm::dot(out, normal), 0.0) << mesh.name;
        }
    }
}

}  // namespace
}  // namespace pelage
