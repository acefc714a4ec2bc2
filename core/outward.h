// outward.h -- whether a mesh is closed and faces outwards, so that its back faces are never seen.
#pragma once

#include <span>

#include "types.h"

namespace pelage {

// True where each connected part encloses a positive volume: the triangles run counter-clockwise as
// seen from outside. Only of meaning where every edge is used by two triangles in opposite
// directions, which the caller knows.
bool facesOutward(std::span<const SkinVertex> vertices, std::span<const uvec3> triangles);

}  // namespace pelage
