// groom.cpp -- the first groom of a skin, and what a groom's fields span.
#include "groom.h"

#include <algorithm>
#include <cmath>

#include "segment_comb.h"

namespace pelage {
namespace {

constexpr float kLean = 0.5f;  // |direction| of hair nobody has painted
// Without segments: down and to the back of an animal that looks along +z.
constexpr vec3 kDownAndBack{0.0f, -0.8f, -0.6f};

float distanceToAxis(vec3 p, const Segment& segment) {
    const vec3 axis = segment.tip - segment.root;
    const float size = glm::dot(axis, axis);
    const float t =
        size > 0.0f ? std::clamp(glm::dot(p - segment.root, axis) / size, 0.0f, 1.0f) : 0.0f;
    return glm::length(p - segment.root - t * axis);
}

// The axes of the segments near a point, by the inverse fourth power of their distance: smooth, and
// within a segment nearly its own axis.
vec3 combNear(std::span<const Segment> segments, uint own, vec3 p, float size) {
    vec3 sum(0.0f);
    for (uint s = 0; s < segments.size(); ++s) {
        const vec3 axis = segments[s].tip - segments[s].root;
        const float length = glm::length(axis);
        if (!(length > 0.0f)) continue;
        const float near = 0.01f * size + distanceToAxis(p, segments[s]);
        const float share = size / near;
        const float weight = share * share * share * share * (s == own ? 2.0f : 1.0f);
        sum += weight * axis / length;
    }
    const float length = glm::length(sum);
    return length > 1e-6f ? sum / length : kDownAndBack;
}

// What a mesh has that nobody has groomed.
void paintFirst(const Skin& skin, Groom& groom) {
    const std::span<const Segment> segments = groom.body();
    const float size = skin.size();
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const SkinVertex& vertex = skin.vertices[v];
        const vec3 comb = segments.empty()
                              ? kDownAndBack
                              : combNear(segments, groom.segmentOf[v], vertex.position, size);
        FurVertex fur = kBareFur;
        fur.direction = kLean * laidOnSkin(comb, vertex.normal);
        fur.furLength = firstLength(skin);
        fur.density = 1.0f;
        groom.fur.edit(v) = furToMesh(skin, v, fur);
    }
}

}  // namespace

void writeVertex(Groom& groom, uint v, const FurVertex& fur, float mask) {
    if (!(groom.fur[v] == fur)) groom.fur.edit(v) = fur;
    if (groom.mask[v] != mask) groom.mask.edit(v) = mask;
}

float firstLength(const Skin& skin) { return 0.04f * skin.size(); }

Groom evenGroom(const Skin& skin, const FurVertex& fur) {
    const std::size_t count = skin.vertices.size();
    const Source& source = *skin.source;
    Groom groom{Chunked<FurVertex>(count, fur), Chunked<float>(count, 0.0f),
                Chunked<uint>(count, kNoSegment), nullptr};
    if (source.segments.empty()) return groom;
    groom.segments = {skin.source, &source.segments};
    if (source.segmentOf.empty()) return groom;
    const std::vector<uint>& first = skin.sourceOf;
    for (uint v = 0; v < count; ++v) {
        const uint segment = source.segmentOf[first[v]];
        if (segment < source.segments.size()) groom.segmentOf.edit(v) = segment;
    }
    return groom;
}

Groom initialGroom(const Skin& skin) {
    const std::size_t count = skin.vertices.size();
    Groom groom = evenGroom(skin, kBareFur);
    const SourceFur* carried = skin.source->fur.get();
    const bool complete = carried && !carried->length.empty() && !carried->density.empty() &&
                          !carried->direction.empty();
    if (!complete) paintFirst(skin, groom);
    if (!carried) return groom;
    // Of welded vertices with different values the first in the file counts.
    const std::vector<uint>& first = skin.sourceOf;
    for (uint v = 0; v < count; ++v) {
        FurVertex& fur = groom.fur.edit(v);
        if (!carried->direction.empty()) fur.direction = carried->direction[first[v]];
        if (!carried->length.empty()) fur.furLength = carried->length[first[v]];
        if (!carried->density.empty()) fur.density = carried->density[first[v]];
        if (!carried->tint.empty()) fur.tint = carried->tint[first[v]];
    }
    return groom;
}

FieldRange fieldRange(const Groom& groom, Channel channel) {
    const auto value = [&](std::size_t v) {
        switch (channel) {
            case Channel::length:
                return groom.fur[v].furLength;
            case Channel::density:
                return groom.fur[v].density;
            case Channel::direction:
                return glm::length(groom.fur[v].direction);
            case Channel::mask:
                return groom.mask[v];
        }
        return 0.0f;
    };
    FieldRange range;
    for (std::size_t v = 0; v < groom.fur.size(); ++v) {
        const float x = value(v);
        range.least = v == 0 ? x : std::min(range.least, x);
        range.greatest = v == 0 ? x : std::max(range.greatest, x);
    }
    return range;
}

}  // namespace pelage
