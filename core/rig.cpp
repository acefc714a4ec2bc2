// rig.cpp -- matrices of nodes and of vertices that joints hold.
#include "rig.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace pelage {
namespace {

mat4 localMatrix(const NodePlace& place) {
    if (place.matrix) return *place.matrix;
    const vec4 r = place.rotation;
    const glm::dquat q(r.w, r.x, r.y, r.z);
    const double length = std::sqrt(glm::dot(q, q));
    mat4 out(1.0f);
    if (length > 0.0) out = mat4(glm::mat4_cast(q / length));
    for (int i = 0; i < 3; ++i) out[i] *= place.scale[i];
    out[3] = vec4(place.translation, 1.0f);
    return out;
}

}  // namespace

std::vector<mat4> worldMatrices(const NodeTree& tree) {
    std::vector<mat4> toWorld(tree.places.size(), mat4(0.0f));
    for (const std::size_t n : tree.order) {
        const mat4 local = localMatrix(tree.places[n]);
        toWorld[n] = tree.parent[n] == kNoNode ? local : toWorld[tree.parent[n]] * local;
    }
    return toWorld;
}

mat4 blended(std::span<const Influence> influences, std::span<const mat4> ofJoints) {
    mat4 sum(0.0f);
    float total = 0.0f;
    for (const auto& [joint, weight] : influences) {
        sum += weight * ofJoints[joint];
        total += weight;
    }
    return total == 1.0f ? sum : sum / total;
}

}  // namespace pelage
