// pick.cpp -- barycentric means.
#include "pick.h"

namespace pelage {

Picked pickedAt(const Skin& skin, const Groom& groom, const SkinHit& hit) {
    const uvec3 corners = skin.triangles[hit.triangle];
    const vec3 weights(1.0f - hit.u - hit.v, hit.u, hit.v);
    Picked mean{FurVertex{}, 0.0f};
    for (int i = 0; i < 3; ++i) {
        const uint v = corners[i];
        const FurVertex fur = furToWorld(skin, v, groom.fur[v]);
        mean.fur.direction += weights[i] * fur.direction;
        mean.fur.furLength += weights[i] * fur.furLength;
        mean.fur.tint += weights[i] * fur.tint;
        mean.fur.density += weights[i] * fur.density;
        mean.mask += weights[i] * groom.mask[v];
    }
    return mean;
}

}  // namespace pelage
