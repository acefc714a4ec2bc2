// gltf_material.h -- what is shown of the materials of a glTF: base color and its picture.
#pragma once

#include <cstddef>
#include <vector>

#include "gltf_file.h"
#include "source.h"

namespace pelage {

// Which texture coordinates the base color of a material uses, and how they are moved
// (KHR_texture_transform): uv' = matrix * (u, v, 1).
struct BaseColorUvs {
    std::size_t set = 0;  // of TEXCOORD_n
    bool moved = false;
    mat3 matrix{1.0f};
};

// Fills materials and images of `source`, and returns one entry per material. Pictures beside the
// file are read into the carried glTF, too; one that is missing or of a kind that is not shown
// (neither PNG nor JPEG) is a warning, one out of the folder is refused.
std::vector<BaseColorUvs> readMaterials(GltfFile& file, Source& source);

}  // namespace pelage
