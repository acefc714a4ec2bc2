// groom.h -- what is painted on the skin, and the operations on all of it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "chunked.h"
#include "skin.h"
#include "types.h"

namespace pelage {

struct Groom {
    // One value per skin vertex.
    Chunked<FurVertex> fur;   // in the mesh space of the file
    Chunked<float> mask;      // [0,1]; 1 = no brush changes it. Never saved
    Chunked<uint> segmentOf;  // into body(), or kNoSegment
    // The parts of the body, replaced as a whole where one changes; null = none.
    std::shared_ptr<const std::vector<Segment>> segments;

    std::span<const Segment> body() const {
        return segments ? std::span<const Segment>(*segments) : std::span<const Segment>();
    }

    bool operator==(const Groom&) const = default;  // the same chunks, not merely equal values
};

// Writes a vertex unless it holds these values already: writing may copy a chunk.
void writeVertex(Groom& groom, uint v, const FurVertex& fur, float mask);

// The channels a brush, a flood or an overlay can name.
enum class Channel { length, density, direction, mask };

// What a vertex holds before anything is painted: no hair, as dark as its coat.
inline constexpr FurVertex kBareFur{vec3(0.0f), 0.0f, vec3(1.0f), 0.0f};

// Length of hair that nobody has painted, m: 4 % of the bounds' diagonal.
float firstLength(const Skin& skin);

// The same hair at every vertex, no mask, and the body segments of the source.
Groom evenGroom(const Skin& skin, const FurVertex& fur);

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
