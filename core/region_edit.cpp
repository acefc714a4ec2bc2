// region_edit.cpp -- what an edit of a region does at one vertex.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "averages.h"
#include "morton.h"
#include "region.h"
#include "strand.h"
#include "tools.h"

namespace pelage {
namespace {

// In [-1,1), from a place and a seed.
float drawAt(vec3 place, uint seed) {
    const uvec3 bits = positionBits(place);
    return 2.0f * rand01(pcg(bits.x ^ pcg(bits.y ^ pcg(bits.z ^ pcg(seed))))) - 1.0f;
}

// `w`: the share by which the vertex takes part. `mean`: around it, of smooth.
struct Spot {
    const Skin& skin;
    uint v;
    float w;
    FurVertex mean;

    const SkinVertex& vertex() const { return skin.vertices[v]; }
    float scale() const { return skin.frames[vertex().frame].scale; }
};

// Length in the mesh's units, or density; `set` and `mean` in the same.
float changedNumber(const Spot& spot, const RegionEdit& change, float old, float set, float mean) {
    const float w = spot.w;
    switch (change.act) {
        case RegionAct::scale:
            return old * glm::mix(1.0f, change.value, w);
        case RegionAct::set:
            return glm::mix(old, set, w);
        case RegionAct::smooth:
            return old + w * change.value * (mean - old);
        case RegionAct::randomise:
            return old * (1.0f + w * change.value * drawAt(spot.vertex().position, change.seed));
    }
    return old;
}

// The tangential part of `direction`, with all of its magnitude, at most 1.
std::optional<vec3> laidDown(vec3 direction, vec3 normal) {
    if (direction == vec3(0.0f)) return vec3(0.0f);
    const vec3 heading = onTangentPlane(direction, normal);
    if (heading == vec3(0.0f)) return std::nullopt;
    return std::min(glm::length(direction), 1.0f) * heading;
}

vec3 changedDirection(const Spot& spot, const RegionEdit& change, const FurVertex& old) {
    if (change.act == RegionAct::scale)
        return shortened(old.direction * glm::mix(1.0f, change.value, spot.w));

    FurVertex fur = furToWorld(spot.skin, spot.v, old);
    const vec3 here = fur.direction;
    if (change.act == RegionAct::set) {
        const auto target = laidDown(change.direction, spot.vertex().normal);
        if (!target) return old.direction;
        fur.direction = glm::mix(here, *target, spot.w);
    } else if (change.act == RegionAct::smooth) {
        fur.direction = here + spot.w * change.value * (spot.mean.direction - here);
    } else {
        const vec3 n = spot.vertex().normal;
        if (n == vec3(0.0f)) return old.direction;
        const float draw = drawAt(spot.vertex().position, change.seed);
        const float angle = std::numbers::pi_v<float> * spot.w * change.value * draw;
        const vec3 along = n * glm::dot(n, here), flat = here - along;
        fur.direction = along + std::cos(angle) * flat + std::sin(angle) * glm::cross(n, flat);
    }
    if (fur.direction == here) return old.direction;
    return shortened(furToMesh(spot.skin, spot.v, fur).direction);
}

FurVertex changed(const Spot& spot, const RegionEdit& change, const FurVertex& old) {
    FurVertex fur = old;
    if (change.channel == Channel::length) {
        const float to = changedNumber(spot, change, old.furLength, change.value / spot.scale(),
                                       spot.mean.furLength / spot.scale());
        fur.furLength = std::clamp(to, 0.0f, kGreatestLength);
    } else if (change.channel == Channel::density) {
        const float to = changedNumber(spot, change, old.density, change.value, spot.mean.density);
        fur.density = std::clamp(to, 0.0f, 1.0f);
    } else if (change.channel == Channel::direction) {
        fur.direction = changedDirection(spot, change, old);
    }
    // A singular frame or a field from a hostile file may have no finite answer.
    const bool finite = std::isfinite(fur.furLength) && std::isfinite(fur.density) &&
                        std::isfinite(glm::dot(fur.direction, fur.direction));
    return finite ? fur : old;
}

}  // namespace

void applyRegion(const SkinQuery& query, Groom& groom, const Region& region,
                 const RegionEdit& change) {
    assert(change.channel == Channel::length || change.channel == Channel::density ||
           change.channel == Channel::direction);
    const Skin& skin = query.skin();
    const std::vector<float> weights = regionWeights(query, groom, region);
    std::optional<Averages> averages;
    if (change.act == RegionAct::smooth) averages.emplace(query, groom, kFloodReach * skin.size());
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const float held = region.where == Where::mask ? 0.0f : groom.mask[v];
        const float w = weights[v] * (1.0f - held);
        if (!(w > 0.0f)) continue;
        const FurVertex old = groom.fur[v];
        const Spot spot{skin, v, w, averages ? averages->around(v) : FurVertex{}};
        const FurVertex fur = changed(spot, change, old);
        if (!(fur == old)) groom.fur.edit(v) = fur;
    }
}

}  // namespace pelage
