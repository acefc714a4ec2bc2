// morton.h -- places in space to numbers, such that near numbers are near places.
#pragma once

#include <bit>
#include <cstdint>

#include "types.h"

namespace pelage {

// Equal exactly where places are: -0 and 0 are the same place.
inline uvec3 positionBits(vec3 p) { return std::bit_cast<uvec3>(p + 0.0f); }

// Spreads the low 21 bits of x so that two zeros follow each.
inline std::uint64_t spreadBits(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    x = (x | x << 2) & 0x1249249249249249;
    return x;
}

inline constexpr float kLastCell = 2097151.0f;  // of 2^21 along each axis

// Place on the Morton curve through the cube of 2^21 cells a side that begins at `lower`. Morton,
// "A computer oriented geodetic data base", 1966.
inline std::uint64_t mortonCode(vec3 p, vec3 lower, float cellsPerMetre) {
    const vec3 cell = glm::clamp((p - lower) * cellsPerMetre, vec3(0.0f), vec3(kLastCell));
    const auto bits = [](float x) { return spreadBits(static_cast<std::uint64_t>(x)); };
    return bits(cell.x) | bits(cell.y) << 1 | bits(cell.z) << 2;
}

}  // namespace pelage
