// source_check.h -- what must hold for a source whichever file it came from.
#pragma once

#include <cstddef>
#include <span>

#include "source.h"

namespace pelage {

// Products of three such lengths stay finite as float.
inline constexpr float kMaxCoordinate = 1e12f;  // m

// Sets the length of the arrays that only some parts filled, and refuses (naming `file`) a source
// without triangles, a vertex whose place in the world is not finite or is so far out that areas
// overflow, and asserts that triangles name vertices of their own part.
void finishSource(Source& source, const std::string& file);

// True for the first bytes of a PNG or a JPEG.
bool isPicture(std::span<const std::byte> bytes);

}  // namespace pelage
