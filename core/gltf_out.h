// gltf_out.h -- the groomed .glb: the source as it was, and the fur on its own vertices.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "document.h"

namespace pelage {

struct ExportOptions {
    bool compatibilityUvs = false;  // mirror the fields into TEXCOORD_2..4 (assets/fur.md)
};

// The file as bytes. _FUR_LENGTH, _FUR_DENSITY (float SCALAR) and _FUR_DIRECTION (float VEC3, mesh
// space) on every primitive of triangles, and _FUR_TINT (float VEC3) where some hair of the
// document is tinted; extras.fur on meshes and the nodes that place them. The list of body segments
// in it, and _FUR_SEGMENT (float SCALAR), where they are not what the file gives without them. All
// else of a glTF source is carried through: the JSON value for value, buffers byte for byte,
// external files embedded. Other sources become one mesh with the source's vertices in their order.
// Throws std::runtime_error.
std::vector<std::byte> groomedGlb(const Document& document, const ExportOptions& options = {},
                                  Progress* progress = nullptr);

// The same into a file, atomically. Refuses a name that does not end in .glb (expectExtension).
void writeGroomedGlb(const Document& document, const std::string& path,
                     const ExportOptions& options = {}, Progress* progress = nullptr);

}  // namespace pelage
