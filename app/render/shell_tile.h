// shell_tile.h -- the tile of roots whose hair shells cut, as shaders/shell_hair.glsl reads it.
#pragma once

#include <vector>

#include "core/types.h"

namespace pelage {

// The two nearest roots of each texel, level after level.
std::vector<uvec2> tileTexels();

// m, side of the tile where so many hairs of a coat stand on a square metre.
float tilePeriod(float perArea);

}  // namespace pelage
