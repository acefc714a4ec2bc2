// gltf_out_test.cpp -- the promises of gltf_out.h.
#include "core/gltf_out.h"

#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/animal.h"
#include "core/files.h"
#include "core/gltf_carried.h"
#include "core/gltf_carry.h"
#include "core/text.h"
#include "gltf_samples.h"
#include "gtest/gtest.h"
#include "painted.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;
using namespace test;

void expectSameSource(const Source& a, const Source& b) {
    EXPECT_TRUE(sameBits(a.positions, b.positions));
    EXPECT_TRUE(sameBits(a.normals, b.normals));
    EXPECT_TRUE(sameBits(a.uvs, b.uvs));
    EXPECT_TRUE(sameBits(a.colors, b.colors));
    EXPECT_EQ(a.segmentOf, b.segmentOf);
    EXPECT_EQ(a.segments, b.segments);
    EXPECT_TRUE(sameBits(a.vertexToWorld, b.vertexToWorld));
    EXPECT_TRUE(sameBits(a.triangles, b.triangles));
    EXPECT_EQ(a.parts.size(), b.parts.size());
    EXPECT_EQ(a.materials.size(), b.materials.size());
    ASSERT_EQ(a.images.size(), b.images.size());
    for (std::size_t i = 0; i < a.images.size(); ++i)
        EXPECT_EQ(a.images[i].bytes, b.images[i].bytes);
}

void expectRoundTrip(const Document& document, const ExportOptions& options = {}) {
    const Document again = opened(groomedGlb(document, options));
    expectSameFields(document, again);
    expectSameSource(*document.skin->source, *again.skin->source);
}

// Takes away what an export adds, so that what is left is the source. `before` says what there was.
void takeAway(OrderedJson& json, const OrderedJson& before) {
    for (OrderedJson& mesh : json["meshes"])
        for (OrderedJson& primitive : mesh["primitives"])
            for (const char* name : {"_FUR_LENGTH", "_FUR_DENSITY", "_FUR_DIRECTION", "_FUR_TINT"})
                primitive["attributes"].erase(name);
    for (const char* list : {"meshes", "nodes"})
        for (OrderedJson& object : json[list]) {
            if (!object.contains("extras") || !object["extras"].is_object()) continue;
            object["extras"].erase("fur");
            if (object["extras"].empty()) object.erase("extras");
        }
    for (const char* list : {"accessors", "bufferViews"})
        while (json[list].size() > before[list].size()) json[list].erase(json[list].size() - 1);
}

TEST(GltfOut, OpeningItRestoresTheFieldsBitForBit) { expectRoundTrip(painted(crowdedFile())); }

TEST(GltfOut, OpeningItRestoresTheFieldsWithTheMirrorToo) {
    ExportOptions options;
    options.compatibilityUvs = true;
    const Document document = painted(crowdedFile());
    expectSameFields(document, opened(groomedGlb(document, options)));
}

TEST(GltfOut, TintIsWrittenOnlyWhereSomeHairIsTinted) {
    Document document = painted(crowdedFile());
    const auto tints = [&] {
        std::size_t count = 0;
        const OrderedJson json = takeApart(groomedGlb(document)).json;
        for (const OrderedJson& mesh : json["meshes"])
            for (const OrderedJson& primitive : mesh["primitives"])
                count += primitive["attributes"].contains("_FUR_TINT");
        return count;
    };
    const std::size_t parts = document.skin->source->parts.size();
    EXPECT_EQ(tints(), parts);
    for (uint v = 0; v < document.groom.fur.size(); ++v)
        document.groom.fur.edit(v).tint = vec3(1.0f);
    EXPECT_EQ(tints(), 0u);
    expectRoundTrip(document);
    document.groom.fur.edit(1).tint = vec3(1.0f, 0.999999f, 1.0f);
    EXPECT_EQ(tints(), parts);
    expectRoundTrip(document);
}

TEST(GltfOut, ClearingTheTintTakesItOutOfTheFile) {
    Document document = opened(groomedGlb(painted(crowdedFile())));
    for (uint v = 0; v < document.groom.fur.size(); ++v)
        document.groom.fur.edit(v).tint = vec3(1.0f);
    const std::vector<std::byte> cleared = groomedGlb(document);
    EXPECT_EQ(takeApart(cleared).json.dump().find("TINT"), std::string::npos);
    EXPECT_EQ(takeApart(cleared).json.dump().find("fur tint"), std::string::npos);
    EXPECT_EQ(groomedGlb(opened(cleared)), cleared);
}

TEST(GltfOut, CarriesTheJsonValueForValueInItsOrder) {
    const std::vector<std::byte> file = crowdedFile();
    const auto* text = reinterpret_cast<const char*>(file.data());
    const OrderedJson before = OrderedJson::parse(text, text + file.size());
    OrderedJson after = takeApart(groomedGlb(painted(file))).json;
    takeAway(after, before);
    for (const auto& [key, value] : before.items()) {
        if (key == "buffers" || key == "bufferViews") continue;
        EXPECT_EQ(after[key].dump(), value.dump()) << key;
    }
    // Of views, only buffer and byteOffset may differ.
    for (std::size_t v = 0; v < before["bufferViews"].size(); ++v) {
        OrderedJson was = before["bufferViews"][v], is = after["bufferViews"][v];
        for (OrderedJson* view : {&was, &is}) view->erase("buffer"), view->erase("byteOffset");
        EXPECT_EQ(is.dump(), was.dump());
    }
    std::vector<std::string> orderBefore, orderAfter;
    for (const auto& [key, value] : before.items()) orderBefore.push_back(key);
    for (const auto& [key, value] : after.items()) orderAfter.push_back(key);
    EXPECT_EQ(orderAfter, orderBefore);
}

TEST(GltfOut, MergesBuffersByteForByte) {
    const Glb glb = takeApart(groomedGlb(painted(crowdedFile())));
    const auto buffers = crowdedBuffers();
    const OrderedJson before = crowdedGltf({});
    ASSERT_EQ(glb.json["buffers"].size(), 1u);
    EXPECT_EQ(glb.json["buffers"][0]["byteLength"], glb.bin.size());
    EXPECT_EQ(glb.json["buffers"][0]["name"], "zero");
    EXPECT_FALSE(glb.json["buffers"][0].contains("uri"));
    EXPECT_EQ(glb.json["buffers"][0]["extras"]["mergedBuffers"][1]["extras"]["kept"], true);
    for (std::size_t v = 0; v < before["bufferViews"].size(); ++v) {
        const OrderedJson &was = before["bufferViews"][v], &is = glb.json["bufferViews"][v];
        const std::size_t from = was.value("byteOffset", 0u), to = is.value("byteOffset", 0u);
        EXPECT_EQ(is["buffer"], 0);
        EXPECT_EQ(to % 4, 0u);
        EXPECT_EQ(std::memcmp(glb.bin.data() + to,
                              buffers[was["buffer"].get<std::size_t>()].data() + from,
                              was["byteLength"].get<std::size_t>()),
                  0);
    }
}

TEST(GltfOut, EveryPrimitiveOfTrianglesHasAllThreeFields) {
    const OrderedJson json = takeApart(groomedGlb(painted(crowdedFile()))).json;
    const OrderedJson& first = json["meshes"][0]["primitives"];
    for (const OrderedJson* primitive : {&first[0], &first[2], &json["meshes"][1]["primitives"][0]})
        for (const auto& [name, type] :
             {std::pair("_FUR_LENGTH", "SCALAR"), std::pair("_FUR_DENSITY", "SCALAR"),
              std::pair("_FUR_DIRECTION", "VEC3")}) {
            const auto accessor =
                json["accessors"][(*primitive)["attributes"][name].get<std::size_t>()];
            EXPECT_EQ(accessor["type"], type);
            EXPECT_EQ(accessor["componentType"], 5126);
            EXPECT_EQ(accessor["count"], 3);
            EXPECT_EQ(json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["target"],
                      34962);
        }
    EXPECT_FALSE(first[1]["attributes"].contains("_FUR_LENGTH"));
    // One mesh is one skin: primitives that share positions share the fields.
    EXPECT_EQ(first[0]["attributes"]["_FUR_LENGTH"], first[2]["attributes"]["_FUR_LENGTH"]);
    EXPECT_NE(first[0]["attributes"]["_FUR_LENGTH"],
              json["meshes"][1]["primitives"][0]["attributes"]["_FUR_LENGTH"]);
}

TEST(GltfOut, MinAndMaxAreThoseOfTheFloatsThatWereWritten) {
    const Glb glb = takeApart(groomedGlb(groomedAnimal(2000), {true}));
    for (std::size_t i = 0; i < glb.json["accessors"].size(); ++i) {
        const OrderedJson& accessor = glb.json["accessors"][i];
        if (!accessor.contains("min")) continue;
        const std::size_t width = accessor["min"].size();
        const std::vector<float> values = floatsOf(glb, i);
        for (std::size_t c = 0; c < width; ++c) {
            float least = values[c], greatest = values[c];
            for (std::size_t v = c; v < values.size(); v += width) {
                least = std::min(least, values[v]);
                greatest = std::max(greatest, values[v]);
            }
            EXPECT_EQ(static_cast<float>(accessor["min"][c].get<double>()), least);
            EXPECT_EQ(static_cast<float>(accessor["max"][c].get<double>()), greatest);
        }
    }
}

TEST(GltfOut, FurBlockIsOnMeshesAndTheNodesThatPlaceThem) {
    const Document document = painted(crowdedFile());
    const OrderedJson json = takeApart(groomedGlb(document)).json;
    const OrderedJson block = OrderedJson::parse(furToJson(document.fur));
    for (const OrderedJson* owner :
         {&json["meshes"][0], &json["meshes"][1], &json["nodes"][0], &json["nodes"][1]})
        EXPECT_EQ((*owner)["extras"]["fur"], block);
    EXPECT_EQ(json["nodes"][0]["extras"]["a"].dump(), "[1,{\"b\":null}]");
    EXPECT_EQ(json["nodes"][2]["extras"], 12.5);  // no object, so it is left alone
}

TEST(GltfOut, FurBlockGoesToTheAssetWhereNoOtherExtrasCanHoldIt) {
    const auto file = crowdedFile(OrderedJson::parse(R"([
        {"op": "replace", "path": "/meshes/0/extras", "value": "text"},
        {"op": "add", "path": "/meshes/1/extras", "value": {"fur": "brown"}},
        {"op": "replace", "path": "/nodes/0/extras", "value": []},
        {"op": "add", "path": "/nodes/1/extras", "value": 3}])"));
    const Document document = painted(file);
    const auto bytes = groomedGlb(document);
    const OrderedJson json = takeApart(bytes).json;
    EXPECT_EQ(json["meshes"][0]["extras"], "text");
    EXPECT_EQ(json["meshes"][1]["extras"]["fur"], "brown");
    EXPECT_EQ(json["asset"]["extras"]["fur"]["seed"], document.fur.seed);
    EXPECT_EQ(furToJson(opened(bytes).fur), furToJson(document.fur));
}

TEST(GltfOut, SavingTwentyTimesGivesTheSameBytes) {
    for (const bool mirror : {false, true}) {
        const auto first = groomedGlb(painted(crowdedFile()), {mirror});
        auto bytes = first;
        for (int i = 0; i < 20; ++i) bytes = groomedGlb(opened(bytes), {mirror});
        EXPECT_EQ(bytes, first);
    }
}

TEST(GltfOut, MirrorLeavesNothingBehindWhenItIsTurnedOff) {
    const Document document = painted(crowdedFile());
    const auto plain = groomedGlb(document, {false}), mirrored = groomedGlb(document, {true});
    EXPECT_EQ(groomedGlb(opened(mirrored), {false}), plain);
    EXPECT_EQ(groomedGlb(opened(plain), {true}), mirrored);
}

TEST(GltfOut, FieldsOfOtherProgramsAreReplacedAndTheFileStopsGrowing) {
    const auto file = crowdedFile(OrderedJson::parse(R"([
        {"op": "add", "path": "/meshes/0/primitives/0/attributes/__Fur_Length", "value": 2},
        {"op": "add", "path": "/meshes/0/primitives/0/attributes/_fur_density", "value": 2}])"));
    const Document document = painted(file);
    const auto first = groomedGlb(document);
    const OrderedJson attributes =
        takeApart(first).json["meshes"][0]["primitives"][0]["attributes"];
    EXPECT_EQ(attributes.size(), 5u) << attributes;
    expectSameFields(document, opened(first));
    EXPECT_EQ(groomedGlb(opened(first)), first);
}

TEST(GltfOut, FieldsThatAFileLacksAreThoseOfAFirstGroom) {
    const auto file = crowdedFile(OrderedJson::parse(
        R"([{"op": "add", "path": "/meshes/1/primitives/0/attributes/_fur_length", "value": 2}])"));
    const Document bare = opened(crowdedFile()), partial = opened(file);
    const uint v = partial.skin->weld.back();
    EXPECT_EQ(partial.groom.fur[v].furLength, 2.5f);
    EXPECT_EQ(partial.groom.fur[v].density, bare.groom.fur[v].density);
    EXPECT_EQ(partial.groom.fur[v].direction, bare.groom.fur[v].direction);
}

TEST(GltfOut, AnotherGroomOfTheSameFileHasTheSameSize) {
    Document document = painted(crowdedFile());
    const auto first = groomedGlb(document);
    Document again = opened(first);
    paint(again, 1);
    const auto second = groomedGlb(again);
    expectSameFields(again, opened(second));
    EXPECT_EQ(takeApart(first).bin.size(), takeApart(second).bin.size());
}

TEST(GltfOut, MirrorFollowsTheSetsInUseWithoutGaps) {
    const Document document = painted(crowdedFile());
    const Glb glb = takeApart(groomedGlb(document, {true}));
    const OrderedJson& attributes = glb.json["meshes"][1]["primitives"][0]["attributes"];
    EXPECT_EQ(attributes["TEXCOORD_0"], 4);
    const auto zero = floatsOf(glb, attributes["TEXCOORD_1"].get<std::size_t>());
    EXPECT_EQ(zero, std::vector<float>(6, 0.0f));
    const auto lengths = floatsOf(glb, attributes["_FUR_LENGTH"].get<std::size_t>());
    const auto densities = floatsOf(glb, attributes["_FUR_DENSITY"].get<std::size_t>());
    const auto directions = floatsOf(glb, attributes["_FUR_DIRECTION"].get<std::size_t>());
    const auto a = floatsOf(glb, attributes["TEXCOORD_2"].get<std::size_t>());
    const auto b = floatsOf(glb, attributes["TEXCOORD_3"].get<std::size_t>());
    const auto c = floatsOf(glb, attributes["TEXCOORD_4"].get<std::size_t>());
    for (std::size_t v = 0; v < 3; ++v) {
        EXPECT_EQ(a[2 * v], lengths[v]);
        EXPECT_EQ(a[2 * v + 1], densities[v]);
        EXPECT_EQ(b[2 * v], directions[3 * v]);
        EXPECT_EQ(b[2 * v + 1], directions[3 * v + 1]);
        EXPECT_EQ(c[2 * v], directions[3 * v + 2]);
        EXPECT_EQ(c[2 * v + 1], 0.0f);
    }
    EXPECT_EQ(glb.json["meshes"][1]["extras"]["fur"]["uvSet"], 2);
}

TEST(GltfOut, MirrorStartsLaterWhereTheSetsAreTaken) {
    const auto file = crowdedFile(OrderedJson::parse(R"([
        {"op": "add", "path": "/meshes/1/primitives/0/attributes/TEXCOORD_1", "value": 4},
        {"op": "add", "path": "/meshes/1/primitives/0/attributes/TEXCOORD_2", "value": 4}])"));
    const OrderedJson json = takeApart(groomedGlb(painted(file), {true})).json;
    for (const std::size_t mesh : {0u, 1u}) {
        const OrderedJson& attributes = json["meshes"][mesh]["primitives"][0]["attributes"];
        for (int set = 0; set < 6; ++set)
            EXPECT_TRUE(attributes.contains("TEXCOORD_" + std::to_string(set))) << attributes;
        EXPECT_EQ(json["meshes"][mesh]["extras"]["fur"]["uvSet"], 3);
    }
    EXPECT_EQ(json["meshes"][1]["primitives"][0]["attributes"]["TEXCOORD_2"], 4);
}

TEST(GltfOut, ExternalBuffersAndPicturesAreEmbedded) {
    const TempFolder folder;
    const auto buffers = crowdedBuffers();
    OrderedJson json = crowdedGltf({"a.bin", "b.bin", "c.bin"});
    json["images"][0]["uri"] = "fell.png";
    folder.write("a.bin", buffers[0]);
    folder.write("b.bin", buffers[1]);
    folder.write("c.bin", buffers[2]);
    folder.write("fell.png", pictureBytes());
    const std::string path = folder.write("crowded.gltf", json.dump(1));
    Document document = openDocument(readSource(path));
    paint(document);

    const std::string output = folder.path("out.glb");
    writeGroomedGlb(document, output);
    for (const char* name : {"a.bin", "b.bin", "c.bin", "fell.png"}) fs::remove(folder.path(name));
    const Document again = openDocument(readSource(output));
    expectSameFields(document, again);
    expectSameSource(*document.skin->source, *again.skin->source);
    const Glb glb = takeApart(readFile(output, 1 << 20));
    EXPECT_EQ(glb.json["images"][0]["mimeType"], "image/png");
    EXPECT_FALSE(glb.json["images"][0].contains("uri"));
    EXPECT_EQ(groomedGlb(again), readFile(output, 1 << 20));
}

TEST(GltfOut, OtherSourcesBecomeOneMeshWithTheirVerticesInOrder) {
    const Document document = paintedObj();
    expectRoundTrip(document);
    const OrderedJson json = takeApart(groomedGlb(document)).json;
    EXPECT_EQ(json["meshes"].size(), 1u);
    EXPECT_EQ(json["nodes"].size(), 1u);
    EXPECT_EQ(document.skin->report.degenerateFaces, 1u);
    EXPECT_EQ(document.skin->triangles.size(), 3u);
}

TEST(GltfOut, NamesThatAreNotUtf8AreWrittenWithReplacements) {
    Source source = makeAnimal(2000);
    source.parts[0].name = "b\xe9te";  // Latin-1, as old OBJ files and file names have it
    const OrderedJson json = takeApart(groomedGlb(openDocument(std::move(source)))).json;
    EXPECT_EQ(json["meshes"][0]["name"], "b\xef\xbf\xbdte");
}

TEST(GltfOut, ManyNodesDoNotTakeTimeByTheirSquare) {
    OrderedJson nodes = OrderedJson::array();
    for (int i = 0; i < 1000000; ++i) nodes.push_back(OrderedJson::object());
    const CarriedGltf carried{OrderedJson{{"nodes", nodes}}.dump(), {}, {}};
    // By the square this would take the better part of an hour.
    EXPECT_EQ(carriedDraft(carried).json["nodes"].size(), nodes.size());
}

TEST(GltfOut, NormalsOfOtherSourcesAreMadeUnit) {
    Source source = makeAnimal(2000);
    source.normals[0] *= 3.0f;
    source.normals[1] = vec3(0.0f);
    const Glb glb = takeApart(groomedGlb(openDocument(std::move(source))));
    const auto accessor = glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"];
    const std::vector<float> normals = floatsOf(glb, accessor.get<std::size_t>());
    for (std::size_t i = 0; i < normals.size(); i += 3)
        ASSERT_NEAR(glm::length(vec3(normals[i], normals[i + 1], normals[i + 2])), 1.0f, 1e-3f);
}

TEST(GltfOut, BuiltInAnimalComesBackWithItsSegments) {
    const Document document = groomedAnimal(2000);
    expectRoundTrip(document);
    const Document again = opened(groomedGlb(document));
    EXPECT_EQ(again.skin->source->segments, document.skin->source->segments);
    EXPECT_EQ(groomedGlb(again), groomedGlb(document));
}

TEST(GltfOut, FoxKeepsJointsAnimationsAndTheirData) {
    const std::string path = sharedMesh("Fox.glb");
    if (path.empty()) GTEST_SKIP() << "Fox.glb is not there";
    const Glb before = takeApart(readFile(path, 1 << 24));
    Document document = openDocument(readSource(path));
    paint(document);
    expectRoundTrip(document);
    Glb after = takeApart(groomedGlb(document));
    EXPECT_EQ(after.json["skins"][0]["joints"].size(), 24u);
    EXPECT_EQ(after.json["animations"].size(), 3u);
    takeAway(after.json, before.json);
    after.json["buffers"][0]["byteLength"] = before.json["buffers"][0]["byteLength"];
    EXPECT_EQ(after.json.dump(), before.json.dump());
    ASSERT_GE(after.bin.size(), before.json["buffers"][0]["byteLength"].get<std::size_t>());
    EXPECT_EQ(std::memcmp(after.bin.data(), before.bin.data(),
                          before.json["buffers"][0]["byteLength"].get<std::size_t>()),
              0);
}

TEST(GltfOut, SharedMeshesComeBackBitForBit) {
    for (const char* name : {"stanford-bunny.obj", "teapot.obj", "teapot-2204.glb", "suzanne.obj",
                             "spot.obj", "Fox.glb"}) {
        const std::string path = sharedMesh(name);
        if (path.empty()) GTEST_SKIP() << name << " is not there";
        SCOPED_TRACE(name);
        Document document = openDocument(readSource(path));
        paint(document);
        const auto bytes = groomedGlb(document);
        const Document again = opened(bytes);
        expectSameFields(document, again);
        EXPECT_TRUE(sameBits(document.skin->source->positions, again.skin->source->positions));
        EXPECT_TRUE(sameBits(document.skin->source->triangles, again.skin->source->triangles));
        EXPECT_EQ(groomedGlb(again), bytes);
    }
}

TEST(GltfOut, CancelledWorkThrowsAndWritesNothing) {
    const TempFolder folder;
    Progress progress;
    progress.cancel = true;
    const std::string path = folder.path("out.glb");
    EXPECT_THROW(writeGroomedGlb(groomedAnimal(2000), path, {}, &progress), Cancelled);
    EXPECT_FALSE(fs::exists(path));
}

TEST(GltfOut, OnlyFilesNamedGlbAreWritten) {
    const TempFolder folder;
    const std::string path = folder.write("horse.obj", "v 0 0 0\n");
    EXPECT_EQ(refusal([&] { writeGroomedGlb(paintedObj(), path); }),
              inQuotes(path) + " does not end in .glb");
    EXPECT_EQ(readFile(path, 100), bytesOf("v 0 0 0\n"));
}

TEST(GltfOut, ContainerIsAligned) {
    const auto bytes = groomedGlb(painted(crowdedFile()));
    EXPECT_EQ(wordAt(bytes, 0), 0x46546C67u);
    EXPECT_EQ(wordAt(bytes, 4), 2u);
    EXPECT_EQ(wordAt(bytes, 8), bytes.size());
    EXPECT_EQ(wordAt(bytes, 12) % 4, 0u);
    EXPECT_EQ(bytes.size() % 4, 0u);
}

}  // namespace
}  // namespace pelage
