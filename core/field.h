// field.h -- the built-in field: a piece of rolling ground for grass, at any resolution.
#pragma once

#include <cstddef>

#include "document.h"
#include "source.h"

namespace pelage {

// A square of 2 m that looks up, brown as earth, with unit normals and UVs without overlap; its
// hills are up to 15 cm high or deep about y = 0. `triangles` in [2000, 2000000]; the count made is
// within 10 % of it.
Source makeField(std::size_t triangles);

// The field under the preset grass, longer and shorter, combed a little every way.
Document groomedField(std::size_t triangles);

}  // namespace pelage
