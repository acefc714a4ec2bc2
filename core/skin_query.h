// skin_query.h -- where a ray meets the skin, and which vertices lie near a point.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "skin.h"

namespace pelage {

struct SkinHit {
    vec3 position{0.0f};  // world
    vec3 normal{0.0f};    // unit, of the face, turned towards where the ray came from
    uint triangle = 0;
    float u = 0.0f, v = 0.0f;  // barycentric weights of the second and third corner
    float distance = 0.0f;     // m along the ray
};

// Bounding volume hierarchies (Embree) over triangles, for rays, and over runs of neighbouring
// vertices, for radius queries. Holds the skin. May be used from several threads at once.
class SkinQuery {
public:
    explicit SkinQuery(std::shared_ptr<const Skin> skin);
    ~SkinQuery();
    SkinQuery(SkinQuery&&) noexcept;
    SkinQuery& operator=(SkinQuery&&) noexcept;

    // The first triangle that the ray meets, from either side. Degenerate triangles are never met.
    std::optional<SkinHit> cast(vec3 origin, vec3 direction) const;

    // Appends every vertex within `radius` of the point, in rising order. Cost grows with what is
    // found, not with the mesh.
    void within(vec3 point, float radius, std::vector<uint>& vertices) const;

    const Skin& skin() const;

private:
    struct Scenes;
    std::unique_ptr<Scenes> scenes_;
};

}  // namespace pelage
