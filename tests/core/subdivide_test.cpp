// subdivide_test.cpp -- a finer mesh with everything of the old one.
#include "core/subdivide.h"

#include <gtest/gtest.h>
#include <algorithm>

#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

#include "core/animal.h"
#include "core/carried_counts.h"
#include "core/gltf_carried.h"
#include "core/gltf_out.h"
#include "core/half_edges.h"
#include "core/mixed_weights.h"
#include "gltf_maker.h"
#include "gltf_samples.h"
#include "painted.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::GltfMaker;
using test::refusal;
using test::sameBits;
using test::sharedMesh;

Document paintedOf(Source source) {
    Document document = openDocument(std::move(source));
    test::paint(document);
    for (uint v = 0; v < document.groom.mask.size(); ++v)
        document.groom.mask.edit(v) = rand01(pcg(v + 99));
    return document;
}

// What must hold for every mesh.
void expectSound(const Document& before, int levels) {
    const Document after = subdivided(before, levels);
    const Source& from = *before.skin->source;
    const Source& to = *after.skin->source;
    const MeshSize size = sizesAfterCuts(from, levels).back();
    EXPECT_EQ(to.positions.size(), size.vertices);
    EXPECT_EQ(to.triangles.size(), size.triangles);
    ASSERT_EQ(to.parts.size(), from.parts.size());
    // No crack opens and nothing is joined: edges are as those of the welded mesh that was cut.
    std::vector<uvec3> cut = before.skin->triangles;
    std::size_t vertices = before.skin->vertices.size();
    for (int level = 0; level < levels; ++level) {
        Cuts cuts = cutEdges(vertices, cut);
        vertices += cuts.edges.size();
        cut = std::move(cuts.triangles);
    }
    const Topology topology = makeTopology(vertices, cut);
    EXPECT_EQ(after.skin->vertices.size(), vertices);
    EXPECT_EQ(after.skin->report.boundaryEdges, topology.boundaryEdges);
    EXPECT_EQ(after.skin->report.nonManifoldEdges, topology.nonManifoldEdges);
    EXPECT_EQ(after.skin->report.flippedEdges, topology.flippedEdges);
    for (std::size_t p = 0; p < to.parts.size(); ++p) {
        EXPECT_EQ(to.parts[p].material, from.parts[p].material);
        EXPECT_EQ(to.parts[p].mesh, from.parts[p].mesh);
        EXPECT_EQ(to.parts[p].toWorld, from.parts[p].toWorld);
        for (uint v = 0; v < from.parts[p].vertexCount; ++v) {
            const FurVertex& old =
                before.groom.fur[before.skin->weld[from.parts[p].firstVertex + v]];
            const FurVertex& now = after.groom.fur[after.skin->weld[to.parts[p].firstVertex + v]];
            ASSERT_EQ(std::memcmp(&old, &now, sizeof old), 0) << "part " << p << " vertex " << v;
        }
    }
    for (std::size_t v = 0; v < after.groom.fur.size(); ++v) {
        const FurVertex& fur = after.groom.fur[v];
        ASSERT_TRUE(fur.furLength >= 0.0f && fur.furLength <= 1.0f);
        ASSERT_TRUE(fur.density >= 0.0f && fur.density <= 1.0f);
        ASSERT_LE(glm::length(fur.direction), 1.0f);
    }
    // What is written opens again bit-equal.
    const std::vector<std::byte> glb = groomedGlb(after);
    const Document again = test::opened(glb);
    EXPECT_TRUE(sameBits(again.skin->source->positions, to.positions));
    EXPECT_TRUE(sameBits(again.skin->source->normals, to.normals));
    EXPECT_TRUE(sameBits(again.skin->source->uvs, to.uvs));
    EXPECT_TRUE(sameBits(again.skin->source->colors, to.colors));
    EXPECT_TRUE(sameBits(again.skin->source->triangles, to.triangles));
    EXPECT_TRUE(sameBits(again.skin->source->vertexToWorld, to.vertexToWorld));
    EXPECT_TRUE(std::ranges::equal(again.groom.body(), after.groom.body()));
    for (std::size_t v = 0; v < after.groom.segmentOf.size(); ++v)
        ASSERT_EQ(again.groom.segmentOf[v], after.groom.segmentOf[v]);
    test::expectSameFields(after, again);
    EXPECT_EQ(groomedGlb(again), glb);
}

// A tent of two primitives that share an edge, split there, with a seam of texture coordinates.
Source tent() {
    GltfMaker maker;
    const auto primitive = [&](std::vector<float> positions, std::vector<float> uvs) {
        const int position = maker.add<float>(positions, "VEC3", 5126);
        const int uv = maker.add<float>(uvs, "VEC2", 5126);
        return nlohmann::json{{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}}};
    };
    maker.mesh(primitive({0, 0, 0, 1, 0, 0, .5f, 1, 1}, {0, 0, 1, 0, 0, 1}));
    maker.json["meshes"][0]["primitives"].push_back(
        primitive({1, 0, 0, 0, 0, 0, .5f, 1, -1}, {0, .5f, .25f, .5f, .5f, 1}));
    maker.json["nodes"] = {{{"mesh", 0}}};
    return readGltf(maker.glb(), "test.glb");
}

TEST(Subdivide, HoldsForEveryKindOfMesh) {
    expectSound(paintedOf(test::ball(1)), 2);
    expectSound(paintedOf(test::sheet(3)), 2);
    expectSound(paintedOf(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})), 3);
    expectSound(test::paintedObj(), 2);
    expectSound(paintedOf(tent()), 2);
    expectSound(paintedOf(test::sheet(2, mat4(vec4(-1, 0, 0, 0), vec4(0, 2, 0, 0), vec4(0, 0, 1, 0),
                                              vec4(3, 0, 0, 1)))),
                1);
    expectSound(paintedOf(readGltf(GltfMaker::skinned().glb(), "test.glb")), 2);
}

TEST(Subdivide, HoldsForAnEdgeOfThreeTriangles) {
    expectSound(paintedOf(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                        {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})),
                2);
}

TEST(Subdivide, HoldsForTheBuiltInAnimal) {
    const Document animal = groomedAnimal(2000);
    const Document after = subdivided(animal, 1);
    EXPECT_FALSE(after.groom.body().empty());
    EXPECT_TRUE(std::ranges::equal(after.groom.body(), animal.groom.body()));
    for (std::size_t v = 0; v < after.groom.segmentOf.size(); ++v)
        ASSERT_NE(after.groom.segmentOf[v], kNoSegment);
    EXPECT_TRUE(std::ranges::equal(evenGroom(*after.skin, kBareFur).body(), animal.groom.body()));
    EXPECT_EQ(after.skin->source->images.size(), 1u);
    EXPECT_EQ(after.skin->report.boundaryEdges, 0u);
    EXPECT_TRUE(after.skin->outward);
}

TEST(Subdivide, HoldsForSharedMeshes) {
    for (const char* name : {"suzanne.obj", "spot.obj", "teapot.obj", "stanford-bunny.obj"}) {
        SCOPED_TRACE(name);
        const std::string path = sharedMesh(name);
        if (path.empty()) GTEST_SKIP() << "no shared meshes";
        expectSound(paintedOf(readSource(path)), 1);
    }
}

TEST(Subdivide, FoxKeepsItsSkeletonAndItsAnimations) {
    const std::string path = sharedMesh("Fox.glb");
    if (path.empty()) GTEST_SKIP() << "no shared meshes";
    const Document fox = paintedOf(readSource(path));
    expectSound(fox, 1);
    const Document after = subdivided(fox, 2);
    const CarriedCounts counts = carriedCounts(*after.skin->source);
    EXPECT_EQ(counts.joints, 24u);
    EXPECT_EQ(counts.animations, 3u);
    EXPECT_EQ(counts.nodes, carriedCounts(*fox.skin->source).nodes);
    // Skinned vertices stay near those that held them.
    EXPECT_LT(glm::distance(after.skin->center(), fox.skin->center()), 0.05f * fox.skin->size());
    EXPECT_NEAR(after.skin->size(), fox.skin->size(), 0.1f * fox.skin->size());
}

TEST(Subdivide, NewVerticesTakeTheMeanOfBothEnds) {
    const Document before =
        paintedOf(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
    const Document after = subdivided(before, 1);
    const auto old = [&](uint v) { return before.groom.fur[before.skin->weld[v]]; };
    const FurVertex now = after.groom.fur[after.skin->weld[3]];  // between 0 and 1
    EXPECT_EQ(now.furLength, 0.5f * (old(0).furLength + old(1).furLength));
    EXPECT_EQ(now.density, 0.5f * (old(0).density + old(1).density));
    EXPECT_EQ(now.direction, 0.5f * (old(0).direction + old(1).direction));
    EXPECT_EQ(now.tint, 0.5f * (old(0).tint + old(1).tint));
    EXPECT_EQ(
        after.groom.mask[after.skin->weld[3]],
        0.5f * (before.groom.mask[before.skin->weld[0]] + before.groom.mask[before.skin->weld[1]]));
}

TEST(Subdivide, EachSideOfASeamKeepsItsTextureCoordinates) {
    const Document after = subdivided(openDocument(tent()), 1);
    const Source& source = *after.skin->source;
    // The shared edge is the first of both parts: vertices 0 1 there, 1 0 here.
    const uint left = source.parts[0].firstVertex + 3, right = source.parts[1].firstVertex + 3;
    EXPECT_EQ(source.positions[left], source.positions[right]);
    EXPECT_EQ(source.uvs[left], vec2(0.5f, 0.0f));
    EXPECT_EQ(source.uvs[right], vec2(0.125f, 0.5f));
    EXPECT_EQ(after.skin->weld[left], after.skin->weld[right]);
    // Inside the tent, so the rule for inner edges.
    EXPECT_EQ(source.positions[left], vec3(0.5f, 0.25f, 0.0f));
}

TEST(Subdivide, NormalsFollowTheShapeAndKeepHardEdges) {
    Source roof = test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                {{0, 2, 1}, {3, 5, 4}});
    roof.normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
    const Document after = subdivided(openDocument(std::move(roof)), 1);
    const Source& source = *after.skin->source;
    for (std::size_t v = 0; v < source.normals.size(); ++v)
        EXPECT_NEAR(glm::length(source.normals[v]), 1.0f, 1e-5f);
    // Both faces stay apart where they meet.
    EXPECT_GT(glm::distance(source.normals[0], source.normals[3]), 0.5f);

    Source ball = test::ball(1);
    for (const vec3 p : ball.positions) ball.normals.push_back(p);
    const Document round = subdivided(openDocument(std::move(ball)), 2);
    for (std::size_t v = 0; v < round.skin->source->normals.size(); ++v)
        ASSERT_GT(glm::dot(round.skin->source->normals[v],
                           glm::normalize(round.skin->source->positions[v])),
                  0.995f);
}

// Attributes of a triangle that has all of them; the accessor numbers by name.
test::Glb afterOnce(const GltfMaker& maker) {
    return test::takeApart(groomedGlb(subdivided(test::opened(maker.glb()), 1)));
}

std::vector<float> attribute(const test::Glb& glb, const std::string& name) {
    return test::floatsOf(
        glb, glb.json["meshes"][0]["primitives"][0]["attributes"][name].get<std::size_t>());
}

TEST(Subdivide, AnyAttributeIsCarried) {
    GltfMaker maker = GltfMaker::triangle();
    auto& attributes = maker.primitive()["attributes"];
    attributes["TEXCOORD_1"] = maker.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 5126);
    attributes["COLOR_0"] = maker.add<std::uint8_t>(
        {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}, "VEC4", 5121, {{"normalized", true}});
    attributes["_HEAT"] = maker.add<float>({0, 4, 8}, "SCALAR", 5126);
    attributes["_TEETH"] =
        maker.add<std::uint8_t>({3, 0, 0, 0, 9, 0, 0, 0, 5, 0, 0, 0}, "VEC4", 5121);
    attributes["NORMAL"] = maker.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 5126);
    attributes["TANGENT"] = maker.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1}, "VEC4", 5126);
    const test::Glb glb = afterOnce(maker);
    EXPECT_EQ(attribute(glb, "_HEAT"), (std::vector<float>{0, 4, 8, 2, 6, 4}));
    EXPECT_EQ(attribute(glb, "TEXCOORD_1"),
              (std::vector<float>{0, 0, 1, 0, 0, 1, .5f, 0, .5f, .5f, 0, .5f}));
    EXPECT_EQ(attribute(glb, "COLOR_0")[12], 0.5f);
    EXPECT_EQ(attribute(glb, "_TEETH")[12], 3.0f);  // numbers of things have no mean
    const std::vector<float> tangent = attribute(glb, "TANGENT");
    EXPECT_NEAR(tangent[16], std::sqrt(0.5f), 1e-6f);
    EXPECT_EQ(tangent[19], 1.0f);
    // Nothing of the old arrays stays behind.
    EXPECT_EQ(glb.json["accessors"].size(), 7u + 1u + 3u);
}

TEST(Subdivide, RefusesAMatrixByItsName) {
    GltfMaker maker = GltfMaker::triangle();
    maker.primitive()["attributes"]["_TURN"] =
        maker.add<float>(std::vector<float>(48, 1.0f), "MAT4", 5126);
    const Document document = test::opened(maker.glb());
    EXPECT_NE(refusal([&] { subdivided(document, 1); }).find("\"_TURN\" is a matrix"),
              std::string::npos);
}

TEST(Subdivide, MorphTargetsFollowTheSameRule) {
    GltfMaker maker = GltfMaker::triangle();
    const std::vector<float> base{0, 0, 0, 1, 0, 0, 0, 1, 0}, offset{0, 0, 4, 0, 0, 0, 0, 0, 0};
    maker.primitive()["targets"] = {{{"POSITION", maker.add<float>(offset, "VEC3", 5126)}}};
    const test::Glb glb = afterOnce(maker);
    const std::vector<float> moved = test::floatsOf(
        glb, glb.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"].get<std::size_t>());
    EXPECT_EQ(moved,
              (std::vector<float>{0, 0, 3, 0, 0, .5f, 0, 0, .5f, 0, 0, 2, 0, 0, 0, 0, 0, 2}));
}

TEST(Subdivide, LipsThatOpenInAMorphTargetAreNotJoined) {
    GltfMaker maker;
    const int position =
        maker.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0}, "VEC3", 5126);
    const int opened =
        maker.add<float>({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", 5126);
    maker.mesh({{"attributes", {{"POSITION", position}}}, {"targets", {{{"POSITION", opened}}}}});
    maker.json["nodes"] = {{{"mesh", 0}}};
    const test::Glb glb = afterOnce(maker);
    // As a border: welded, the middle of the edge would have the mean of four corners.
    EXPECT_EQ(test::floatsOf(glb, glb.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"]
                                      .get<std::size_t>())[3 * 6 + 1],
              1.0f);
}

TEST(Subdivide, QuantizedAndSparseArraysBecomePlainFloats) {
    GltfMaker maker;
    const int quantized = maker.accessor(
        maker.view(std::vector<std::int16_t>{0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0}), 3, "VEC3",
        5122);
    maker.json["bufferViews"][0]["byteStride"] = 8;
    maker.mesh({{"attributes", {{"POSITION", quantized}}}});
    maker.json["nodes"] = {{{"mesh", 0}, {"scale", {0.01, 0.01, 0.01}}}};
    maker.json["extensionsUsed"] = maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int indices = maker.view(std::vector<std::uint8_t>{1});
    const int values = maker.view(std::vector<float>{6.0f});
    maker.primitive()["attributes"]["_HEAT"] =
        maker.accessor(-1, 3, "SCALAR", 5126,
                       {{"sparse",
                         {{"count", 1},
                          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                          {"values", {{"bufferView", values}}}}}});
    const test::Glb glb = afterOnce(maker);
    EXPECT_EQ(attribute(glb, "_HEAT"), (std::vector<float>{0, 6, 0, 3, 3, 0}));
    EXPECT_EQ(attribute(glb, "POSITION")[9], 50.0f);
}

TEST(Subdivide, MeshesThatSharedArraysGetTheirOwn) {
    GltfMaker maker;
    const int position = maker.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3", 5126);
    const int first = maker.add<std::uint16_t>({0, 1, 2}, "SCALAR", 5123);
    const int second = maker.add<std::uint16_t>({1, 3, 2, 0, 1, 2}, "SCALAR", 5123);
    maker.mesh({{"attributes", {{"POSITION", position}}}, {"indices", first}});
    maker.mesh({{"attributes", {{"POSITION", position}}}, {"indices", second}});
    maker.mesh({{"attributes", {{"POSITION", position}}}, {"mode", 1}});  // lines stay as they are
    maker.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 1}}, {{"mesh", 2}}};
    const Document before = paintedOf(readGltf(maker.glb(), "test.glb"));
    expectSound(before, 2);
    const test::Glb glb = afterOnce(maker);
    const auto lines =
        glb.json["meshes"][2]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
    EXPECT_EQ(lines, static_cast<std::size_t>(position));
    EXPECT_EQ(glb.json["accessors"][lines]["count"], 4);
}

TEST(Subdivide, StripsFansAndEveryKindOfFileAreRead) {
    for (const int mode : {4, 5, 6}) {
        GltfMaker maker;
        const int position = maker.add<float>(
            {0, 0, 0, 1, 0, .1f, 0, 1, .2f, 1.3f, 1, .5f, 0, 2.1f, .7f, 1.2f, 2, .9f}, "VEC3",
            5126);
        maker.mesh({{"attributes", {{"POSITION", position}}}, {"mode", mode}});
        maker.json["nodes"] = {{{"mesh", 0}}};
        expectSound(paintedOf(readGltf(maker.glb(), "test.glb")), 1);
    }
    expectSound(test::painted(test::crowdedFile()), 1);
}

TEST(Subdivide, WeightsAddUpToOne) {
    GltfMaker maker = GltfMaker::skinned();
    const test::Glb glb = afterOnce(maker);
    const std::vector<float> weights = attribute(glb, "WEIGHTS_0");
    ASSERT_EQ(weights.size(), 24u);
    for (std::size_t v = 0; v < 6; ++v)
        EXPECT_NEAR(weights[4 * v] + weights[4 * v + 1] + weights[4 * v + 2] + weights[4 * v + 3],
                    1.0f, 1e-6f);
    // Vertex 3 lies between one that joint 0 holds and one that joint 1 holds.
    EXPECT_EQ(weights[12], 0.5f);
    EXPECT_EQ(weights[13], 0.5f);
}

TEST(Subdivide, OfManyJointsTheStrongestStay) {
    const Influences a{{1, 0.4f}, {2, 0.3f}, {3, 0.2f}, {4, 0.1f}};
    const Influences b{{5, 0.4f}, {2, 0.3f}, {6, 0.2f}, {7, 0.1f}};
    const Influences mixed = halfway(a, b, 4);
    ASSERT_EQ(mixed.size(), 4u);
    EXPECT_EQ(mixed[0].joint, 2u);
    EXPECT_EQ(mixed[1].joint, 1u);
    EXPECT_EQ(mixed[2].joint, 5u);
    EXPECT_EQ(mixed[3].joint, 3u);  // the first of two equals
    EXPECT_NEAR(mixed[0].weight + mixed[1].weight + mixed[2].weight + mixed[3].weight, 1.0f, 1e-6f);
}

TEST(Subdivide, FieldsOfTheFileStayWhatResetBringsBack) {
    const Document painted = test::painted(GltfMaker::triangle().glb());
    const Document fromFile = test::opened(groomedGlb(painted));
    const Document after = subdivided(fromFile, 1);
    ASSERT_NE(after.skin->source->fur, nullptr);
    EXPECT_EQ(after.skin->source->fur->length[3], 0.5f * (fromFile.skin->source->fur->length[0] +
                                                          fromFile.skin->source->fur->length[1]));
}

TEST(Subdivide, FilesOfOursDoNotGrowByIt) {
    // Two primitives that share their arrays, and with them the fields of an export.
    GltfMaker maker = GltfMaker::triangle();
    maker.json["meshes"][0]["primitives"].push_back(maker.primitive());
    const Document document = test::painted(maker.glb());
    const Document plain = test::opened(groomedGlb(document));
    const Document mirrored = test::opened(groomedGlb(document, {.compatibilityUvs = true}));
    const std::vector<std::byte> glb = groomedGlb(subdivided(mirrored, 1));
    EXPECT_EQ(groomedGlb(subdivided(plain, 1)).size(), glb.size());
    const test::Glb apart = test::takeApart(glb);
    EXPECT_FALSE(apart.json["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_2"));
}

TEST(Subdivide, RefusesWhatBecomesTooLargeWithNumbers) {
    const Document document = openDocument(test::ball(4));
    EXPECT_EQ(refusal([&] { subdivided(document, 8); }),
              "the mesh would have 335544320 triangles; subdivision makes at most 8388608");
}

TEST(Subdivide, CanBeCancelled) {
    const Document document = openDocument(test::ball(3));
    Progress progress;
    progress.cancel = true;
    EXPECT_THROW(subdivided(document, 1, &progress), Cancelled);
}

}  // namespace
}  // namespace pelage
