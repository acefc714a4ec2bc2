// segment_parts_test.cpp -- pieces of a mesh become segments that run from head to tail.
#include "core/segment_parts.h"

#include <gtest/gtest.h>

#include <string>

#include "core/gltf_in.h"
#include "core/mesh_in.h"
#include "gltf_maker.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::GltfMaker;

// Points along a line, scattered a tenth of its length about it.
std::vector<vec3> along(vec3 from, vec3 to) {
    test::Draws draws(3);
    std::vector<vec3> points;
    for (int i = 0; i < 400; ++i)
        points.push_back(glm::mix(from, to, draws.in(0.0f, 1.0f)) +
                         draws.inBox(0.05f * glm::distance(from, to)));
    return points;
}

std::vector<std::string> namesOf(const Source& source) {
    std::vector<std::string> names;
    for (const Segment& segment : source.segments) names.push_back(segment.name);
    return names;
}

TEST(SegmentAlong, LiesInThePrincipalDirectionWithItsRootNearTheHead) {
    for (const float scale : {1e-5f, 1.0f, 1e5f}) {
        for (const vec3 axis : {vec3(1, 0, 0), vec3(0.6f, -0.8f, 0), vec3(-1, 2, 3)}) {
            const vec3 offset = scale * vec3(3, -2, 1);
            const std::vector<vec3> points = along(offset, offset + scale * axis);
            const Segment away = segmentAlong("leg", points, offset - scale * axis);
            const Segment back = segmentAlong("leg", points, offset + 2.0f * scale * axis);
            const vec3 found = glm::normalize(away.tip - away.root);
            EXPECT_GT(glm::dot(found, glm::normalize(axis)), 0.995f);
            EXPECT_NEAR(glm::distance(away.root, away.tip) / (scale * glm::length(axis)), 1.0f,
                        0.15f);
            EXPECT_EQ(back, (Segment{"leg", away.tip, away.root}));
        }
    }
}

TEST(SegmentAlong, OfPointsInOnePlaceHasNoLength) {
    const std::vector<vec3> points(5, vec3(1, 2, 3));
    EXPECT_EQ(segmentAlong("dot", points, vec3(0.0f)),
              (Segment{"dot", vec3(1, 2, 3), vec3(1, 2, 3)}));
    EXPECT_EQ(segmentAlong("none", {}, vec3(0.0f)), (Segment{"none", vec3(0.0f), vec3(0.0f)}));
}

// An animal that looks along +z: the legs of a part each, one below the other.
Source animalOf(const std::vector<std::pair<std::string, std::pair<vec3, vec3>>>& limbs,
                Pieces& pieces) {
    Source source;
    for (const auto& [name, ends] : limbs) {
        const std::vector<vec3> points = along(ends.first, ends.second);
        source.positions.insert(source.positions.end(), points.begin(), points.end());
        pieces.of.resize(source.positions.size(), static_cast<uint>(pieces.names.size()));
        pieces.names.push_back(name);
    }
    SourcePart part;
    part.vertexCount = static_cast<uint>(source.positions.size());
    source.parts.push_back(part);
    return source;
}

// With a part that is called a head and without one.
TEST(Pieces, RunFromHeadToTail) {
    for (const char* head : {"Head_01", "skull"}) {
        Pieces pieces;
        Source source = animalOf({{"trunk", {{0, 1, -1}, {0, 1, 1}}},
                                  {head, {{0, 1.3f, 1}, {0, 1.4f, 1.6f}}},
                                  {"front leg", {{0.2f, 0, 0.9f}, {0.2f, 1, 0.9f}}},
                                  {"hind leg", {{0.2f, 0, -0.9f}, {0.2f, 1, -0.9f}}},
                                  {"tail", {{0, 0.8f, -1.8f}, {0, 1, -1}}}},
                                 pieces);
        ASSERT_TRUE(segmentsFromPieces(source, pieces, "node"));
        ASSERT_EQ(source.segments.size(), 5u);
        const auto axis = [&](uint s) {
            return glm::normalize(source.segments[s].tip - source.segments[s].root);
        };
        EXPECT_LT(axis(0).z, -0.9f);
        EXPECT_LT(axis(1).z, -0.9f) << head;
        EXPECT_LT(axis(2).y, -0.9f);
        EXPECT_LT(axis(3).y, -0.9f);
        EXPECT_LT(axis(4).z, -0.9f);
    }
}

TEST(Pieces, FewerThanTwoNamesOrTooManyAreNoBody) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{64}, std::size_t{65}}) {
        Pieces pieces;
        Source source = test::sheet(20);
        for (std::size_t p = 0; p < count; ++p) pieces.names.push_back("p" + std::to_string(p));
        for (std::size_t v = 0; v < source.positions.size(); ++v)
            pieces.of.push_back(static_cast<uint>(v % count));
        EXPECT_EQ(segmentsFromPieces(source, pieces, "node"), count == 64);
        EXPECT_EQ(source.segments.size(), count == 64 ? 64u : 0u);
        EXPECT_EQ(source.segmentOf.empty(), count != 64);
    }
    Pieces unnamed{{"fur", ""}, std::vector<uint>(9, 0)};
    unnamed.of[8] = 1;
    Source source = test::sheet(2);
    EXPECT_FALSE(segmentsFromPieces(source, unnamed, "material"));
}

// Two meshes, each in a node and of a material of its own.
GltfMaker twoMeshes(int firstMaterial, int secondMaterial) {
    GltfMaker maker = GltfMaker::triangle();
    const int position = maker.add<float>({0, 0, 0, 3, 0, 0, 0, 1, 0}, "VEC3", 5126);
    maker.mesh({{"attributes", {{"POSITION", position}}}});
    maker.json["nodes"] = {{{"mesh", 0}, {"name", "trunk"}},
                           {{"mesh", 1}, {"name", "leg"}, {"translation", {0, -5, 0}}}};
    maker.json["scenes"] = {{{"nodes", {0, 1}}}};
    maker.json["materials"] = {{{"name", "pelt"}}, {{"name", "horn"}}, {{"name", "unused"}}};
    maker.json["meshes"][0]["primitives"][0]["material"] = firstMaterial;
    maker.json["meshes"][1]["primitives"][0]["material"] = secondMaterial;
    return maker;
}

TEST(GltfPieces, MaterialsComeBeforeNodes) {
    const Source byMaterial = readGltf(twoMeshes(1, 0).glb(), "");
    EXPECT_EQ(namesOf(byMaterial), (std::vector<std::string>{"pelt", "horn"}));
    EXPECT_EQ(byMaterial.segmentOf, (std::vector<uint>{1, 1, 1, 0, 0, 0}));
    const Source byNode = readGltf(twoMeshes(0, 0).glb(), "");
    EXPECT_EQ(namesOf(byNode), (std::vector<std::string>{"trunk", "leg"}));
    EXPECT_EQ(byNode.segmentOf, (std::vector<uint>{0, 0, 0, 1, 1, 1}));
    // In the world, where the second mesh hangs below.
    EXPECT_LT(byNode.segments[1].root.y, -3.5f);
    EXPECT_TRUE(readGltf(GltfMaker::triangle().glb(), "").segments.empty());
}

TEST(GltfPieces, JointsComeBeforeMaterials) {
    GltfMaker maker = GltfMaker::skinned();
    maker.mesh({{"attributes", {{"POSITION", 0}}}, {"material", 1}});
    maker.primitive()["material"] = 0;
    maker.json["materials"] = {{{"name", "pelt"}}, {{"name", "horn"}}};
    const Source source = readGltf(maker.glb(), "");
    EXPECT_EQ(namesOf(source), (std::vector<std::string>{"hip", "neck", "rest"}));
}

std::string faces(const char* first, const char* second) {
    return std::string("v 0 0 0\nv 1 0 0\nv 0 3 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 9 9\n") + first +
           "\nf 1 2 3\n" + second + "\nf 4 5 6\nf 3 4 5\n";
}

TEST(ObjPieces, AreMaterialsElseObjectsElseGroups) {
    const auto read = [](const std::string& text) { return readObj(test::bytesOf(text), ""); };
    const std::vector<std::string> ab{"a", "b"};
    for (const char* key : {"usemtl ", "o ", "g "}) {
        const Source source =
            read(faces((key + std::string("a")).c_str(), (key + std::string("b")).c_str()));
        EXPECT_EQ(namesOf(source), ab) << key;
        EXPECT_EQ(source.segmentOf, (std::vector<uint>{0, 0, 0, 1, 1, 1, kNoSegment})) << key;
    }
    EXPECT_EQ(namesOf(read(faces("o x\nusemtl a", "o y\nusemtl b"))), ab);
    EXPECT_EQ(namesOf(read(faces("g x\no a", "g y\no b"))), ab);
    EXPECT_EQ(namesOf(read(faces("usemtl m\no a", "o b"))), ab);
    EXPECT_TRUE(read(faces("g default", "")).segments.empty());
    EXPECT_TRUE(read(faces("", "")).segments.empty());
}

}  // namespace
}  // namespace pelage
