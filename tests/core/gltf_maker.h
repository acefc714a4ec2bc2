// gltf_maker.h -- glTF files made by a test: JSON, and arrays put into one buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

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
        const auto* first = reinterpret_cast<const std::byte*>(values.data());
        bin.insert(bin.end(), first, first + size);
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

    // The first primitive, which tests like to spoil.
    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::vector<std::byte> glb() const {
        nlohmann::json withBuffer = json;
        std::vector<std::byte> content = bin;
        content.resize((content.size() + 3) / 4 * 4);
        if (json["buffers"].empty() && !content.empty())
            withBuffer["buffers"] = {{{"byteLength", bin.size()}}};
        if (withBuffer["buffers"].empty()) withBuffer.erase("buffers");
        return container(withBuffer.dump(), content);
    }

    // A .gltf whose buffer is a data URI.
    std::vector<std::byte> gltf() const {
        nlohmann::json withBuffer = json;
        withBuffer["buffers"] = {{{"byteLength", bin.size()},
                                  {"uri", "data:application/octet-stream;base64," + base64(bin)}}};
        return bytesOf(withBuffer.dump());
    }

    static std::vector<std::byte> bytesOf(const std::string& text) {
        const auto* first = reinterpret_cast<const std::byte*>(text.data());
        return {first, first + text.size()};
    }

    // A .glb of any text and binary chunk (none when empty).
    static std::vector<std::byte> container(std::string text, std::vector<std::byte> content) {
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::vector<std::byte> out;
        const auto word = [&](std::uint32_t value) {
            for (int i = 0; i < 4; ++i)
                out.push_back(static_cast<std::byte>(value >> (8 * i) & 0xff));
        };
        const std::size_t size = 20 + text.size() + (content.empty() ? 0 : 8 + content.size());
        word(0x46546c67);
        word(2);
        word(static_cast<std::uint32_t>(size));
        word(static_cast<std::uint32_t>(text.size()));
        word(0x4e4f534a);
        for (const char c : text) out.push_back(static_cast<std::byte>(c));
        if (content.empty()) return out;
        word(static_cast<std::uint32_t>(content.size()));
        word(0x004e4942);
        out.insert(out.end(), content.begin(), content.end());
        return out;
    }

    static std::string base64(std::span<const std::byte> bytes) {
        constexpr const char* kDigits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string out;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                bits = bits << 8 |
                       (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
            }
            for (std::size_t k = 0; k < 4; ++k) {
                out += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
            }
        }
        return out;
    }
};

}  // namespace pelage::test
