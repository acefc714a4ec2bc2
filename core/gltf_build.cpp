// gltf_build.cpp -- a glTF made from a source that was none (OBJ, PLY, the built-in animal).
#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "edge_cuts.h"
#include "gltf_carry.h"

namespace pelage {
namespace {

constexpr float kUnitTolerance = 5e-4f;  // validators accept normals that are off by this much

OrderedJson array(const float* values, int count) {
    OrderedJson list = OrderedJson::array();
    for (int i = 0; i < count; ++i) list.push_back(values[i]);
    return list;
}

// Area-weighted normal of each source vertex; zero where no triangle with an area uses it.
std::vector<vec3> faceNormals(const Source& source) {
    std::vector<vec3> sums(source.positions.size(), vec3(0.0f));
    for (const uvec3 t : source.triangles) {
        const vec3 a = source.positions[t.x];
        const vec3 n = glm::cross(source.positions[t.y] - a, source.positions[t.z] - a);
        for (int k = 0; k < 3; ++k) sums[t[k]] += n;
    }
    return sums;
}

// The source's normals with those that are not unit scaled, and those that cannot be, replaced.
std::vector<vec3> unitNormals(const Source& source) {
    std::vector<vec3> normals = source.normals;
    std::vector<vec3> faces;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        float length = glm::length(normals[v]);
        if (std::abs(length - 1.0f) <= kUnitTolerance) continue;
        if (!(length > 1e-20f && std::isfinite(length))) {
            if (faces.empty()) faces = faceNormals(source);
            normals[v] = faces[v];
            length = glm::length(normals[v]);
        }
        normals[v] = length > 1e-20f ? normals[v] / length : vec3(0.0f, 1.0f, 0.0f);
    }
    return normals;
}

std::vector<vec4> clampedColors(const Source& source) {
    std::vector<vec4> colors = source.colors;
    for (vec4& color : colors) color = glm::clamp(color, 0.0f, 1.0f);
    return colors;
}

// Pictures that glTF can name; returns the texture of each source image, -1 where it has none.
std::vector<int> addTextures(GlbDraft& draft, const Source& source) {
    std::vector<int> textures;
    for (const SourceImage& image : source.images) {
        const std::string type = pictureType(image.bytes);
        if (type != "image/png" && type != "image/jpeg") {
            textures.push_back(-1);
            continue;
        }
        const std::size_t view = appendView(draft, plainPicture(image.bytes), 0, "picture");
        OrderedJson entry;
        if (!image.name.empty()) entry["name"] = image.name;
        entry["bufferView"] = view;
        entry["mimeType"] = type;
        draft.json["images"].push_back(entry);
        draft.json["textures"].push_back({{"source", draft.json["images"].size() - 1}});
        textures.push_back(static_cast<int>(draft.json["textures"].size()) - 1);
    }
    return textures;
}

void addMaterials(GlbDraft& draft, const Source& source) {
    const std::vector<int> textures = addTextures(draft, source);
    for (const SourceMaterial& material : source.materials) {
        const vec4 color = glm::clamp(material.baseColor, 0.0f, 1.0f);
        OrderedJson surface{{"baseColorFactor", array(&color.x, 4)}};
        const int texture =
            material.image < 0 ? -1 : textures.at(static_cast<std::size_t>(material.image));
        if (texture >= 0) surface["baseColorTexture"] = {{"index", texture}};
        surface["metallicFactor"] = 0;
        OrderedJson entry;
        if (!material.name.empty()) entry["name"] = material.name;
        entry["pbrMetallicRoughness"] = surface;
        draft.json["materials"].push_back(entry);
    }
}

template <typename Vector>
std::size_t addAttribute(GlbDraft& draft, const std::vector<Vector>& all, const SourcePart& part,
                         const std::string& name) {
    const float* first = &all.at(part.firstVertex).x;
    constexpr int kWidth = Vector::length();
    return appendFloats(draft, {first, std::size_t{part.vertexCount} * kWidth}, kWidth, name);
}

// The arrays of a source in the form in which they are written.
struct Arrays {
    std::vector<vec3> normals;
    std::vector<vec4> colors;
};

OrderedJson primitive(GlbDraft& draft, const Source& source, const Arrays& arrays,
                      const SourcePart& part) {
    OrderedJson attributes;
    attributes["POSITION"] = addAttribute(draft, source.positions, part, "position");
    if (!arrays.normals.empty())
        attributes["NORMAL"] = addAttribute(draft, arrays.normals, part, "normal");
    if (!source.uvs.empty())
        attributes["TEXCOORD_0"] = addAttribute(draft, source.uvs, part, "texture coordinate");
    if (!arrays.colors.empty())
        attributes["COLOR_0"] = addAttribute(draft, arrays.colors, part, "color");
    const std::vector<uvec3> triangles = trianglesOf(source, part);
    OrderedJson entry{{"attributes", attributes},
                      {"indices", appendIndices(draft, {&triangles.front().x, triangles.size() * 3},
                                                "triangles")}};
    if (part.material >= 0) entry["material"] = part.material;
    return entry;
}

}  // namespace

GlbDraft builtDraft(const Source& source) {
    assert(!source.parts.empty() && source.vertexToWorld.empty());
    GlbDraft draft;
    draft.json["asset"] = {{"version", "2.0"}, {"generator", "Pelage"}};
    draft.json["scene"] = 0;
    addMaterials(draft, source);

    const Arrays arrays{unitNormals(source), clampedColors(source)};
    std::map<uint, OrderedJson> meshes;
    std::map<uint, mat4> places;
    for (const SourcePart& part : source.parts) {
        assert(part.triangleCount > 0 && part.vertexCount > 0);
        OrderedJson& mesh = meshes[part.mesh];
        if (mesh.is_null() && !part.name.empty()) mesh["name"] = part.name;
        assert(mesh["primitives"].size() == part.primitive);
        mesh["primitives"].push_back(primitive(draft, source, arrays, part));
        places[part.mesh] = part.toWorld;
    }
    for (auto& [number, mesh] : meshes) {
        assert(draft.json["meshes"].size() == number);
        OrderedJson node{{"mesh", number}};
        if (mesh.contains("name")) node["name"] = mesh["name"];
        if (places[number] != mat4(1.0f)) node["matrix"] = array(&places[number][0].x, 16);
        draft.json["meshes"].push_back(mesh);
        draft.json["nodes"].push_back(node);
        draft.json["scenes"][0]["nodes"].push_back(number);
    }
    return draft;
}

}  // namespace pelage
