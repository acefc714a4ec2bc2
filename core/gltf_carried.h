// gltf_carried.h -- a glTF exactly as it was in its file. Shared by gltf_in and gltf_out only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

struct CarriedGltf {
    std::string json;                             // the JSON chunk or .gltf file, unchanged
    std::vector<std::vector<std::byte>> buffers;  // resolved content of each buffer of the file
    std::vector<std::vector<std::byte>> images;   // of images with an external URI; else empty
};

}  // namespace pelage
