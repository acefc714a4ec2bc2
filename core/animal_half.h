// animal_half.h -- the half of the animal's mesh at x >= 0, from which the whole is made. Private
// to animal*.cpp.
#pragma once

#include <vector>

#include "animal_shape.h"

namespace pelage::animal {

struct Half {
    std::vector<vec3> positions, normals;
    std::vector<char> onWall;  // x = 0 for good
    std::vector<uvec3> triangles;
};

// Spreads the vertices evenly: along the surface towards the middle of their ring, and back onto
// it. Leaves unit normals. `cell` is the spacing of the lattice, m.
void relax(const Shape& shape, Half& half, float cell);

// The half and its mirror image, joined at x = 0.
Surface mirrored(Half half, float cell);

}  // namespace pelage::animal
