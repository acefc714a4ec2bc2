// gltf_subdivide.cpp -- reads every array of the parts, carries it over, and writes it in place.
#include "gltf_subdivide.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "glb_uses.h"
#include "gltf_accessor.h"
#include "gltf_carry.h"
#include "loop_places.h"
#include "mixed_weights.h"
#include "split_normals.h"
#include "text.h"

namespace pelage {
namespace {

// What goes on while parts are written.
struct Writing {
    const Source& source;
    GltfFile& file;  // the same as the draft before any change
    GlbDraft& draft;
    AccessorReplacer& replacer;
};

JsonPlace primitiveOf(const Writing& to, const SourcePart& part) {
    return to.file.primitive(part.mesh, part.primitive);
}

OrderedJson& draftOf(Writing& to, const SourcePart& part) {
    return to.draft.json.at("meshes").at(part.mesh).at("primitives").at(part.primitive);
}

// Values of a vertex attribute, in the first `width` components.
struct Values {
    std::size_t width = 0;
    std::vector<vec4> of;
};

Values valuesOf(GltfFile& file, const JsonPlace& attributes, const std::string& name) {
    const std::size_t accessor = *attributes.reference(name.c_str());
    const std::size_t width = accessorShape(file, accessor).components;
    if (width > 4) attributes.refuse(inQuotes(name) + " is a matrix and cannot be subdivided");
    const std::vector<float> flat = accessorFloats(file, accessor, width);
    Values values{width, std::vector<vec4>(flat.size() / width, vec4(0.0f))};
    for (std::size_t i = 0; i < flat.size(); ++i)
        values.of[i / width][static_cast<int>(i % width)] = std::isfinite(flat[i]) ? flat[i] : 0.0f;
    return values;
}

std::vector<vec3> threesOf(GltfFile& file, const JsonPlace& attributes, const std::string& name) {
    const Values values = valuesOf(file, attributes, name);
    return {values.of.begin(), values.of.end()};
}

// True for numbers of things, between which there is nothing.
bool namesThings(const GltfFile& file, const JsonPlace& attributes, const std::string& name) {
    if (!name.starts_with('_')) return false;
    const JsonPlace accessor = file.element("accessors", *attributes.reference(name.c_str()));
    return accessor.json().at("componentType") != kGlFloat && !accessor.boolean("normalized");
}

// Appends the values and puts them where `old` was.
std::size_t put(Writing& to, std::size_t old, const Values& values) {
    std::vector<float> flat;
    flat.reserve(values.of.size() * values.width);
    for (const vec4& value : values.of) flat.insert(flat.end(), &value.x, &value.x + values.width);
    appendFloats(to.draft, flat, static_cast<int>(values.width), "subdivided");
    return to.replacer.replace(old);
}

std::size_t put(Writing& to, std::size_t old, const std::vector<vec3>& values) {
    appendFloats(to.draft, {&values.front().x, values.size() * 3}, 3, "subdivided");
    return to.replacer.replace(old);
}

// Carries one attribute of the primitive or of a morph target over.
std::size_t putMean(Writing& to, const JsonPlace& attributes, const std::string& name,
                    const PartCuts& cuts) {
    Values values = valuesOf(to.file, attributes, name);
    const bool first = namesThings(to.file, attributes, name);
    carryOver(values.of, cuts, [&](vec4 a, vec4 b) { return first ? a : 0.5f * (a + b); });
    return put(to, *attributes.reference(name.c_str()), values);
}

// --- skins

std::string setName(const char* name, std::size_t set) { return name + std::to_string(set); }

bool isOfSets(const std::string& name, std::size_t sets) {
    for (std::size_t set = 0; set < sets; ++set)
        if (name == setName("JOINTS_", set) || name == setName("WEIGHTS_", set)) return true;
    return false;
}

std::vector<Influences> influencesOf(Writing& to, const JsonPlace& attributes, std::size_t sets) {
    std::vector<Influences> all;
    for (std::size_t set = 0; set < sets; ++set) {
        const auto joints =
            accessorIntegers(to.file, *attributes.reference(setName("JOINTS_", set).c_str()), 4);
        const auto weights =
            accessorFloats(to.file, *attributes.reference(setName("WEIGHTS_", set).c_str()), 4);
        all.resize(joints.size() / 4);
        for (std::size_t i = 0; i < joints.size(); ++i)
            all[i / 4].push_back({joints[i], std::isfinite(weights[i]) ? weights[i] : 0.0f});
    }
    for (Influences& of : all) of = normalised(std::move(of));
    return all;
}

// JOINTS_n and WEIGHTS_n of all sets that have both; returns how many.
std::size_t putInfluences(Writing& to, const SourcePart& part, const PartCuts& cuts) {
    const JsonPlace attributes = primitiveOf(to, part).at("attributes");
    std::size_t sets = 0;
    while (attributes.has(setName("JOINTS_", sets).c_str()) &&
           attributes.has(setName("WEIGHTS_", sets).c_str()))
        ++sets;
    if (sets == 0) return 0;
    const std::size_t most = 4 * sets;
    std::vector<Influences> all = influencesOf(to, attributes, sets);
    carryOver(all, cuts,
              [&](const Influences& a, const Influences& b) { return halfway(a, b, most); });
    for (std::size_t set = 0; set < sets; ++set) {
        std::vector<std::uint16_t> joints;
        Values weights{4, std::vector<vec4>(all.size(), vec4(0.0f))};
        for (std::size_t v = 0; v < all.size(); ++v)
            for (std::size_t k = 4 * set; k < 4 * set + 4; ++k) {
                const Influence of = k < all[v].size() ? all[v][k] : Influence{};
                joints.push_back(static_cast<std::uint16_t>(of.joint));
                weights.of[v][static_cast<int>(k % 4)] = of.weight;
            }
        OrderedJson& now = draftOf(to, part)["attributes"];
        const std::string jointsName = setName("JOINTS_", set);
        appendJoints(to.draft, joints);
        now[jointsName] = to.replacer.replace(*attributes.reference(jointsName.c_str()));
        const std::string weightsName = setName("WEIGHTS_", set);
        now[weightsName] = put(to, *attributes.reference(weightsName.c_str()), weights);
    }
    return sets;
}

// --- positions and normals, which go by the shape

std::size_t targetCount(const JsonPlace& primitive) {
    const auto targets = primitive.array("targets");
    return targets ? targets->size() : 0;
}

LoopPart readShape(Writing& to, const SourcePart& part, const PartCuts& cuts, std::size_t targets) {
    LoopPart shape;
    shape.cuts = &cuts;
    shape.triangles = trianglesOf(to.source, part);
    const JsonPlace primitive = primitiveOf(to, part);
    shape.values.push_back(threesOf(to.file, primitive.at("attributes"), "POSITION"));
    for (std::size_t t = 0; t < targets; ++t) {
        const bool moves =
            t < targetCount(primitive) && primitive.at("targets").at(t).has("POSITION");
        shape.values.push_back(moves ? threesOf(to.file, primitive.at("targets").at(t), "POSITION")
                                     : std::vector<vec3>(part.vertexCount, vec3(0.0f)));
    }
    return shape;
}

// Normals of the parts of one mesh; empty for those that have none.
std::vector<std::vector<vec3>> renewedNormals(Writing& to, std::span<const SourcePart* const> parts,
                                              std::span<const LoopPart> shapes) {
    std::vector<vec3> positions, normals;
    std::vector<uint> place;
    std::vector<uvec3> triangles;
    const auto hasNormals = [&](std::size_t p) {
        return primitiveOf(to, *parts[p]).at("attributes").has("NORMAL");
    };
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (!hasNormals(p)) continue;
        auto own = threesOf(to.file, primitiveOf(to, *parts[p]).at("attributes"), "NORMAL");
        const LoopPart& shape = shapes[p];
        carryOver(own, *shape.cuts, [](vec3 a, vec3 b) { return 0.5f * (a + b); });
        const auto first = static_cast<uint>(positions.size());
        for (const uvec3 t : shape.cuts->back().triangles) triangles.push_back(t + first);
        positions.insert(positions.end(), shape.values[0].begin(), shape.values[0].end());
        place.insert(place.end(), shape.place.begin(), shape.place.end());
        normals.insert(normals.end(), own.begin(), own.end());
    }
    renewNormals(positions, place, triangles, normals);
    std::vector<std::vector<vec3>> out(parts.size());
    auto next = normals.begin();
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (!hasNormals(p)) continue;
        const auto end = next + static_cast<std::ptrdiff_t>(shapes[p].place.size());
        out[p].assign(next, end);
        next = end;
    }
    return out;
}

// Means of tangents, laid at a right angle to the normals; the side is the first end's.
std::size_t putTangents(Writing& to, const SourcePart& part, const PartCuts& cuts,
                        const std::vector<vec3>& normals) {
    const JsonPlace attributes = primitiveOf(to, part).at("attributes");
    Values tangents = valuesOf(to.file, attributes, "TANGENT");
    carryOver(tangents.of, cuts, [](vec4 a, vec4 b) { return vec4(0.5f * vec3(a + b), a.w); });
    for (std::size_t v = 0; v < tangents.of.size(); ++v) {
        const vec3 n = normals.empty() ? vec3(0.0f, 1.0f, 0.0f) : normals[v];
        const vec3 any = glm::cross(n, std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0));
        vec3 along = vec3(tangents.of[v]) - glm::dot(vec3(tangents.of[v]), n) * n;
        if (!(glm::length(along) > 1e-6f)) along = any;
        tangents.of[v] = vec4(glm::normalize(along), tangents.of[v].w < 0.0f ? -1.0f : 1.0f);
    }
    return put(to, *attributes.reference("TANGENT"), tangents);
}

// --- the primitive

void putTargets(Writing& to, const SourcePart& part, const LoopPart& shape) {
    const JsonPlace primitive = primitiveOf(to, part);
    for (std::size_t t = 0; t < targetCount(primitive); ++t) {
        const JsonPlace target = primitive.at("targets").at(t);
        for (const auto& [name, accessor] : target.json().items()) {
            const std::size_t now = name == "POSITION"
                                        ? put(to, accessor.get<std::size_t>(), shape.values[t + 1])
                                        : putMean(to, target, name, *shape.cuts);
            draftOf(to, part)["targets"][t][name] = now;
        }
    }
}

void putTriangles(Writing& to, const SourcePart& part, const PartCuts& cuts) {
    const std::vector<uvec3>& triangles = cuts.back().triangles;
    std::size_t now =
        appendIndices(to.draft, {&triangles.front().x, triangles.size() * 3}, "triangles");
    if (const auto old = primitiveOf(to, part).reference("indices"))
        now = to.replacer.replace(*old);
    OrderedJson& primitive = draftOf(to, part);
    primitive["indices"] = now;
    primitive.erase("mode");
    // A compressed copy of what was there before.
    if (primitive.contains("extensions"))
        primitive["extensions"].erase("KHR_draco_mesh_compression");
    if (primitive.contains("extensions") && primitive["extensions"].empty())
        primitive.erase("extensions");
}

void putPart(Writing& to, const SourcePart& part, const LoopPart& shape,
             const std::vector<vec3>& normals) {
    const JsonPlace attributes = primitiveOf(to, part).at("attributes");
    const std::size_t sets = putInfluences(to, part, *shape.cuts);
    for (const auto& [name, accessor] : attributes.json().items()) {
        const auto old = accessor.get<std::size_t>();
        std::optional<std::size_t> now;
        if (name == "POSITION") {
            now = put(to, old, shape.values[0]);
        } else if (name == "NORMAL") {
            now = put(to, old, normals);
        } else if (name == "TANGENT") {
            now = putTangents(to, part, *shape.cuts, normals);
        } else if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) {
            if (!isOfSets(name, sets))
                attributes.refuse(inQuotes(name) + " has no other half: joints need weights");
        } else {
            now = putMean(to, attributes, name, *shape.cuts);
        }
        if (now) draftOf(to, part)["attributes"][name] = *now;
    }
    putTargets(to, part, shape);
    putTriangles(to, part, *shape.cuts);
}

}  // namespace

std::vector<std::byte> subdividedGlb(const Source& source, std::span<const PartCuts> cuts,
                                     Progress* progress) {
    GlbDraft draft = bareDraft(source);
    GltfFile file = openGltf(packGlb(draft), source.path);
    AccessorReplacer replacer(draft);
    Writing to{source, file, draft, replacer};
    std::map<uint, std::vector<const SourcePart*>> meshes;
    for (const SourcePart& part : source.parts)
        if (part.triangleCount > 0) meshes[part.mesh].push_back(&part);
    std::size_t done = 0;
    for (const auto& [mesh, parts] : meshes) {
        std::size_t targets = 0;
        for (const SourcePart* part : parts)
            targets = std::max(targets, targetCount(primitiveOf(to, *part)));
        std::vector<LoopPart> shapes;
        for (const SourcePart* part : parts) {
            const auto number = static_cast<std::size_t>(part - source.parts.data());
            shapes.push_back(readShape(to, *part, cuts[number], targets));
        }
        loopParts(shapes, progress);
        const auto normals = renewedNormals(to, parts, shapes);
        for (std::size_t p = 0; p < parts.size(); ++p)
            putPart(to, *parts[p], shapes[p], normals[p]);
        if (progress)
            progress->report(static_cast<float>(++done) / static_cast<float>(meshes.size()));
    }
    dropUnusedBytes(draft);
    return packGlb(std::move(draft));
}

}  // namespace pelage
