// gltf_samples.h -- a small glTF that has something of everything, for tests of the writer.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "gltf_bytes.h"

namespace pelage::test {

// Float values of an accessor with a view of its own or a packed part of one.
inline std::vector<float> floatsOf(const Glb& glb, std::size_t accessor) {
    const OrderedJson& a = glb.json["accessors"][accessor];
    const OrderedJson& view = glb.json["bufferViews"][a["bufferView"].get<std::size_t>()];
    const std::string type = a["type"];
    const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    std::vector<float> values(a["count"].get<std::size_t>() * width);
    std::memcpy(values.data(),
                glb.bin.data() + view.value("byteOffset", 0u) + a.value("byteOffset", 0u),
                values.size() * sizeof(float));
    return values;
}

// The smallest PNG signature that a reader takes for a picture.
inline std::vector<std::byte> pictureBytes() {
    std::vector<std::byte> out;
    for (const int c : {0x89, 0x50, 0x4E, 0x47, 13, 10, 0x1A, 10, 1, 2, 3})
        out.push_back(static_cast<std::byte>(c));
    return out;
}

// Three buffers (the first of 37 bytes), two meshes on three nodes, a primitive of lines between
// those of triangles, shared positions, a morph target, an animation, an extension that nobody
// knows, extras of many kinds, and numbers that are easily changed. `uris` are those of the three
// buffers.
inline OrderedJson crowdedGltf(const std::vector<std::string>& uris) {
    OrderedJson json = OrderedJson::parse(R"({
      "zebra": "an unknown member", "asset": {"generator": "by hand", "version": "2.0"},
      "extensionsUsed": ["VENDOR_unknown", "KHR_materials_unlit"],
      "scene": 1,
      "scenes": [{"nodes": [2], "name": "empty"}, {"nodes": [0, 1]}],
      "nodes": [
        {"name": "first", "mesh": 0, "translation": [1.0, 2, 3e0], "extras": {"a": [1, {"b": null}]}},
        {"mesh": 1, "rotation": [0.0, 0.7071067811865476, 0.0, 0.7071067811865476]},
        {"name": "again", "mesh": 0, "extras": 12.50}
      ],
      "meshes": [
        {"weights": [0.0], "name": "Ünicode \u0000 name", "primitives": [
          {"mode": 4, "attributes": {"POSITION": 0}, "material": 0,
           "targets": [{"POSITION": 1}], "extensions": {"VENDOR_unknown": {"x": 18446744073709551615}}},
          {"attributes": {"POSITION": 3}, "mode": 1},
          {"attributes": {"_OTHER": 2, "POSITION": 0}, "targets": [{"POSITION": 1}]}
        ], "extras": {"targetNames": ["smile"], "tiny": 1e-300, "one": 1.0, "minus": -9007199254740993}},
        {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 4}}]}
      ],
      "materials": [{"name": "skin", "extensions": {"KHR_materials_unlit": {}},
                     "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
      "textures": [{"source": 0}],
      "images": [{"name": "fell", "uri": "data:image/png;base64,iVBORw0KGgo="}],
      "animations": [{"name": "turn", "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}],
                      "samplers": [{"input": 5, "output": 0, "interpolation": "LINEAR"}]}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0.0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0.25]},
        {"bufferView": 2, "componentType": 5126, "count": 3, "type": "SCALAR"},
        {"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3", "min": [0, 0, 0], "max": [1, 0, 0]},
        {"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC2"},
        {"bufferView": 2, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0.5], "max": [2.5], "name": "times"}
      ],
      "bufferViews": [
        {"buffer": 0, "byteLength": 36, "name": "positions"},
        {"buffer": 1, "byteOffset": 0, "byteLength": 36},
        {"byteOffset": 4, "buffer": 2, "byteLength": 12},
        {"buffer": 2, "byteOffset": 16, "byteLength": 24}
      ],
      "buffers": [
        {"byteLength": 37, "name": "zero"}, {"byteLength": 36}, {"byteLength": 40, "extras": {"kept": true}}
      ]
    })");
    for (std::size_t b = 0; b < uris.size(); ++b)
        if (!uris[b].empty()) json["buffers"][b]["uri"] = uris[b];
    return json;
}

// Contents of the three buffers.
inline std::vector<std::vector<std::byte>> crowdedBuffers() {
    auto first = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    first.push_back(std::byte{0x7F});
    return {first, bytesOf<float>({0, 0, 0.25f, 0, 0, 0, 0, 0, 0}),
            bytesOf<float>({9, 0.5f, 1.5f, 2.5f, 0, 0, 1, 0, 0, 1})};
}

// The same with its buffers as data URIs, as the text of a .gltf.
inline std::vector<std::byte> crowdedFile(const OrderedJson& change = OrderedJson::object()) {
    std::vector<std::string> uris;
    for (const auto& buffer : crowdedBuffers()) uris.push_back(dataUri(buffer));
    OrderedJson json = crowdedGltf(uris);
    json = json.patch(change.is_array() ? change : OrderedJson::array());
    const std::string text = json.dump();
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

}  // namespace pelage::test
