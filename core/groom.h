// groom.h -- what is painted on the skin, and the operations on all of it.
#pragma once

#include "chunked.h"
#include "skin.h"
#include "types.h"

namespace pelage {

struct Groom {
    Chunked<FurVertex> fur;  // one per skin vertex, in the mesh space of the file
    Chunked<float> mask;     // one per skin vertex, [0,1]; 1 = no brush changes it. Never saved

    bool operator==(const Groom&) const = default;  // the same chunks, not merely equal values
};

// The channels a brush, a flood or an overlay can name.
enum class Channel { length, density, direction, mask };

// What a vertex holds before anything is painted: no hair, as dark as its coat.
inline constexpr FurVertex kBareFur{vec3(0.0f), 0.0f, vec3(1.0f), 0.0f};

// Length of hair that nobody has painted, m: 4 % of the bounds' diagonal.
float firstLength(const Skin& skin);

// The groom of a mesh that nobody has groomed yet: of that length, density 1, combed towards the
// tail where the skin has segments, otherwise down and back for an animal that looks along +z; in
// place of that the fields found in the file, bit for bit.
Groom initialGroom(const Skin& skin);

// The largest and smallest values of a channel over all vertices (direction: of its magnitude).
struct FieldRange {
    float least = 0.0f, greatest = 0.0f;
};
FieldRange fieldRange(const Groom& groom, Channel channel);

}  // namespace pelage
