// pick.h -- what is painted at a point of the skin that is no vertex.
#pragma once

#include "groom.h"
#include "skin_query.h"

namespace pelage {

struct Picked {
    FurVertex fur;      // world
    float mask = 0.0f;  // [0,1]
};

// The barycentric mean of the triangle's corners; at a corner its own values.
Picked pickedAt(const Skin& skin, const Groom& groom, const SkinHit& hit);

}  // namespace pelage
