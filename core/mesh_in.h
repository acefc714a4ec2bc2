// mesh_in.h -- .obj, .ply, .off and .stl files as a source.
//
// Own readers, because a groomer must tell what is in the file: every face is kept in its order,
// also one that repeats a corner or makes an edge non-manifold, and each complaint names its line,
// or the vertex or face of a binary file. Each reads from memory; `path` is for messages and, in
// OBJ and PLY, for a picture beside the file, which is left out when `path` is empty. Polygons are
// cut into fans. The source is one part. Throws std::runtime_error with one line.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "source.h"

namespace pelage {

// Vertices are the v lines in their order, also those that no face uses; a further texture
// coordinate of the same v makes a further vertex after them. The v of texture coordinates is
// turned to glTF's (0 at the top). The picture is that of map_Kd, else one named like the file.
// Several materials, objects or groups become body segments (segment_parts.h).
Source readObj(std::span<const std::byte> bytes, const std::string& path,
               Progress* progress = nullptr);

// ASCII and binary of both byte orders, any property types; elements and properties that a surface
// does not need are passed over. Integer colors are taken for sRGB.
Source readPly(std::span<const std::byte> bytes, const std::string& path,
               Progress* progress = nullptr);

// OFF with the prefixes ST, C and N.
Source readOff(std::span<const std::byte> bytes, const std::string& path,
               Progress* progress = nullptr);

// Three vertices per triangle, as the format has them. Binary or ASCII is decided by the length:
// binary files may begin with "solid", too.
Source readStl(std::span<const std::byte> bytes, const std::string& path,
               Progress* progress = nullptr);

// True if the length is what a binary STL of that many triangles has.
bool isBinaryStl(std::span<const std::byte> bytes);

}  // namespace pelage
