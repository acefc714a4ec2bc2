// transfer_test.cpp -- a groom finds its place on another mesh.
#include "core/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/gltf_out.h"
#include "core/script.h"
#include "core/subdivide.h"
#include "painted.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;

// The same mesh with vertices, triangles and corners in another order.
Source shuffled(const Source& source) {
    Draws draws(5);
    std::vector<uint> to(source.positions.size());
    std::iota(to.begin(), to.end(), 0u);
    for (uint v = static_cast<uint>(to.size()); v-- > 1;) std::swap(to[v], to[draws.below(v + 1)]);
    std::vector<vec3> positions(to.size());
    for (std::size_t v = 0; v < to.size(); ++v) positions[to[v]] = source.positions[v];
    std::vector<uvec3> triangles;
    for (const uvec3 t : source.triangles)
        triangles.insert(triangles.begin() + draws.below(static_cast<uint>(triangles.size()) + 1),
                         uvec3(to[t.y], to[t.z], to[t.x]));
    return test::oneMesh(std::move(positions), std::move(triangles));
}

// A field that varies smoothly in space, within the ranges of fur.
void paintSmooth(Document& document) {
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const SkinVertex& vertex = document.skin->vertices[v];
        const vec3 p = vertex.position;
        FurVertex fur;
        fur.furLength = 0.1f + 0.05f * std::sin(2.0f * p.x);
        fur.density = 0.5f + 0.4f * std::cos(2.0f * p.y);
        fur.tint = vec3(0.5f + 0.5f * std::sin(p.z), 0.5f, 1.0f);
        const vec3 comb(0.0f, 0.0f, -1.0f);
        fur.direction = 0.7f * (comb - glm::dot(comb, vertex.normal) * vertex.normal);
        document.groom.fur.edit(v) = furToMesh(*document.skin, v, fur);
    }
}

struct Difference {
    float length = 0.0f, density = 0.0f, direction = 0.0f, tint = 0.0f;
};

// Mean over the vertices of `a`, whose values are those of paintSmooth where they are right.
Difference meanError(const Document& a) {
    Document right = a;
    paintSmooth(right);
    Difference mean;
    const float share = 1.0f / static_cast<float>(a.groom.fur.size());
    for (std::size_t v = 0; v < a.groom.fur.size(); ++v) {
        const FurVertex &x = a.groom.fur[v], &y = right.groom.fur[v];
        mean.length += share * std::abs(x.furLength - y.furLength);
        mean.density += share * std::abs(x.density - y.density);
        mean.direction += share * glm::distance(x.direction, y.direction);
        mean.tint += share * glm::distance(x.tint, y.tint);
    }
    return mean;
}

TEST(Transfer, SameMeshInAnotherOrderGetsTheSameValues) {
    const Source ball = test::ball(3);
    Document from = openDocument(shuffled(ball));
    test::paint(from);
    const Transferred out = transferred(from, openDocument(test::ball(3)));
    EXPECT_EQ(out.far, 0u);
    ASSERT_EQ(out.document.groom.fur.size(), from.groom.fur.size());
    for (uint v = 0; v < from.groom.fur.size(); ++v) {
        // Skins are in spatial order, so the same vertex has the same number.
        ASSERT_EQ(out.document.skin->vertices[v].position, from.skin->vertices[v].position);
        const FurVertex &x = out.document.groom.fur[v], &y = from.groom.fur[v];
        ASSERT_NEAR(x.furLength, y.furLength, 1e-6f);
        ASSERT_NEAR(x.density, y.density, 1e-6f);
        ASSERT_LT(glm::distance(x.direction, y.direction), 1e-6f);
        ASSERT_LT(glm::distance(x.tint, y.tint), 1e-6f);
    }
}

TEST(Transfer, FinerAndCoarserMeshesGetNearlyTheSame) {
    Document from = openDocument(test::ball(4));
    paintSmooth(from);
    for (const int times : {3, 5}) {
        const Difference error =
            meanError(transferred(from, openDocument(test::ball(times))).document);
        std::printf("  ball %d: length %.2g, density %.2g, direction %.2g, tint %.2g\n", times,
                    static_cast<double>(error.length), static_cast<double>(error.density),
                    static_cast<double>(error.direction), static_cast<double>(error.tint));
        EXPECT_LT(error.length, 1e-3f);
        EXPECT_LT(error.density, 3e-3f);
        EXPECT_LT(error.direction, 1e-2f);
        EXPECT_LT(error.tint, 3e-3f);
    }
    const Difference smoothed =
        meanError(transferred(from, subdivided(openDocument(test::ball(3)), 1)).document);
    EXPECT_LT(smoothed.length, 3e-3f);
    EXPECT_LT(smoothed.direction, 2e-2f);
}

TEST(Transfer, LengthIsInMetresOfTheWorld) {
    const Document from = test::evenDocument(test::sheet(4));
    Source small = test::sheet(4, mat4(mat3(0.01f)));
    for (vec3& p : small.positions) p *= 100.0f;
    const Document out = transferred(from, openDocument(std::move(small))).document;
    for (std::size_t v = 0; v < out.groom.fur.size(); ++v) {
        ASSERT_NEAR(out.groom.fur[v].furLength, 4.0f, 1e-5f);
        ASSERT_NEAR(glm::length(out.groom.fur[v].direction), 0.5f, 1e-5f);
    }
}

TEST(Transfer, DirectionTurnsFromOneNormalToTheOther) {
    const Document from = test::evenDocument(test::sheet(4));  // combed along z
    const float tilt = 0.4f;
    Source tilted = test::sheet(4);
    for (vec3& p : tilted.positions) p = vec3(p.x, std::sin(tilt) * p.z, std::cos(tilt) * p.z);
    const Document out = transferred(from, openDocument(std::move(tilted))).document;
    const vec3 expected(0.0f, 0.5f * std::sin(tilt), 0.5f * std::cos(tilt));
    for (std::size_t v = 0; v < out.groom.fur.size(); ++v)
        ASSERT_LT(glm::distance(out.groom.fur[v].direction, expected), 1e-5f);
}

TEST(Transfer, EachSideOfAnEarGetsItsOwn) {
    Document ear = openDocument(test::twoSheets(4, 0.002f));
    const auto lengthOf = [](const SkinVertex& v) { return v.normal.y > 0.0f ? 0.1f : 0.02f; };
    for (uint v = 0; v < ear.groom.fur.size(); ++v)
        ear.groom.fur.edit(v).furLength = lengthOf(ear.skin->vertices[v]);
    // Thinner by half: the nearest point of all may be on the other side.
    Source thin = test::twoSheets(7, 0.001f);
    for (vec3& p : thin.positions) p.y += 0.0009f;
    const Document out = transferred(ear, openDocument(std::move(thin))).document;
    for (uint v = 0; v < out.groom.fur.size(); ++v)
        ASSERT_NEAR(out.groom.fur[v].furLength, lengthOf(out.skin->vertices[v]), 1e-6f);
}

TEST(Transfer, CoatsComeAlongAndTheMaskStays) {
    Document from = test::evenDocument(test::ball(2)), onto = test::evenDocument(test::ball(2));
    from.fur.over.stiffness = 0.123f;
    from.groom.mask = Chunked<float>(from.groom.mask.size(), 1.0f);
    onto.groom.mask.edit(3) = 0.5f;
    const Document out = transferred(from, onto).document;
    EXPECT_EQ(out.fur, from.fur);
    EXPECT_EQ(out.groom.mask, onto.groom.mask);
    EXPECT_EQ(out.skin, onto.skin);
}

TEST(Transfer, FarVerticesAreCountedAndTold) {
    const Document from = test::evenDocument(test::sheet(4));
    Source apart = test::sheet(4);
    for (vec3& p : apart.positions)
        if (p.x > 0.2f) p.y += 1.0f;
    const Transferred out = transferred(from, openDocument(std::move(apart)));
    EXPECT_EQ(out.far, 10u);
    EXPECT_NEAR(out.farthest, 1.0f, 1e-5f);
    EXPECT_EQ(farNote(out),
              "10 of 25 vertices are farther than 5 % of the size from the groomed surface, the "
              "farthest 1 m");
    EXPECT_EQ(farNote(transferred(from, from)), "");
}

TEST(Transfer, LineIsOneStepThatIsReplayedBitForBit) {
    const test::TempFolder folder;
    Document groomed = openDocument(test::ball(3));
    test::paint(groomed);
    writeGroomedGlb(groomed, folder.path("old mesh.glb"));
    const auto run = [&] {
        Workspace workspace;
        workspace.open(openDocument(test::ball(2)));
        runLine(workspace, "transfer " + folder.path("old mesh.glb"));
        return workspace;
    };
    Workspace first = run(), second = run();
    EXPECT_EQ(first.editor->stepCount(), 2u);
    EXPECT_EQ(groomedGlb(first.editor->document()), groomedGlb(second.editor->document()));
    const Document opened = openDocument(test::ball(2));
    first.undo();
    EXPECT_EQ(groomedGlb(first.editor->document()), groomedGlb(opened));
    EXPECT_EQ(test::refusal([&] { runLine(first, "transfer"); }), "transfer: names no file");
}

TEST(Transfer, SharedMeshesTakeTheirOwnGroomBackAfterSubdivision) {
    for (const char* name : {"suzanne.obj", "spot.obj", "Fox.glb"}) {
        SCOPED_TRACE(name);
        const std::string path = test::sharedMesh(name);
        if (path.empty()) GTEST_SKIP() << "no shared meshes";
        const Document before = openDocument(readSource(path));
        const Document fine = subdivided(before, 1);
        const Transferred out = transferred(before, fine);
        EXPECT_EQ(out.far, 0u);
        float error = 0.0f, size = 0.0f;
        for (uint v = 0; v < fine.groom.fur.size(); ++v) {
            error +=
                glm::distance(out.document.groom.fur[v].direction, fine.groom.fur[v].direction);
            size += glm::length(fine.groom.fur[v].direction);
        }
        std::printf("  %s: directions differ by %.2g of their length\n", name,
                    static_cast<double>(error / size));
        EXPECT_LT(error, 0.2f * size);
    }
}

}  // namespace
}  // namespace pelage
