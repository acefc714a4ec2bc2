// ray_scene.h -- skin and hair for rays: what they meet first, and what keeps light out.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "progress.h"
#include "skin.h"
#include "strands_out.h"

namespace pelage {

struct RayHit {
    vec3 place{0.0f};   // world
    vec3 facing{0.0f};  // unit, normal of the face or of the round hair towards the ray's origin
    bool onHair = false;
    uint number = 0;     // of the hair among the curves, or of the triangle
    float t = 0.0f;      // of a hair, [0,1] from root to tip
    vec3 weights{0.0f};  // of the corners of the triangle
};

// Hairs are chains of round cones with a ball at each joint and at both ends. Bounding volume
// hierarchies by Embree, which misses some ends of hairs that do not taper and point within a
// milliradian at the ray's origin. May be used from several threads at once.
class RayScene {
public:
    // Skin may be null; it is kept. Tapers are those of the coats of each hair. Throws Cancelled.
    RayScene(std::shared_ptr<const Skin> skin, const Curves& curves,
             const std::vector<float>& tapers, Progress* progress);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    // The first thing that a ray meets; direction is unit. Triangles without area are never met.
    std::optional<RayHit> cast(vec3 origin, vec3 direction) const;

    // Whether light from a unit direction is kept from a place where a ray arrived. The skin blocks
    // it, and of the hairs in its way, without the one it was met on, each with probability
    // `share`, decided by its number and the seed.
    bool blocked(const RayHit& from, vec3 direction, float share, uint seed) const;

    // A ball around all of it, m.
    vec3 center() const;
    float radius() const;
    std::size_t bytes() const;  // that Embree holds

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace pelage
