// skin_query.h -- where a ray meets the skin, and what of it lies near a point.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "skin.h"

namespace pelage {

struct SkinHit {
    vec3 position{0.0f};  // world
    vec3 normal{0.0f};    // unit, of the face; of a ray: turned towards where it came from
    uint triangle = 0;
    float u = 0.0f, v = 0.0f;  // barycentric weights of the second and third corner
    float distance = 0.0f;     // m along the ray, or from the point
};

// Bounding volume hierarchies (Embree) over triangles, for rays, and over runs of neighbouring
// vertices, for radius queries; and the triangles around each vertex. Holds the skin. May be used
// from several threads at once.
class SkinQuery {
public:
    explicit SkinQuery(std::shared_ptr<const Skin> skin);
    ~SkinQuery();
    SkinQuery(SkinQuery&&) noexcept;
    SkinQuery& operator=(SkinQuery&&) noexcept;

    // The first triangle that the ray meets, from either side. Degenerate triangles are never met.
    std::optional<SkinHit> cast(vec3 origin, vec3 direction) const;

    // The point of the skin that is nearest to `point`, with the normal on the side of the hair; of
    // equally near ones that of the first triangle. Only faces whose normal has a part along
    // `facing` count unless that is zero, so that a point near one side of an ear finds that side.
    // Degenerate triangles are never found. Nothing for a point that is not finite.
    std::optional<SkinHit> nearest(vec3 point, vec3 facing = vec3(0.0f)) const;

    // Appends every vertex within `radius` of the point, in rising order. Cost grows with what is
    // found, not with the mesh.
    void within(vec3 point, float radius, std::vector<uint>& vertices) const;

    // The triangles that name vertex v, each by its two other corners in the order of its winding;
    // where it can be, the first corner of one is the second of the one before.
    std::span<const uvec2> fan(uint v) const;

    const Skin& skin() const;

private:
    struct Scenes;
    std::unique_ptr<Scenes> scenes_;
};

}  // namespace pelage
