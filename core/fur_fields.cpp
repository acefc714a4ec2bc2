// fur_fields.cpp -- puts fields and the fur block on the primitives, meshes and nodes of a draft.
#include "fur_fields.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "fur_names.h"

namespace pelage {
namespace {

OrderedJson& primitiveOf(OrderedJson& gltf, const SourcePart& part) {
    return gltf.at("meshes").at(part.mesh).at("primitives").at(part.primitive);
}

bool canHold(const OrderedJson& owner) {
    const auto extras = owner.find("extras");
    if (extras == owner.end()) return true;
    if (!extras->is_object()) return false;
    const auto fur = extras->find("fur");
    return fur == extras->end() || fur->is_object();
}

bool putBlock(OrderedJson& owner, const OrderedJson& block) {
    if (!canHold(owner)) return false;
    owner["extras"]["fur"] = block;
    return true;
}

// Two fields interleaved as the two components of a texture coordinate.
std::vector<float> pairs(const float* first, std::size_t firstStride, const float* second,
                         std::size_t secondStride, std::size_t count) {
    std::vector<float> out;
    out.reserve(count * 2);
    for (std::size_t i = 0; i < count; ++i) {
        out.push_back(first[i * firstStride]);
        out.push_back(second ? second[i * secondStride] : 0.0f);
    }
    return out;
}

std::string texcoord(int set) { return "TEXCOORD_" + std::to_string(set); }

}  // namespace

const FieldWriter::Written& FieldWriter::written(const SourcePart& part, std::size_t positions,
                                                 FieldValues values, bool mirrored) {
    for (const Written& old : written_)
        if (old.mesh == part.mesh && old.positions == positions && old.values == values) return old;
    Written now{part.mesh, positions, std::move(values), 0, 0, 0, 0, 0, {}};
    const std::size_t count = now.values.length.size();
    now.length = appendFloats(draft_, now.values.length, 1, kLengthName);
    now.density = appendFloats(draft_, now.values.density, 1, kDensityName);
    now.direction = appendFloats(draft_, now.values.direction, 3, kDirectionName);
    if (!now.values.tint.empty()) now.tint = appendFloats(draft_, now.values.tint, 3, kTintName);
    if (!now.values.segment.empty())
        now.segment = appendFloats(draft_, now.values.segment, 1, kSegmentName);
    if (mirrored) {
        const float* direction = now.values.direction.data();
        now.mirror[0] = appendFloats(
            draft_, pairs(now.values.length.data(), 1, now.values.density.data(), 1, count), 2,
            kMirrorNames[0]);
        now.mirror[1] =
            appendFloats(draft_, pairs(direction, 3, direction + 1, 3, count), 2, kMirrorNames[1]);
        now.mirror[2] =
            appendFloats(draft_, pairs(direction + 2, 3, nullptr, 0, count), 2, kMirrorNames[2]);
    }
    written_.push_back(std::move(now));
    return written_.back();
}

std::size_t FieldWriter::zeros(std::size_t count) {
    for (const auto& [size, accessor] : zeros_)
        if (size == count) return accessor;
    const std::vector<float> values(count * 2, 0.0f);
    zeros_.emplace_back(count, appendFloats(draft_, values, 2, kZeroName));
    return zeros_.back().second;
}

void FieldWriter::write(const SourcePart& part, FieldValues values, int firstSet) {
    const OrderedJson& before = primitiveOf(draft_.json, part).at("attributes");
    const auto positions = before.at("POSITION").get<std::size_t>();
    const auto count = draft_.json.at("accessors").at(positions).at("count").get<std::size_t>();
    if (values.length.size() != count)
        throw std::runtime_error("export: mesh " + std::to_string(part.mesh) + ", primitive " +
                                 std::to_string(part.primitive) + " has " + std::to_string(count) +
                                 " vertices, its fur " + std::to_string(values.length.size()));
    const Written& fields = written(part, positions, std::move(values), firstSet >= 0);
    // From here on nothing adds a section to the file, so these stay where they are.
    OrderedJson& attributes = primitiveOf(draft_.json, part)["attributes"];
    attributes["_FUR_LENGTH"] = fields.length;
    attributes["_FUR_DENSITY"] = fields.density;
    attributes["_FUR_DIRECTION"] = fields.direction;
    if (!fields.values.tint.empty()) attributes["_FUR_TINT"] = fields.tint;
    if (!fields.values.segment.empty()) attributes["_FUR_SEGMENT"] = fields.segment;
    // Set numbers have no gaps (glTF 2.0, section 3.7.2.1): the missing ones are zero.
    for (int set = 0; set < firstSet; ++set) {
        if (attributes.contains(texcoord(set))) continue;
        const std::size_t accessor = zeros(count);
        attributes[texcoord(set)] = accessor;
    }
    for (int k = 0; firstSet >= 0 && k < 3; ++k)
        attributes[texcoord(firstSet + k)] = fields.mirror[k];
}

int firstMirrorSet(const GlbDraft& draft, const std::vector<SourcePart>& parts) {
    int first = 2;
    for (const SourcePart& part : parts) {
        const OrderedJson& attributes = draft.json.at("meshes")
                                            .at(part.mesh)
                                            .at("primitives")
                                            .at(part.primitive)
                                            .at("attributes");
        int inUse = 0;
        while (attributes.contains(texcoord(inUse))) ++inUse;
        first = std::max(first, inUse);
    }
    return first;
}

void writeBlock(OrderedJson& gltf, const std::vector<SourcePart>& parts, const OrderedJson& block) {
    std::set<uint> meshes;
    for (const SourcePart& part : parts) meshes.insert(part.mesh);
    bool placed = false;
    for (const uint mesh : meshes) placed = putBlock(gltf.at("meshes").at(mesh), block) || placed;
    if (gltf.contains("nodes"))
        for (OrderedJson& node : gltf["nodes"])
            if (node.contains("mesh") && meshes.contains(node["mesh"].get<uint>()))
                placed = putBlock(node, block) || placed;
    if (!placed && !putBlock(gltf.at("asset"), block))
        throw std::runtime_error(
            "export: no place for the fur: extras of meshes, nodes and asset are no objects");
}

}  // namespace pelage
