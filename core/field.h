// field.h -- the built-in field: a piece of rolling ground for grass, at any resolution.
#pragma once

#include <cstddef>

#include "document.h"
#include "source.h"

namespace pelage {

// Two metres square as seen from above, brown as earth, with unit normals and UVs without overlap.
// Its hills are up to 10 cm high or deep about y = 0, and it falls off at its edges, by 30 cm at
// most. `triangles` in [2000, 2000000]; the count made is within 10 % of it.
Source makeField(std::size_t triangles);

// The field under the preset grass, longer and shorter, combed a little every way.
Document groomedField(std::size_t triangles);

}  // namespace pelage
