// gltf_maker.h -- glTF files made by a test: JSON, and arrays put into one buffer.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf_bytes.h"
#include "reading.h"

namespace pelage::test {

// Builds a .glb or .gltf. `json` may be changed at will before it is taken out.
//     GltfMaker maker;
//     const int position = maker.add<float>({0,0,0, 1,0,0, 0,1,0}, "VEC3", 5126);
//     maker.mesh({{"attributes", {{"POSITION", position}}}});
//     Source source = readGltf(maker.glb(), "");
struct GltfMaker {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                           {"buffers", nlohmann::json::array()},
                           {"bufferViews", nlohmann::json::array()},
                           {"accessors", nlohmann::json::array()},
                           {"meshes", nlohmann::json::array()}};
    std::vector<std::byte> bin;

    // A view of these bytes on a 4-byte boundary; its number.
    template <typename T>
    int view(const std::vector<T>& values) {
        bin.resize((bin.size() + 3) / 4 * 4);
        const std::size_t size = values.size() * sizeof(T);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", size}});
        const auto bytes = test::bytesOf(values);
        bin.insert(bin.end(), bytes.begin(), bytes.end());
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }

    // An accessor of a view; its number. `more` is merged into it.
    int accessor(int view, std::size_t count, const char* type, int componentType,
                 const nlohmann::json& more = nlohmann::json::object()) {
        nlohmann::json entry = {{"count", count}, {"type", type}, {"componentType", componentType}};
        if (view >= 0) entry["bufferView"] = view;
        entry.update(more);
        json["accessors"].push_back(entry);
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    // View and accessor of packed values.
    template <typename T>
    int add(const std::vector<T>& values, const char* type, int componentType,
            const nlohmann::json& more = nlohmann::json::object()) {
        const std::string name = type;
        const std::size_t components = name == "SCALAR" ? 1
                                       : name == "MAT4"
                                           ? 16
                                           : static_cast<std::size_t>(name.back() - '0');
        return accessor(view(values), values.size() / components, type, componentType, more);
    }

    // A mesh of one primitive; its number. Not placed by any node.
    int mesh(const nlohmann::json& primitive) {
        json["meshes"].push_back({{"primitives", nlohmann::json::array({primitive})}});
        return static_cast<int>(json["meshes"].size()) - 1;
    }

    // One triangle in the plane z = 0, placed at the origin.
    static GltfMaker triangle() {
        GltfMaker maker;
        const int position = maker.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 5126);
        maker.mesh({{"attributes", {{"POSITION", position}}}});
        maker.json["nodes"] = {{{"mesh", 0}}};
        maker.json["scenes"] = {{{"nodes", {0}}}};
        return maker;
    }

    // A triangle held by two joints: vertex 0 by the first, vertex 1 by the second, vertex 2 by
    // both.
    static GltfMaker skinned() {
        GltfMaker maker = triangle();
        maker.primitive()["attributes"]["JOINTS_0"] =
            maker.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 5121);
        maker.primitive()["attributes"]["WEIGHTS_0"] =
            maker.add<float>({1, 0, 0, 0, 2, 0, 0, 0, 1, 3, 0, 0}, "VEC4", 5126);
        const int inverse = maker.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                              1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                                             "MAT4", 5126);
        maker.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
                               {{"name", "hip"}, {"children", {2, 3}}, {"translation", {0, 0, 5}}},
                               {{"name", "neck"}, {"children", {4}}, {"translation", {0, 1, 0}}},
                               {{"name", "tail"}, {"translation", {0, 0, -2}}},
                               {{"name", "Head"}, {"translation", {0, 1, 0}}}};
        maker.json["scenes"] = {{{"nodes", {0, 1}}}};
        maker.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
        return maker;
    }

    // The first primitive, which tests like to spoil.
    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::vector<std::byte> glb() const {
        nlohmann::json withBuffer = json;
        if (json["buffers"].empty() && !bin.empty())
            withBuffer["buffers"] = {{{"byteLength", bin.size()}}};
        if (withBuffer["buffers"].empty()) withBuffer.erase("buffers");
        return putTogether(withBuffer.dump(), bin);
    }

    // A .gltf whose buffer is a data URI.
    std::vector<std::byte> gltf() const {
        nlohmann::json withBuffer = json;
        withBuffer["buffers"] = {{{"byteLength", bin.size()}, {"uri", dataUri(bin)}}};
        return bytesOf(withBuffer.dump());
    }
};

}  // namespace pelage::test
