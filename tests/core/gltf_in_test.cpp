// gltf_in_test.cpp -- every form in which a glTF may hold a surface, made by code and read back.
#include "core/gltf_in.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "core/gltf_carried.h"
#include "gltf_maker.h"
#include "reading.h"

namespace pelage {
namespace {

using test::GltfMaker;
using test::sharedMesh;
using test::TempFolder;
using Json = nlohmann::json;

constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
              kUnsignedInt = 5125, kFloat = 5126;

bool warns(const Source& source, const std::string& part) {
    for (const std::string& warning : source.warnings) {
        if (warning.find(part) != std::string::npos) return true;
    }
    return false;
}

// A mesh of these places, named by an accessor and placed at the origin.
GltfMaker meshOf(GltfMaker maker, int position) {
    maker.mesh({{"attributes", {{"POSITION", position}}}});
    maker.json["nodes"] = {{{"mesh", 0}}};
    maker.json["scenes"] = {{{"nodes", {0}}}};
    return maker;
}

template <typename T>
std::vector<vec3> positionsOf(const std::vector<T>& values, int type, bool normalized,
                              std::size_t stride) {
    GltfMaker maker;
    const int view = maker.view(values);
    if (stride > 0) maker.json["bufferViews"][0]["byteStride"] = stride;
    const int position = maker.accessor(view, 3, "VEC3", type, {{"normalized", normalized}});
    return readGltf(meshOf(maker, position).glb(), "").positions;
}

TEST(GltfAccessor, EveryComponentTypeIsRead) {
    const std::vector<vec3> expected{{0, 0, 0}, {127, 0, 1}, {0, 3, 0}};
    EXPECT_EQ(positionsOf<std::int8_t>({0, 0, 0, 0, 127, 0, 1, 0, 0, 3, 0, 0}, kByte, false, 4),
              expected);
    EXPECT_EQ(
        positionsOf<std::uint8_t>({0, 0, 0, 0, 127, 0, 1, 0, 0, 3, 0, 0}, kUnsignedByte, false, 4),
        expected);
    EXPECT_EQ(positionsOf<std::int16_t>({0, 0, 0, 0, 127, 0, 1, 0, 0, 3, 0, 0}, kShort, false, 8),
              expected);
    EXPECT_EQ(positionsOf<std::uint16_t>({0, 0, 0, 0, 127, 0, 1, 0, 0, 3, 0, 0}, kUnsignedShort,
                                         false, 8),
              expected);
    EXPECT_EQ(positionsOf<std::uint32_t>({0, 0, 0, 127, 0, 1, 0, 3, 0}, kUnsignedInt, false, 0),
              expected);
    EXPECT_EQ(positionsOf<float>({0, 0, 0, 127, 0, 1, 0, 3, 0}, kFloat, false, 0), expected);
}

TEST(GltfAccessor, NormalizedIntegersSpanMinusOneToOne) {
    const auto bytes =
        positionsOf<std::int8_t>({0, 0, 0, 0, 127, -127, -128, 0, 0, 64, 0, 0}, kByte, true, 4);
    EXPECT_EQ(bytes[1], vec3(1, -1, -1));
    EXPECT_FLOAT_EQ(bytes[2].y, 64.0f / 127.0f);
    const auto shorts =
        positionsOf<std::int16_t>({0, 0, 0, 32767, -32768, -32767, 0, 1, 0}, kShort, true, 0);
    EXPECT_EQ(shorts[1], vec3(1, -1, -1));
    EXPECT_EQ(positionsOf<std::uint8_t>({0, 0, 0, 0, 255, 0, 51, 0, 0, 255, 0, 0}, kUnsignedByte,
                                        true, 4)[1],
              vec3(1, 0, 0.2f));
    EXPECT_EQ(positionsOf<std::uint16_t>({0, 0, 0, 65535, 0, 13107, 0, 65535, 0}, kUnsignedShort,
                                         true, 0)[1],
              vec3(1, 0, 0.2f));
}

TEST(GltfAccessor, InterleavedAttributesAreTakenApart) {
    GltfMaker maker;
    const int view = maker.view(std::vector<float>{0, 0, 0, 9, 8, 1, 0, 0, 7, 6, 0, 1, 0, 5, 4});
    maker.json["bufferViews"][0]["byteStride"] = 20;
    const int position = maker.accessor(view, 3, "VEC3", kFloat);
    const int uv = maker.accessor(view, 3, "VEC2", kFloat, {{"byteOffset", 12}});
    maker = meshOf(maker, position);
    maker.primitive()["attributes"]["TEXCOORD_0"] = uv;
    const Source source = readGltf(maker.glb(), "");
    EXPECT_EQ(source.positions[2], vec3(0, 1, 0));
    EXPECT_EQ(source.uvs, (std::vector<vec2>{{9, 8}, {7, 6}, {5, 4}}));
}

TEST(GltfAccessor, SparseValuesReplaceThoseBelow) {
    GltfMaker maker = GltfMaker::triangle();
    const int indices = maker.view(std::vector<std::uint16_t>{0, 2});
    const int values = maker.view(std::vector<float>{5, 5, 5, 7, 7, 7});
    maker.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", kUnsignedShort}}},
        {"values", {{"bufferView", values}}}};
    const auto expected = std::vector<vec3>{{5, 5, 5}, {1, 0, 0}, {7, 7, 7}};
    EXPECT_EQ(readGltf(maker.glb(), "").positions, expected);
}

TEST(GltfAccessor, WithoutABufferViewValuesAreZeroButForSparseOnes) {
    GltfMaker maker = GltfMaker::triangle();
    const int indices = maker.view(std::vector<std::uint8_t>{1});
    const int values = maker.view(std::vector<float>{5, 6, 7});
    maker.json["accessors"][0].erase("bufferView");
    EXPECT_EQ(readGltf(maker.glb(), "").positions, std::vector<vec3>(3, vec3(0.0f)));
    maker.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
        {"values", {{"bufferView", values}}}};
    EXPECT_EQ(readGltf(maker.glb(), "").positions[1], vec3(5, 6, 7));
}

TEST(GltfIn, DataUrisAndBinaryChunksHoldTheSame) {
    GltfMaker maker = GltfMaker::triangle();
    const Source binary = readGltf(maker.glb(), ""), text = readGltf(maker.gltf(), "");
    EXPECT_EQ(binary.positions, text.positions);
    EXPECT_EQ(binary.triangles, text.triangles);
    EXPECT_EQ(binary.carried->buffers, text.carried->buffers);
    EXPECT_EQ(text.carried->buffers[0], maker.bin);
    const auto file = maker.gltf();
    EXPECT_EQ(text.carried->json,
              std::string(reinterpret_cast<const char*>(file.data()), file.size()));
}

TEST(GltfIn, ExternalBuffersAndPicturesAreCarried) {
    GltfMaker maker = GltfMaker::triangle();
    maker.json["buffers"] = {{{"byteLength", maker.bin.size()}, {"uri", "parts/a%20b.bin"}}};
    maker.json["images"] = {{{"uri", "coat.png"}}, {{"uri", "missing.png"}}};
    maker.json["textures"] = {{{"source", 0}}};
    maker.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    maker.primitive()["material"] = 0;
    const TempFolder folder;
    folder.write("parts/a b.bin", maker.bin);
    const auto picture = test::bytesOf("\x89PNG and so on");
    folder.write("coat.png", picture);
    const std::string path = folder.write("mesh.gltf", maker.json.dump());
    const Source source = readSource(path);
    EXPECT_EQ(source.path, path);
    EXPECT_EQ(source.carried->buffers[0], maker.bin);
    EXPECT_EQ(source.carried->images[0], picture);
    EXPECT_TRUE(source.carried->images[1].empty());
    EXPECT_EQ(source.images[0].bytes, picture);
    EXPECT_EQ(source.materials[0].image, 0);
    EXPECT_TRUE(warns(source, "missing.png"));
}

TEST(GltfIn, StripsAndFansAreUnrolledWithTheirWinding) {
    GltfMaker maker;
    const int position =
        maker.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0}, "VEC3", kFloat);
    maker = meshOf(maker, position);
    maker.primitive()["mode"] = 5;
    EXPECT_EQ(readGltf(maker.glb(), "").triangles,
              (std::vector<uvec3>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    maker.primitive()["mode"] = 6;
    EXPECT_EQ(readGltf(maker.glb(), "").triangles,
              (std::vector<uvec3>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
    maker.primitive()["indices"] = maker.add<std::uint8_t>({4, 3, 2, 1}, "SCALAR", kUnsignedByte);
    EXPECT_EQ(readGltf(maker.glb(), "").triangles, (std::vector<uvec3>{{3, 2, 4}, {2, 1, 4}}));
}

TEST(GltfIn, PrimitivesKeepTheirOrderAndCountTheirOwnVertices) {
    GltfMaker maker = GltfMaker::triangle();
    const Json first = maker.primitive();
    const int flipped = maker.add<std::uint32_t>({2, 1, 0, 0, 1, 2}, "SCALAR", kUnsignedInt);
    maker.json["meshes"][0]["primitives"].push_back(
        {{"attributes", first["attributes"]}, {"mode", 1}});
    maker.json["meshes"][0]["primitives"].push_back(
        {{"attributes", first["attributes"]}, {"indices", flipped}});
    maker.json["meshes"].push_back({{"name", "second"}, {"primitives", {first}}});
    const Source source = readGltf(maker.glb(), "");
    ASSERT_EQ(source.parts.size(), 3u);
    EXPECT_EQ(source.triangles, (std::vector<uvec3>{{0, 1, 2}, {5, 4, 3}, {3, 4, 5}, {6, 7, 8}}));
    EXPECT_EQ(source.parts[1].primitive, 2u);
    EXPECT_EQ(source.parts[1].firstTriangle, 1u);
    EXPECT_EQ(source.parts[1].triangleCount, 2u);
    EXPECT_EQ(source.parts[2].mesh, 1u);
    EXPECT_EQ(source.parts[2].firstVertex, 6u);
    EXPECT_EQ(source.parts[2].name, "second");
    EXPECT_EQ(source.fileVertices, 12u);  // the lines, too
    EXPECT_TRUE(warns(source, "meshes[0].primitives[1]: is made of points or lines"));
    EXPECT_TRUE(warns(source, "mesh 1 \"second\" is placed by no scene"));
}

TEST(GltfIn, NodesPlaceMeshesByMatrixOrByTranslationRotationScale) {
    GltfMaker maker = GltfMaker::triangle();
    const float s = std::sqrt(0.5f);
    maker.json["nodes"] = {
        {{"children", {1}}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1}}},
        {{"mesh", 0},
         {"translation", {1, 2, 3}},
         {"rotation", {0, 0, s, s}},
         {"scale", {1, 3, 1}}}};
    const Source source = readGltf(maker.glb(), "");
    const vec4 place =
        source.parts[0].toWorld * vec4(0, 1, 0, 1);  // scaled to y = 3, turned to x = -3
    EXPECT_NEAR(place.x, 10 + 2 * (1 - 3), 1e-4);
    EXPECT_NEAR(place.y, 20 + 2 * 2, 1e-4);
    EXPECT_NEAR(place.z, 30 + 2 * 3, 1e-4);
    EXPECT_EQ(source.positions[2], vec3(0, 1, 0));  // stays in mesh space
}

TEST(GltfIn, TheDefaultScenePlacesAndOthersHelpOut) {
    GltfMaker maker = GltfMaker::triangle();
    maker.json["meshes"].push_back(maker.json["meshes"][0]);
    maker.json["nodes"] = {{{"mesh", 0}, {"translation", {1, 0, 0}}},
                           {{"mesh", 0}, {"translation", {2, 0, 0}}},
                           {{"mesh", 1}, {"translation", {3, 0, 0}}},
                           {{"mesh", 0}, {"translation", {4, 0, 0}}}};
    maker.json["scenes"] = {{{"nodes", {0, 2}}}, {{"nodes", {1, 3}}}};
    maker.json["scene"] = 1;
    const Source source = readGltf(maker.glb(), "");
    EXPECT_EQ(source.parts[0].toWorld[3].x, 2.0f);
    EXPECT_EQ(source.parts[1].toWorld[3].x, 3.0f);
    EXPECT_TRUE(warns(source, "mesh 0 is placed 2 times"));
    EXPECT_TRUE(
        warns(source, "mesh 1 is not in the default scene; it is shown where scene 0 places it"));
    EXPECT_EQ(source.warnings.size(), 2u);
}

TEST(GltfIn, DefaultMorphWeightsMoveTheVertices) {
    GltfMaker maker = GltfMaker::triangle();
    const int up = maker.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", kFloat);
    const int aside = maker.add<float>({8, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", kFloat);
    maker.primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", aside}}};
    EXPECT_EQ(readGltf(maker.glb(), "").positions[0], vec3(0, 0, 0));
    maker.json["meshes"][0]["weights"] = {0.5, 0.25};
    EXPECT_EQ(readGltf(maker.glb(), "").positions[0], vec3(2, 0, 0.5f));
    maker.json["nodes"][0]["weights"] = {0, 1};  // those of the node win
    EXPECT_EQ(readGltf(maker.glb(), "").positions[0], vec3(8, 0, 0));
}

TEST(GltfSkin, RestPoseIsTheWeightedSumOfJointsWhereverTheNodeStands) {
    const Source source = readGltf(GltfMaker::skinned().glb(), "");
    ASSERT_EQ(source.vertexToWorld.size(), 3u);
    EXPECT_EQ(source.vertexToWorld[0][3], vec4(0, 0, 5, 1));
    EXPECT_EQ(source.vertexToWorld[1][3], vec4(0, 0, 5, 1));  // a weight of 2 counts as 1
    EXPECT_EQ(source.vertexToWorld[2],
              mat4(1.0f) + mat4(vec4(0), vec4(0), vec4(0), vec4(0, 0, 5, 0)));
}

TEST(GltfSkin, VerticesBelongToTheSegmentOfTheirDominantJoint) {
    const Source source = readGltf(GltfMaker::skinned().glb(), "");
    ASSERT_EQ(source.segments.size(), 2u);
    EXPECT_EQ(source.segments[source.segmentOf[0]].name, "hip");
    EXPECT_EQ(source.segments[source.segmentOf[1]].name, "neck");
    EXPECT_EQ(source.segments[source.segmentOf[2]].name, "neck");
    // From the joint to its child joint.
    EXPECT_EQ(source.segments[source.segmentOf[0]].root, vec3(0, 0, 5));
    EXPECT_EQ(source.segments[source.segmentOf[0]].tip, vec3(0, 1, 5));
}

TEST(GltfSkin, SegmentsLieFromTheHeadToTheTail) {
    GltfMaker maker = GltfMaker::skinned();
    maker.json["skins"][0].erase("inverseBindMatrices");
    maker.json["skins"][0]["joints"] = {1, 2, 3, 4};
    const Source source = readGltf(maker.glb(), "");
    const Segment& hip = source.segments[source.segmentOf[0]];
    EXPECT_EQ(hip.root, vec3(0, 1, 5));  // turned round, and the tail does not bend it
    EXPECT_EQ(hip.tip, vec3(0, 0, 5));
}

TEST(GltfSkin, FurtherSetsOfJointsCount) {
    GltfMaker maker = GltfMaker::skinned();
    maker.primitive()["attributes"]["JOINTS_1"] =
        maker.add<std::uint16_t>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", kUnsignedShort);
    maker.primitive()["attributes"]["WEIGHTS_1"] = maker.add<std::uint8_t>(
        {255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", kUnsignedByte, {{"normalized", true}});
    maker.json["skins"][0].erase("inverseBindMatrices");
    const Source source = readGltf(maker.glb(), "");
    EXPECT_EQ(source.vertexToWorld[0][3], vec4(0, 0.5f, 5, 1));
}

TEST(GltfMaterial, FactorTextureSetTransformAndColorsAreRead) {
    GltfMaker maker = GltfMaker::triangle();
    const int picture = maker.view(test::bytesOf("\x89PNG picture"));
    maker.json["images"] = {{{"bufferView", picture}, {"mimeType", "image/png"}, {"name", "coat"}}};
    maker.json["textures"] = {{{"source", 0}}};
    const Json transform = {{"offset", {0.5, 0.25}}, {"scale", {2, 4}}, {"texCoord", 1}};
    maker.json["materials"] = {
        {{"name", "fur"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 1, 1}},
           {"baseColorTexture",
            {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}}};
    maker.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_materials_unlit",
                                        "KHR_mesh_quantization"};
    auto& attributes = maker.primitive()["attributes"];
    maker.primitive()["material"] = 0;
    attributes["TEXCOORD_0"] = maker.add<float>({9, 9, 9, 9, 9, 9}, "VEC2", kFloat);
    attributes["TEXCOORD_1"] = maker.add<std::uint16_t>({0, 0, 65535, 0, 0, 65535}, "VEC2",
                                                        kUnsignedShort, {{"normalized", true}});
    attributes["COLOR_0"] = maker.add<float>({1, 0.5f, 0, 0, 0, 2, 0, 0, 0}, "VEC3", kFloat);
    const Source source = readGltf(maker.glb(), "");
    EXPECT_EQ(source.materials[0].name, "fur");
    EXPECT_EQ(source.materials[0].baseColor, vec4(0.5f, 0.25f, 1, 1));
    EXPECT_EQ(source.materials[0].image, 0);
    EXPECT_EQ(source.parts[0].material, 0);
    EXPECT_EQ(source.images[0].bytes, test::bytesOf("\x89PNG picture"));
    EXPECT_EQ(source.uvs, (std::vector<vec2>{{0.5f, 0.25f}, {2.5f, 0.25f}, {0.5f, 4.25f}}));
    EXPECT_EQ(source.colors, (std::vector<vec4>{{1, 0.5f, 0, 1}, {0, 0, 1, 1}, {0, 0, 0, 1}}));
}

TEST(GltfFur, FieldsAreReadBitForBitUnderAnySpelling) {
    GltfMaker maker = GltfMaker::triangle();
    const std::vector<float> length{0.1f, 1e-30f, 123.456f},
        direction{0, 0, 1, 0.6f, 0.8f, 0, 0.1f, -0.2f, 0.3f};
    auto& attributes = maker.primitive()["attributes"];
    attributes["__Fur_Length"] = maker.add<float>(length, "SCALAR", kFloat);
    attributes["_fur_direction"] = maker.add<float>(direction, "VEC3", kFloat);
    maker.json["meshes"].push_back(maker.json["meshes"][0]);
    maker.json["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", 0}};
    maker.json["meshes"][1]["extras"] = {{"fur", {{"version", 1}}}};
    const Source source = readGltf(maker.glb(), "");
    ASSERT_TRUE(source.fur);
    EXPECT_EQ(source.fur->length, (std::vector<float>{0, 0, 0, 0.1f, 1e-30f, 123.456f}));
    EXPECT_TRUE(source.fur->density.empty());
    EXPECT_EQ(source.fur->direction[5], vec3(0.1f, -0.2f, 0.3f));
    EXPECT_EQ(source.furBlock, "{\"version\":1}");
    EXPECT_FALSE(readGltf(GltfMaker::triangle().glb(), "").fur);
}

TEST(GltfFur, APrimitiveThatLacksAFieldOfAnotherIsToldOf) {
    GltfMaker maker = GltfMaker::triangle();
    Json bare = maker.primitive();
    maker.primitive()["attributes"]["_FUR_LENGTH"] = maker.add<float>({1, 1, 1}, "SCALAR", kFloat);
    maker.primitive()["attributes"]["_FUR_DENSITY"] =
        maker.add<float>({0.5f, 0.5f, 0.5f}, "SCALAR", kFloat);
    EXPECT_TRUE(readGltf(maker.glb(), "").warnings.empty());

    bare["attributes"]["_fur_density"] = maker.primitive()["attributes"]["_FUR_DENSITY"];
    for (const std::size_t at : {0u, 1u}) {  // before the one that has it, and after
        GltfMaker two = maker;
        Json& primitives = two.json["meshes"][0]["primitives"];
        primitives.insert(primitives.begin() + static_cast<int>(at), bare);
        const Source source = readGltf(two.glb(), "");
        EXPECT_EQ(source.warnings,
                  std::vector<std::string>{
                      "meshes[0].primitives[" + std::to_string(at) +
                      "]: has no fur_length, which other primitives have; it takes length 0"});
        EXPECT_EQ(source.fur->length[3 * at], 0.0f);
        EXPECT_EQ(source.fur->density[3 * at], 0.5f);
    }
}

TEST(GltfFur, ValuesThatNoFurHasAreChangedAndCounted) {
    GltfMaker maker = GltfMaker::triangle();
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                inf = std::numeric_limits<float>::infinity();
    auto& attributes = maker.primitive()["attributes"];
    attributes["_FUR_LENGTH"] = maker.add<float>({nan, -1, 2e6f}, "SCALAR", kFloat);
    attributes["_FUR_DENSITY"] = maker.add<float>({inf, 0.5f, 3}, "SCALAR", kFloat);
    attributes["_FUR_DIRECTION"] = maker.add<float>({nan, 0, 0, 0, 3, 0, 0, 0, 1}, "VEC3", kFloat);
    attributes["_FUR_TINT"] = maker.add<float>({nan, 2, -1, 0, 0.5f, 1, inf, 1, 1}, "VEC3", kFloat);
    const Source source = readGltf(maker.glb(), "");
    EXPECT_EQ(source.fur->tint, (std::vector<vec3>{{1, 1, 1}, {0, 0.5f, 1}, {1, 1, 1}}));
    EXPECT_TRUE(warns(source, "4 values of fur_tint were out of range"));
    EXPECT_EQ(source.fur->length, (std::vector<float>{0, 0, 1e6f}));
    EXPECT_EQ(source.fur->density, (std::vector<float>{0, 0.5f, 1}));
    EXPECT_EQ(source.fur->direction, (std::vector<vec3>{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_TRUE(warns(source, "3 values of fur_length were out of range"));
    EXPECT_TRUE(warns(source, "2 values of fur_density were out of range"));
    EXPECT_TRUE(warns(source, "2 values of fur_direction were out of range"));
}

TEST(GltfShared, TheFoxHasItsCountsAndItsBody) {
    const std::string path = sharedMesh("Fox.glb");
    if (path.empty()) GTEST_SKIP() << "the shared meshes are not here";
    const Source source = readSource(path);
    EXPECT_EQ(source.fileVertices, 1728u);
    EXPECT_EQ(source.triangles.size(), 576u);
    EXPECT_EQ(source.segments.size(), 21u);  // three of 24 joints hold no vertex most
    EXPECT_EQ(source.vertexToWorld.size(), 1728u);
    EXPECT_TRUE(source.warnings.empty());
    const Json json = Json::parse(source.carried->json);
    EXPECT_EQ(json["skins"][0]["joints"].size(), 24u);
    EXPECT_EQ(json["animations"].size(), 3u);
    for (const Segment& segment : source.segments) {
        const bool neckOrTail = segment.name.find("Neck") != std::string::npos ||
                                segment.name.find("Tail") != std::string::npos;
        EXPECT_TRUE(!neckOrTail || segment.root.z > segment.tip.z) << segment.name;
    }
}

TEST(GltfShared, TheTeapotHasItsCounts) {
    const std::string path = sharedMesh("teapot-2204.glb");
    if (path.empty()) GTEST_SKIP() << "the shared meshes are not here";
    const Source source = readSource(path);
    EXPECT_EQ(source.fileVertices, 2204u);
    EXPECT_EQ(source.triangles.size(), 4032u);
    EXPECT_EQ(source.normals.size(), 2204u);
}

}  // namespace
}  // namespace pelage
