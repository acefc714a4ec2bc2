// gltf_refusals_test.cpp -- bad glTF files: one line that names the file, the place and the
// numbers.
#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include "core/gltf_in.h"
#include "gltf_maker.h"
#include "reading.h"

namespace pelage {
namespace {

using test::GltfMaker;
using test::refusal;
using test::TempFolder;
using Json = nlohmann::json;

// What a triangle is refused with after it was spoiled.
std::string refusalOf(const std::function<void(GltfMaker&)>& spoil) {
    GltfMaker maker = GltfMaker::triangle();
    spoil(maker);
    return refusal([&] { readGltf(maker.glb(), ""); });
}

std::string refusalOfText(const std::string& text) {
    return refusal([&] { readGltf(test::bytesOf(text), ""); });
}

std::string refusalOfPatch(const std::string& patch) {
    return refusalOf([&](GltfMaker& maker) { maker.json.merge_patch(Json::parse(patch)); });
}

TEST(GltfRefusal, BrokenContainersSaySo) {
    const auto glb = GltfMaker::triangle().glb();
    const auto cut = [&](std::size_t size) {
        return refusal([&] { readGltf(std::span(glb).first(size), ""); });
    };
    EXPECT_EQ(cut(10), "glTF: is truncated: a .glb has at least 20 bytes, this has 10");
    EXPECT_EQ(cut(100), "glTF: is truncated: its header says " + std::to_string(glb.size()) +
                            " bytes, there are 100");
    auto old = glb;
    old[4] = std::byte{1};
    EXPECT_EQ(refusal([&] { readGltf(old, ""); }), "glTF: is a .glb of version 1; only 2 is read");
    auto long0 = glb;
    long0[13] = std::byte{0xff};
    EXPECT_NE(refusal([&] { readGltf(long0, ""); }).find("chunk 0 says"), std::string::npos);
    EXPECT_EQ(refusalOfText("{\"asset\""), "glTF: JSON is broken or cut off at byte 9 of 8");
    EXPECT_EQ(refusalOfText("[]"), "glTF: JSON is not an object, so this is no glTF");
    EXPECT_EQ(refusalOfText("{}"), "glTF: has no \"asset\"");
    EXPECT_EQ(refusalOfText(R"({"asset":{"version":"1.0"}})"),
              "glTF: asset: version is \"1.0\"; only glTF 2.0 is read");
    EXPECT_EQ(refusalOfText(R"({"asset":{"version":"2.0"}})"), "glTF: holds no triangle");
    EXPECT_EQ(refusalOfText("{\"asset\":1e999}"),
              "glTF: JSON holds a number that no float can hold");
    EXPECT_EQ(refusalOfText(std::string(100000, '[')),
              "glTF: JSON at byte 200 is nested deeper than 200");
}

TEST(GltfRefusal, TruncationAtEveryByteIsRefusedAndNeverCrashes) {
    GltfMaker maker = GltfMaker::triangle();
    maker.primitive()["indices"] = maker.add<std::uint16_t>({0, 1, 2}, "SCALAR", 5123);
    for (const auto& file : {maker.glb(), maker.gltf()}) {
        for (std::size_t size = 0; size < file.size(); ++size) {
            const std::vector<std::byte> cut(file.begin(),
                                             file.begin() + static_cast<std::ptrdiff_t>(size));
            const std::string message = refusal([&] { readGltf(cut, ""); });
            EXPECT_TRUE(message.starts_with("glTF: ")) << size << ": " << message;
        }
    }
}

TEST(GltfRefusal, RequiredExtensionsAreRefusedByName) {
    for (const char* name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "ACME_hair"}) {
        EXPECT_EQ(
            refusalOf([&](GltfMaker& maker) { maker.json["extensionsRequired"] = {name}; }),
            "glTF: needs the extension \"" + std::string(name) + "\", which is not supported");
    }
    EXPECT_EQ(refusalOfPatch(R"({"extensionsRequired":[7]})"),
              "glTF: extensionsRequired[0]: is not a string");
}

TEST(GltfRefusal, CompressionWithoutAFallbackIsRefusedByName) {
    EXPECT_EQ(refusalOf([](GltfMaker& maker) {
                  maker.json["accessors"][0].erase("bufferView");
                  maker.primitive()["extensions"]["KHR_draco_mesh_compression"] = Json::object();
              }),
              "glTF: meshes[0].primitives[0]: has its vertices only through "
              "\"KHR_draco_mesh_compression\", which is not supported");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) {
                  maker.json["buffers"] = {
                      {{"byteLength", 36}},
                      {{"byteLength", 36},
                       {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
              }),
              "glTF: buffers[1]: has its bytes only through \"EXT_meshopt_compression\", which is "
              "not supported");
}

TEST(GltfRefusal, ReferencesToNothingNameTheirPlace) {
    const struct {
        const char *patch, *message;
    } rows[] = {
        {R"({"scene":3})", "scene: is 3, but there are 1 scenes"},
        {R"({"scenes":[{"nodes":[7]}]})", "scenes[0].nodes[0]: is 7, but there are 1 nodes"},
        {R"({"nodes":[{"mesh":1}]})", "nodes[0].mesh: is 1, but there are 1 meshes"},
        {R"({"nodes":[{"children":[1]}]})", "nodes[0].children[0]: is 1, but there are 1 nodes"},
        {R"({"nodes":[{"mesh":0,"skin":0}]})", "nodes[0].skin: is 0, but there are 0 skins"},
        {R"({"nodes":[{"mesh":-1}]})",
         "nodes[0].mesh: is -1, not a whole number from 0 to 4294967295"},
        {R"({"nodes":[{"mesh":"x"}]})",
         "nodes[0].mesh: is \"x\", not a whole number from 0 to 4294967295"},
        {R"({"nodes":{}})", "nodes: is an object, not an array"},
        {R"({"nodes":[3]})", "nodes[0]: is not an object"},
        {R"({"bufferViews":[{"buffer":2}]})",
         "bufferViews[0].buffer: is 2, but there are 1 buffers"},
        {R"({"images":[{"bufferView":9}]})",
         "images[0].bufferView: is 9, but there are 1 bufferViews"},
        {R"({"textures":[{"source":0}]})", "textures[0].source: is 0, but there are 0 images"},
        {R"({"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":4}}}]})",
         "materials[0].pbrMetallicRoughness.baseColorTexture.index: is 4, but there are 0 "
         "textures"},
        {R"({"skins":[{"joints":[5]}]})", "skins[0].joints[0]: is 5, but there are 1 nodes"},
        {R"({"skins":[{"inverseBindMatrices":5}]})",
         "skins[0].inverseBindMatrices: is 5, but there are 1 accessors"},
        {R"({"animations":[{"channels":[{"target":{"node":5}}]}]})",
         "animations[0].channels[0].target.node: is 5, but there are 1 nodes"},
        {R"({"meshes":[{"primitives":[{"attributes":{"POSITION":1}}]}]})",
         "meshes[0].primitives[0].attributes.POSITION: is 1, but there are 1 accessors"},
        {R"({"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":9}]}]})",
         "meshes[0].primitives[0].indices: is 9, but there are 1 accessors"},
        {R"({"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}]})",
         "meshes[0].primitives[0].material: is 0, but there are 0 materials"},
        {R"({"meshes":[{"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":3}]}]}]})",
         "meshes[0].primitives[0].targets[0].POSITION: is 3, but there are 1 accessors"},
        {R"({"meshes":[{}]})", "meshes[0]: has no \"primitives\""},
    };
    for (const auto& row : rows)
        EXPECT_EQ(refusalOfPatch(row.patch), std::string("glTF: ") + row.message);
}

TEST(GltfRefusal, NodesThatAreTheirOwnAncestorOrHaveTwoParentsAreRefused) {
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0},{"children":[2]},{"children":[1]}]})"),
              "glTF: nodes[1]: is its own ancestor");
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0,"children":[0]}]})"),
              "glTF: nodes[0]: is its own ancestor");
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0},{"children":[0]},{"children":[0]}]})"),
              "glTF: nodes[2]: child 0 is already a child of node 1");
}

TEST(GltfRefusal, NumbersThatNoTransformHasAreRefused) {
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0,"matrix":[1,2]}]})"),
              "glTF: nodes[0].matrix: has 2 numbers, not 16");
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0,"scale":[1,"a",1]}]})"),
              "glTF: nodes[0].scale[1]: is \"a\", not a number");
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0,"scale":[1,1e39,1]}]})"),
              "glTF: nodes[0].scale[1]: is 1e+39, too large for a float");
    EXPECT_EQ(
        refusalOfPatch(
            R"({"nodes":[{"children":[1],"scale":[1e30,1,1]},{"mesh":0,"scale":[1e30,1,1]}]})"),
        "glTF: nodes[1]: its transform is too large for floats");
    EXPECT_EQ(refusalOfPatch(R"({"nodes":[{"mesh":0,"scale":[1e20,1,1]}]})"),
              "glTF: vertex 1 is more than 1e12 from the origin");
}

TEST(GltfRefusal, AccessorsPastTheirBufferAreRefused) {
    const auto accessor = [](const std::string& patch) {
        return refusalOf(
            [&](GltfMaker& maker) { maker.json["accessors"][0].merge_patch(Json::parse(patch)); });
    };
    EXPECT_EQ(accessor(R"({"count":4})"),
              "glTF: accessors[0]: 4 elements end at byte 48 of a buffer view of 36");
    EXPECT_EQ(accessor(R"({"byteOffset":4})"),
              "glTF: accessors[0]: 3 elements end at byte 40 of a buffer view of 36");
    EXPECT_EQ(accessor(R"({"count":0})"),
              "glTF: accessors[0].count: is 0, not a whole number from 1 to 2147483648");
    EXPECT_EQ(accessor(R"({"count":18446744073709551615})"),
              "glTF: accessors[0].count: is 18446744073709551615, not a whole number from 1 to "
              "2147483648");
    EXPECT_EQ(accessor(R"({"count":1.5})"),
              "glTF: accessors[0].count: is 1.5, not a whole number from 1 to 2147483648");
    EXPECT_EQ(accessor(R"({"componentType":5124})"),
              "glTF: accessors[0]: componentType 5124 is none of glTF");
    EXPECT_EQ(accessor(R"({"type":"VEC9"})"),
              "glTF: accessors[0]: type is \"VEC9\", which is none of glTF");
    EXPECT_EQ(accessor(R"({"type":"VEC2"})"),
              "glTF: accessors[0]: has 2 components where 3 are needed");
    EXPECT_NE(accessor(R"({"bufferView":null,"count":2000000000})")
                  .find("elements are made from nothing"),
              std::string::npos);
    EXPECT_NE(accessor(R"({"sparse":{"count":9}})").find("accessors[0].sparse.count: is 9"),
              std::string::npos);
    EXPECT_EQ(accessor(R"({"sparse":{"count":1}})"),
              "glTF: accessors[0].sparse: has no \"indices\"");
    EXPECT_NE(refusalOf([](GltfMaker& maker) {
                  maker.json["bufferViews"][0]["byteStride"] = 4;
              }).find("byteStride 4 of its buffer view is less than an element of 12 bytes"),
              std::string::npos);
    EXPECT_EQ(refusalOf([](GltfMaker& maker) { maker.json["bufferViews"][0]["byteLength"] = 99; }),
              "glTF: bufferViews[0]: bytes 0 to 99 are past the end of a buffer of 36");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) {
                  maker.json["buffers"] = {{{"byteLength", 100}}};
              }),
              "glTF: buffers[0]: byteLength is 100, but it has 36 bytes");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) {
                  const int indices = maker.view(std::vector<std::uint8_t>{3});
                  maker.json["accessors"][0]["sparse"] = {
                      {"count", 1},
                      {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                      {"values", {{"bufferView", 0}}}};
              }),
              "glTF: accessors[0].sparse: index 0 is 3 of 3");
}

TEST(GltfRefusal, PrimitivesThatContradictThemselvesAreRefused) {
    EXPECT_EQ(
        refusalOf([](GltfMaker& maker) {
            maker.primitive()["indices"] = maker.add<std::uint16_t>({0, 1, 9}, "SCALAR", 5123);
        }),
        "glTF: meshes[0].primitives[0]: index 2 names vertex 9 of 3");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) {
                  maker.primitive()["indices"] = maker.add<float>({0, 1, 2}, "SCALAR", 5126);
              }),
              "glTF: accessors[1]: componentType 5126 is not one of unsigned integers");
    EXPECT_EQ(
        refusalOf([](GltfMaker& maker) {
            maker.primitive()["attributes"]["NORMAL"] = maker.add<float>({0, 0, 1}, "VEC3", 5126);
        }),
        "glTF: meshes[0].primitives[0].attributes: NORMAL has 1 values for 3 vertices");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) { maker.primitive()["mode"] = 7; }),
              "glTF: meshes[0].primitives[0].mode: is 7, not a whole number from 0 to 6");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) {
                  const float nan = std::numeric_limits<float>::quiet_NaN();
                  maker.primitive()["attributes"]["POSITION"] =
                      maker.add<float>({0, 0, 0, 1, 0, 0, 0, nan, 0}, "VEC3", 5126);
              }),
              "glTF: meshes[0].primitives[0].attributes: POSITION of vertex 2 is not finite");
    EXPECT_EQ(refusalOf([](GltfMaker& maker) { maker.primitive()["mode"] = 1; }),
              "glTF: holds no triangle");
}

TEST(GltfRefusal, SkinsThatContradictThemselvesAreRefused) {
    const auto skin = [](std::uint8_t joint, float weight, std::size_t matrices) {
        return refusalOf([&](GltfMaker& maker) {
            auto& attributes = maker.primitive()["attributes"];
            attributes["JOINTS_0"] =
                maker.add<std::uint8_t>({joint, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 5121);
            attributes["WEIGHTS_0"] =
                maker.add<float>({weight, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 5126);
            maker.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, Json::object(), Json::object()};
            maker.json["skins"] = {
                {{"joints", {1, 2}},
                 {"inverseBindMatrices",
                  maker.add(std::vector<float>(matrices * 16, 1.0f), "MAT4", 5126)}}};
        });
    };
    EXPECT_EQ(skin(2, 1.0f, 2), "glTF: meshes[0].primitives[0]: vertex 0 names joint 2 of 2");
    EXPECT_EQ(skin(0, -1.0f, 2),
              "glTF: meshes[0].primitives[0]: a weight of vertex 0 is negative or not finite");
    EXPECT_EQ(skin(0, 1.0f, 1), "glTF: skins[0]: has 1 inverse bind matrices for 2 joints");
    EXPECT_EQ(skin(9, 0.0f, 2), "(not refused)");  // a joint without weight is not looked at
}

TEST(GltfRefusal, FilesOutOfTheFolderAreNeverOpened) {
    const TempFolder folder;
    const GltfMaker maker = GltfMaker::triangle();
    folder.write("secret.bin", maker.bin);
    std::filesystem::create_directory(folder.path("inner"));
    std::filesystem::create_symlink("../secret.bin", folder.path("inner/link.bin"));
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), folder.path("secret.bin"),
          "file://" + folder.path("secret.bin"), std::string("http://localhost/secret.bin"),
          std::string("link.bin"), std::string("|cat ../secret.bin")}) {
        Json json = maker.json;
        json["buffers"] = {{{"byteLength", maker.bin.size()}, {"uri", uri}}};
        const std::string path = folder.write("inner/mesh.gltf", json.dump());
        const std::string message = refusal([&] { readSource(path); });
        EXPECT_TRUE(message.starts_with(path + ": reference \"")) << uri << " -> " << message;
        EXPECT_EQ(message.find("No such file"), std::string::npos) << message;

        // A picture may be missing, but it may not leave the folder either.
        Json picture = maker.json;
        picture["buffers"] = {{{"byteLength", maker.bin.size()}, {"uri", "mesh.bin"}}};
        picture["images"] = {{{"uri", uri}}};
        folder.write("inner/mesh.bin", maker.bin);
        EXPECT_TRUE(refusal([&] {
                        readSource(folder.write("inner/mesh.gltf", picture.dump()));
                    }).starts_with(path + ": reference \""))
            << uri;
    }
}

TEST(GltfRefusal, BadDataUrisAreRefused) {
    const auto uri = [](const char* text) {
        return refusalOf([&](GltfMaker& maker) {
            maker.json["buffers"] = {{{"byteLength", 36}, {"uri", text}}};
        });
    };
    EXPECT_EQ(uri("data:;base64,!!!!"),
              "glTF: buffers[0]: its data URI has no base64 digit at character 13");
    EXPECT_EQ(uri("data:,hello"), "glTF: buffers[0]: its data URI is not in base64");
    EXPECT_EQ(uri("data:;base64,AAAA"), "glTF: buffers[0]: byteLength is 36, but it has 3 bytes");
    EXPECT_EQ(uri("buffer.bin"),
              "reference \"buffer.bin\" is to another file, and there is no folder to look in");
}

// Small files that ask for much: each must be refused or read with work bound to the file's size.
TEST(GltfRefusal, SmallFilesCannotAskForTooMuch) {
    EXPECT_NE(refusalOf([](GltfMaker& maker) {
                  maker.json["accessors"][0] = {
                      {"count", 200000}, {"type", "VEC3"}, {"componentType", 5126}};
                  const Json primitive = maker.primitive();
                  for (int i = 0; i < 50; ++i)
                      maker.json["meshes"][0]["primitives"].push_back(primitive);
              }).find("too many for a file of this size"),
              std::string::npos);
    EXPECT_NE(refusalOf([](GltfMaker& maker) {
                  maker.json["accessors"].push_back(
                      {{"count", 200000}, {"type", "VEC3"}, {"componentType", 5126}});
                  maker.primitive()["attributes"]["POSITION"] = 1;
                  for (int i = 0; i < 100; ++i) {
                      maker.primitive()["targets"].push_back({{"POSITION", 1}});
                      maker.json["meshes"][0]["weights"].push_back(1);
                  }
              }).find("asks for too many numbers"),
              std::string::npos);
    EXPECT_NE(refusalOf([](GltfMaker& maker) {
                  const int view = maker.view(std::vector<char>(1 << 20, 'x'));
                  for (int i = 0; i < 200; ++i) {
                      maker.json["images"].push_back({{"bufferView", view}});
                      maker.json["textures"].push_back({{"source", i}});
                      maker.json["materials"].push_back(
                          {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
                  }
              }).find("too many large pictures"),
              std::string::npos);
    // One accessor without bytes of its own, for a quarter of a gigabyte of attributes.
    EXPECT_NE(refusalOf([](GltfMaker& maker) {
                  maker.json["accessors"][0] = {
                      {"count", 1000000}, {"type", "VEC3"}, {"componentType", 5126}};
              }).find("are made from nothing in a file of this size"),
              std::string::npos);
}

TEST(GltfRefusal, ALongChainOfNodesIsWalkedWithoutRecursion) {
    GltfMaker maker = GltfMaker::triangle();
    Json nodes = Json::array();
    const int count = 100000;
    for (int i = 0; i + 1 < count; ++i) nodes.push_back({{"children", {i + 1}}});
    nodes.push_back({{"mesh", 0}});
    maker.json["nodes"] = nodes;
    EXPECT_EQ(readGltf(maker.glb(), "").triangles.size(), 1u);
}

TEST(GltfRefusal, CancelStopsTheWork) {
    Progress progress;
    progress.cancel = true;
    EXPECT_THROW(readGltf(GltfMaker::triangle().glb(), "", &progress), Cancelled);
}

}  // namespace
}  // namespace pelage
