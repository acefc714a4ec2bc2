// tools.h -- what each tool does at one vertex: pure functions of the groom before and the
// coverage.
#pragma once

#include "brush.h"

namespace pelage {

// How hard a tool works at a vertex.
struct Touching {
    float coverage = 0.0f;  // [0,1] of the brush, without its strength
    vec3 path{0.0f};        // world; where the comb went, of any length
    FurVertex around{};     // world; for smooth, the mean around the vertex before (averages.h)
};

// What a vertex holds after the brush. Let c = coverage x strength.
// Length: grows or shrinks by c x 4 % of the skin's size, or tends to `value` by the share c.
// Density and mask: up or down by c, or tends to `value`; kept in [0,1].
// Comb: the direction tends by the share c to the path (subtract: against it) laid onto the tangent
// plane, at full magnitude; the length stays.
// Smooth: length, density and direction tend by the share c to their mean around the vertex.
// The mask m holds back all but the mask tool: new values tend back to the old by the share m.
FurVertex brushedFur(const Skin& skin, const Groom& before, const Brush& brush, uint v,
                     const Touching& touching);
// The mask of the vertex after the brush; as before for all but the mask tool.
float brushedMask(const Groom& before, const Brush& brush, uint v, const Touching& touching);

}  // namespace pelage
