// gltf_in.cpp -- turns the meshes of a glTF into one source.
#include "gltf_in.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gltf_accessor.h"
#include "gltf_fur.h"
#include "gltf_material.h"
#include "gltf_nodes.h"
#include "gltf_rig.h"
#include "gltf_skin.h"
#include "segment_parts.h"
#include "source_check.h"

namespace pelage {
namespace {

enum Mode : std::size_t { kTriangles = 4, kStrip = 5, kFan = 6 };

// The source being made, and what its parts need.
struct Reading {
    GltfFile& file;
    Source& source;
    const Nodes& nodes;
    SkinReader& skins;
    const std::vector<BaseColorUvs>& uvsOf;  // by material
};

// Values of an attribute of the part, `components` per vertex; empty when it has none.
std::vector<float> attribute(GltfFile& file, const SourcePart& part, const JsonPlace& attributes,
                             const std::string& name, std::size_t components) {
    const auto accessor = attributes.reference(name.c_str());
    if (!accessor) return {};
    const std::size_t count = accessorShape(file, *accessor).count;
    if (count != part.vertexCount) {
        attributes.refuse(name + " has " + std::to_string(count) + " values for " +
                          std::to_string(part.vertexCount) + " vertices");
    }
    return accessorFloats(file, *accessor, components);
}

// Appends the values as vectors, after zeros for earlier parts that had none.
template <typename Vector>
void append(std::vector<Vector>& all, const SourcePart& part, const std::vector<float>& values,
            Vector missing) {
    if (values.empty()) return;
    constexpr auto kWidth = static_cast<std::size_t>(Vector::length());
    all.resize(part.firstVertex, missing);
    for (std::size_t v = 0; v < part.vertexCount; ++v) {
        Vector value;
        for (std::size_t c = 0; c < kWidth; ++c) {
            value[static_cast<int>(c)] = values[v * kWidth + c];
        }
        all.push_back(value);
    }
}

// Adds weight * offset of every target that weighs something.
void morph(Reading& to, const SourcePart& part, const JsonPlace& primitive, const char* name,
           const std::vector<float>& weights, std::vector<float>& values) {
    const auto targets = primitive.array("targets");
    if (!targets || values.empty()) return;
    for (std::size_t t = 0; t < weights.size(); ++t) {
        if (weights[t] == 0.0f) continue;
        const auto offsets = attribute(to.file, part, targets->at(t), name, 3);
        for (std::size_t i = 0; i < offsets.size(); ++i) values[i] += weights[t] * offsets[i];
    }
}

void readColors(Reading& to, const SourcePart& part, const JsonPlace& attributes) {
    const auto accessor = attributes.reference("COLOR_0");
    if (!accessor) return;
    const std::size_t components = accessorShape(to.file, *accessor).components;
    auto values = attribute(to.file, part, attributes, "COLOR_0", components == 4 ? 4 : 3);
    if (components == 3) {
        std::vector<float> withAlpha;
        withAlpha.reserve(values.size() / 3 * 4);
        for (std::size_t i = 0; i < values.size(); ++i) {
            withAlpha.push_back(values[i]);
            if (i % 3 == 2) withAlpha.push_back(1.0f);
        }
        values = std::move(withAlpha);
    }
    // The specification clamps; NaN is taken for black.
    for (float& value : values) value = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
    append(to.source.colors, part, values, vec4(1.0f));
}

void readUvs(Reading& to, const SourcePart& part, const JsonPlace& attributes) {
    const BaseColorUvs uvs =
        part.material < 0 ? BaseColorUvs{} : to.uvsOf[static_cast<std::size_t>(part.material)];
    auto values = attribute(to.file, part, attributes, "TEXCOORD_" + std::to_string(uvs.set), 2);
    for (std::size_t i = 0; uvs.moved && i + 1 < values.size(); i += 2) {
        const vec3 moved = uvs.matrix * vec3(values[i], values[i + 1], 1.0f);
        values[i] = moved.x;
        values[i + 1] = moved.y;
    }
    for (float& value : values) {
        if (!std::isfinite(value)) value = 0.0f;
    }
    append(to.source.uvs, part, values, vec2(0.0f));
}

void readVertices(Reading& to, const SourcePart& part, const JsonPlace& mesh,
                  const JsonPlace& primitive, std::size_t node) {
    const JsonPlace attributes = primitive.at("attributes");
    const auto targets = primitive.array("targets");
    const auto weights =
        targets ? morphWeights(to.file, mesh, node, targets->size()) : std::vector<float>();

    auto positions = attribute(to.file, part, attributes, "POSITION", 3);
    morph(to, part, primitive, "POSITION", weights, positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i])) {
            attributes.refuse("POSITION of vertex " + std::to_string(i / 3) + " is not finite");
        }
    }
    append(to.source.positions, part, positions, vec3(0.0f));

    auto normals = attribute(to.file, part, attributes, "NORMAL", 3);
    morph(to, part, primitive, "NORMAL", weights, normals);
    for (float& value : normals) {
        if (!std::isfinite(value)) value = 0.0f;
    }
    append(to.source.normals, part, normals, vec3(0.0f));
    readUvs(to, part, attributes);
    readColors(to, part, attributes);
}

// Corners in the order in which the primitive names them.
std::vector<uint> corners(Reading& to, const SourcePart& part, const JsonPlace& primitive) {
    std::vector<uint> out;
    if (const auto accessor = primitive.reference("indices")) {
        out = accessorIntegers(to.file, *accessor, 1);
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (out[i] >= part.vertexCount) {
                primitive.refuse("index " + std::to_string(i) + " names vertex " +
                                 std::to_string(out[i]) + " of " +
                                 std::to_string(part.vertexCount));
            }
        }
    } else {
        out.resize(part.vertexCount);
        for (uint v = 0; v < part.vertexCount; ++v) out[v] = v;
    }
    return out;
}

// Unrolls triangles, strips and fans, all wound as glTF 2.0, section 3.7.2.1, says.
void readTriangles(Reading& to, SourcePart& part, const JsonPlace& primitive, std::size_t mode) {
    const std::vector<uint> corner = corners(to, part, primitive);
    const std::size_t step = mode == kTriangles ? 3 : 1;
    if (mode == kTriangles && corner.size() % 3 != 0) {
        to.file.warnings.add(primitive.text() + ": has " + std::to_string(corner.size()) +
                             " corners; the last " + std::to_string(corner.size() % 3) +
                             " make no triangle");
    }
    const std::size_t before = to.source.triangles.size();
    for (std::size_t i = 0; i + 2 < corner.size(); i += step) {
        uvec3 t(corner[i], corner[i + 1], corner[i + 2]);
        if (mode == kStrip && i % 2 == 1) t = uvec3(corner[i], corner[i + 2], corner[i + 1]);
        if (mode == kFan) t = uvec3(corner[i + 1], corner[i + 2], corner[0]);
        to.source.triangles.push_back(t + part.firstVertex);
    }
    if (to.source.triangles.size() > to.file.elementLimit()) {
        primitive.refuse("takes the triangles to " + std::to_string(to.source.triangles.size()) +
                         ", too many for a file of this size");
    }
    part.triangleCount = static_cast<uint>(to.source.triangles.size() - before);
}

void placePart(Reading& to, SourcePart& part, const JsonPlace& primitive, std::size_t node) {
    const bool skinned = to.skins.isSkinned(primitive, node);
    if (node != kNoNode) part.toWorld = to.nodes.toWorld[node];
    if (!skinned && to.source.vertexToWorld.empty()) return;

    // From the first skinned part on, every vertex has its matrix.
    if (to.source.vertexToWorld.empty()) {
        for (const SourcePart& earlier : to.source.parts) {
            to.source.vertexToWorld.resize(earlier.firstVertex + earlier.vertexCount,
                                           earlier.toWorld);
        }
        to.source.segmentOf.assign(part.firstVertex, kNoSegment);
    }
    to.source.vertexToWorld.resize(part.firstVertex + part.vertexCount, part.toWorld);
    to.source.segmentOf.resize(part.firstVertex + part.vertexCount, kNoSegment);
    if (!skinned) return;
    to.skins.bind(to.source, part, primitive, node);
    part.toWorld = to.source.vertexToWorld[part.firstVertex];
}

void checkCompression(const JsonPlace& primitive, const GltfFile& file, std::size_t position) {
    const auto extensions = primitive.object("extensions");
    if (extensions && extensions->has("KHR_draco_mesh_compression") &&
        !file.element("accessors", position).has("bufferView")) {
        primitive.refuse(
            "has its vertices only through \"KHR_draco_mesh_compression\", which is not supported");
    }
}

void readPrimitive(Reading& to, std::size_t m, std::size_t p) {
    const JsonPlace mesh = to.file.element("meshes", m);
    const JsonPlace primitive = mesh.at("primitives").at(p);
    const std::size_t mode = primitive.integerOr("mode", kTriangles, 6);
    const auto position = primitive.at("attributes").reference("POSITION");
    if (!position) {
        to.file.warnings.add(primitive.text() + ": has no POSITION, so it holds no surface");
        return;
    }
    checkCompression(primitive, to.file, *position);
    const std::size_t count = accessorShape(to.file, *position).count;
    to.source.fileVertices += count;
    if (mode < kTriangles) {
        to.file.warnings.add(
            primitive.text() +
            ": is made of points or lines, which hold no fur; it is carried along");
        return;
    }
    if (to.source.positions.size() + count > to.file.elementLimit()) {
        primitive.refuse("takes the vertices to " +
                         std::to_string(to.source.positions.size() + count) +
                         ", too many for a file of this size");
    }

    SourcePart part;
    part.name = mesh.string("name");
    part.mesh = static_cast<uint>(m);
    part.primitive = static_cast<uint>(p);
    part.firstVertex = static_cast<uint>(to.source.positions.size());
    part.vertexCount = static_cast<uint>(count);
    part.firstTriangle = static_cast<uint>(to.source.triangles.size());
    if (const auto material = primitive.reference("material"))
        part.material = static_cast<int>(*material);
    const std::size_t node = to.nodes.placeOf[m];
    readTriangles(to, part, primitive, mode);
    readVertices(to, part, mesh, primitive, node);
    placePart(to, part, primitive, node);
    readFurFields(to.file, to.source, part, primitive);
    to.source.parts.push_back(std::move(part));
}

// Of each mesh: the name of the node that shows it, else its own.
std::vector<std::string> placeNames(const GltfFile& file, const Nodes& nodes) {
    std::vector<std::string> names;
    for (std::size_t m = 0; m < nodes.placeOf.size(); ++m) {
        const std::size_t node = nodes.placeOf[m];
        names.push_back(node == kNoNode ? "" : file.element("nodes", node).string("name"));
        if (names.back().empty()) names.back() = file.element("meshes", m).string("name");
    }
    return names;
}

}  // namespace

Source readGltf(std::span<const std::byte> bytes, const std::string& path, Progress* progress) {
    GltfFile file = openGltf(bytes, path);
    if (progress) progress->report(0.2f);
    Source source;
    source.path = path;
    const std::vector<BaseColorUvs> uvsOf = readMaterials(file, source);
    const Nodes nodes = readNodes(file);
    Rig rig;
    SkinReader skins(file, nodes, rig);
    Reading reading{file, source, nodes, skins, uvsOf};
    const std::size_t meshes = file.count("meshes");
    for (std::size_t m = 0; m < meshes; ++m) {
        const JsonPlace primitives = file.element("meshes", m).at("primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            readPrimitive(reading, m, p);
            if (progress)
                progress->report(0.2f + 0.7f * static_cast<float>(m) / static_cast<float>(meshes));
        }
    }
    if (readFurSegments(file, source)) {
        source.segmentsKept = true;
    } else if (!source.vertexToWorld.empty()) {
        skins.nameSegments(source);
    } else {
        segmentsFromParts(source, placeNames(file, nodes));
    }
    warnMissingFields(file, source);
    source.furBlock = furBlock(file);
    source.rig = completeRig(file, source, nodes, std::move(rig));
    source.carried = file.carried;
    source.warnings = file.warnings.take();
    finishSource(source, file.name);
    if (progress) progress->report(1.0f);
    return source;
}

}  // namespace pelage
