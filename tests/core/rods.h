// rods.h -- hair that droops as elastic rods, for tests.
#pragma once

#include "core/coat.h"

namespace pelage::test {

inline const vec3 kDown(0, -1, 0);

// Its hair leaves the skin where it is combed, without randomness.
inline Coat rodCoat(float stiffness, float softness) {
    Coat coat = defaultFur().over;
    coat.droop = kDroopElastica;
    coat.stiffness = stiffness;
    coat.softness = softness;
    coat.directionWeight = 1.0f;
    coat.endRandomness = 0.0f;
    return coat;
}

}  // namespace pelage::test
