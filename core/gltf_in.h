// gltf_in.h -- a glTF 2.0 file as a source: every accessor form, skins at rest, what moves them,
// fur fields.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "source.h"

namespace pelage {

// Reads a .glb or .gltf from memory; `path` is for messages and for files beside it, which are
// refused when it is empty. Promises: every primitive of triangles, strips or fans becomes a part,
// its vertices as the file has them (with the default morph weights applied); memory and time are
// bounded by the length of what is read. Throws std::runtime_error with one line.
Source readGltf(std::span<const std::byte> bytes, const std::string& path,
                Progress* progress = nullptr);

}  // namespace pelage
