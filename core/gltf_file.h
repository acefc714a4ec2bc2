// gltf_file.h -- a glTF taken apart: JSON whose references exist, and buffers in memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gltf_carried.h"
#include "json_place.h"
#include "progress.h"
#include "warnings.h"

namespace pelage {

// Files read for one mesh may be this long together: the file itself and those beside it.
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 31;

struct GltfFile {
    std::string name;  // opens every message
    std::string path;  // empty: external files are refused
    Json json;
    std::shared_ptr<CarriedGltf> carried;
    std::size_t bytes = 0;  // of the file and of all that it refers to
    Warnings warnings;
    // Values that may still be decoded: a small file can ask for a large buffer many times over.
    std::size_t budget = 0;

    JsonPlace root() const { return {name, json}; }
    // Element `index` of the top-level array of that name.
    JsonPlace element(const char* section, std::size_t index) const {
        return root().at(section).at(index);
    }
    JsonPlace primitive(std::size_t mesh, std::size_t number) const {
        return element("meshes", mesh).at("primitives").at(number);
    }
    std::size_t count(const char* section) const {
        const auto list = root().array(section);
        return list ? list->size() : 0;
    }
    // Largest number of vertices, and of triangles, that this file may unfold to. Stored ones take
    // several bytes each; the rest leaves room for primitives that share them, and a small file
    // still cannot ask for much.
    std::size_t elementLimit() const {
        return std::min((std::size_t{1} << 18) + 2 * bytes, std::size_t{1} << 31);
    }
};

// Takes a .glb or .gltf apart. Refuses, with one line: what is truncated or no JSON, versions other
// than 2, required extensions that are not supported (by name), references to what is not there,
// buffers without their bytes, and files outside the folder of `path`.
GltfFile openGltf(std::span<const std::byte> bytes, const std::string& path);

// Bytes of a buffer view.
std::span<const std::byte> viewBytes(const GltfFile& file, std::size_t view);

// Bytes of a data URI in base64; of no other kind. `place` is for messages.
std::vector<std::byte> dataUriBytes(const JsonPlace& place, const std::string& uri);

}  // namespace pelage
