// split_normals.h -- normals of a mesh whose vertices are split where it has hard edges.
#pragma once

#include <span>
#include <vector>

#include "types.h"

namespace pelage {

// Replaces normals by those of the triangles, weighted by their angle. Vertices at one place (of
// equal `place`) share theirs if their normals were the same before, to 2.5 degrees: hard edges
// stay hard, seams of texture coordinates stay smooth. Each stays on its side of the surface; one
// without a triangle that has an area keeps what it had, made unit.
void renewNormals(std::span<const vec3> positions, std::span<const uint> place,
                  std::span<const uvec3> triangles, std::span<vec3> normals);

}  // namespace pelage
