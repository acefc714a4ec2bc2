// tinygltf_test.cpp -- what another library finds in the files of gltf_out.h. Our reader and our
// writer could share a mistake; this one knows nothing of either.
#include <tiny_gltf.h>

#include <cstring>
#include <set>
#include <sstream>

#include "core/animal.h"
#include "core/carried_counts.h"
#include "core/gltf_out.h"
#include "gltf_maker.h"
#include "gltf_samples.h"
#include "gtest/gtest.h"
#include "painted.h"
#include "reading.h"

namespace pelage {
namespace {

using namespace test;

struct Sample {
    std::string name;
    Document document;
};

// One document of each kind of source; the fox only where the shared meshes are.
std::vector<Sample> samples() {
    std::vector<Sample> all;
    all.push_back({"animal", groomedAnimal(2000)});
    all.push_back({"crowded", painted(crowdedFile())});
    all.push_back({"skinned", painted(GltfMaker::skinned().glb())});
    all.push_back({"obj", paintedObj()});
    if (const std::string path = sharedMesh("Fox.glb"); !path.empty()) {
        all.push_back({"fox", openDocument(readSource(path))});
        paint(all.back().document);
    }
    return all;
}

// Keeps the bytes of a picture as they are: whether they can be decoded is not the question here.
bool keepPicture(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
    image->image.assign(bytes, bytes + size);
    return true;
}

bool writePicture(const std::string*, const std::string*, const tinygltf::Image* image, bool,
                  std::string* uri, void*) {
    *uri = "data:" + image->mimeType + ";base64," + base64(std::as_bytes(std::span(image->image)));
    return true;
}

tinygltf::Model readByTinyGltf(const std::vector<std::byte>& glb) {
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(keepPicture, nullptr);
    reader.SetStoreOriginalJSONForExtrasAndExtensions(true);
    tinygltf::Model model;
    std::string error, warning;
    EXPECT_TRUE(reader.LoadBinaryFromMemory(&model, &error, &warning,
                                            reinterpret_cast<const unsigned char*>(glb.data()),
                                            static_cast<unsigned>(glb.size())));
    EXPECT_EQ(error + warning, "");
    return model;
}

std::vector<std::byte> writtenByTinyGltf(const tinygltf::Model& model) {
    tinygltf::TinyGLTF writer;
    writer.SetImageWriter(writePicture, nullptr);
    std::ostringstream out;
    EXPECT_TRUE(writer.WriteGltfSceneToStream(&model, out, false, true));
    return test::bytesOf(out.str());
}

const tinygltf::Primitive& primitiveOf(const tinygltf::Model& model, const SourcePart& part) {
    return model.meshes.at(part.mesh).primitives.at(part.primitive);
}

// Floats of an attribute that is stored as such.
std::vector<float> floatsOf(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                            const std::string& attribute, int type) {
    const auto& accessor =
        model.accessors.at(static_cast<std::size_t>(primitive.attributes.at(attribute)));
    EXPECT_EQ(accessor.type, type) << attribute;
    EXPECT_EQ(accessor.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT) << attribute;
    const auto& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const auto& buffer = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
    const auto width = static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
    const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
    std::vector<float> values(accessor.count * width);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        const std::size_t at = view.byteOffset + accessor.byteOffset + i * stride;
        EXPECT_LE(at + width * sizeof(float), buffer.size()) << attribute;
        std::memcpy(&values[i * width], &buffer.at(at), width * sizeof(float));
    }
    return values;
}

bool sameBits(const std::vector<float>& values, const void* others, std::size_t count) {
    return values.size() == count && std::memcmp(values.data(), others, count * sizeof(float)) == 0;
}

TEST(TinyGltf, ReadsTheFurOfEveryVertexBitForBit) {
    for (const auto& [name, document] : samples()) {
        SCOPED_TRACE(name);
        const tinygltf::Model model = readByTinyGltf(groomedGlb(document));
        for (const SourcePart& part : document.skin->source->parts) {
            std::vector<float> length, density, direction;
            for (uint v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
                const FurVertex& fur = document.groom.fur[document.skin->weld[v]];
                length.push_back(fur.furLength);
                density.push_back(fur.density);
                for (int i = 0; i < 3; ++i) direction.push_back(fur.direction[i]);
            }
            const tinygltf::Primitive& primitive = primitiveOf(model, part);
            const auto same = [&](const char* attribute, int type, const auto& values) {
                return sameBits(floatsOf(model, primitive, attribute, type), values.data(),
                                values.size());
            };
            EXPECT_TRUE(same("_FUR_LENGTH", TINYGLTF_TYPE_SCALAR, length));
            EXPECT_TRUE(same("_FUR_DENSITY", TINYGLTF_TYPE_SCALAR, density));
            EXPECT_TRUE(same("_FUR_DIRECTION", TINYGLTF_TYPE_VEC3, direction));
        }
    }
}

TEST(TinyGltf, ReadsThePlacesOfTheSource) {
    for (const auto& [name, document] : samples()) {
        SCOPED_TRACE(name);
        const Source& source = *document.skin->source;
        const tinygltf::Model model = readByTinyGltf(groomedGlb(document));
        for (const SourcePart& part : source.parts) {
            const auto positions =
                floatsOf(model, primitiveOf(model, part), "POSITION", TINYGLTF_TYPE_VEC3);
            EXPECT_TRUE(sameBits(positions, &source.positions[part.firstVertex],
                                 std::size_t{part.vertexCount} * 3));
        }
    }
}

TEST(TinyGltf, FindsAllThatTheSourceCarried) {
    for (const auto& [name, document] : samples()) {
        SCOPED_TRACE(name);
        const Source& source = *document.skin->source;
        if (!source.carried) continue;
        const CarriedCounts counts = carriedCounts(source);
        const tinygltf::Model model = readByTinyGltf(groomedGlb(document));
        EXPECT_EQ(model.nodes.size(), counts.nodes);
        EXPECT_EQ(model.animations.size(), counts.animations);
        std::set<int> joints;
        for (const auto& skin : model.skins) joints.insert(skin.joints.begin(), skin.joints.end());
        EXPECT_EQ(joints.size(), counts.joints);
        std::size_t targets = 0;
        for (const auto& mesh : model.meshes)
            for (const auto& primitive : mesh.primitives)
                targets = std::max(targets, primitive.targets.size());
        EXPECT_EQ(targets, counts.morphTargets);
    }
}

TEST(TinyGltf, FindsMaterialsAndPictures) {
    for (const auto& [name, document] : samples()) {
        SCOPED_TRACE(name);
        const Source& source = *document.skin->source;
        const tinygltf::Model model = readByTinyGltf(groomedGlb(document));
        ASSERT_EQ(model.materials.size(), source.materials.size());
        ASSERT_EQ(model.images.size(), source.images.size());
        for (std::size_t i = 0; i < source.materials.size(); ++i) {
            const auto& color = model.materials[i].pbrMetallicRoughness.baseColorFactor;
            ASSERT_EQ(color.size(), 4u);
            for (int c = 0; c < 4; ++c)
                EXPECT_EQ(static_cast<float>(color[static_cast<std::size_t>(c)]),
                          source.materials[i].baseColor[c]);
        }
        for (const SourcePart& part : source.parts)
            EXPECT_EQ(primitiveOf(model, part).material, part.material);
        for (std::size_t i = 0; i < source.images.size(); ++i)
            EXPECT_EQ(std::memcmp(model.images[i].image.data(), source.images[i].bytes.data(),
                                  source.images[i].bytes.size()),
                      0);
    }
}

TEST(TinyGltf, FindsTheFurBlock) {
    for (const auto& [name, document] : samples()) {
        SCOPED_TRACE(name);
        const tinygltf::Model model = readByTinyGltf(groomedGlb(document));
        const auto block = nlohmann::json::parse(furToJson(document.fur));
        for (const auto& mesh : model.meshes) {
            auto found = nlohmann::json::parse(mesh.extras_json_string)["fur"];
            const bool told = !document.skin->source->carried;  // else the skeleton says it
            EXPECT_EQ(found["segments"].size(), told ? document.groom.body().size() : 0u);
            found.erase("segments");  // beside what furToJson writes
            EXPECT_EQ(found, block);
        }
    }
}

TEST(TinyGltf, WritesItAgainAndTheFurIsStillThere) {
    for (const auto& [name, document] : samples()) {
        SCOPED_TRACE(name);
        const auto again = writtenByTinyGltf(readByTinyGltf(groomedGlb(document)));
        expectSameFields(document, opened(again));
    }
}

}  // namespace
}  // namespace pelage
