// types.h -- types.glsl, as C++.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

using glm::vec2, glm::vec3, glm::vec4, glm::mat3, glm::mat3x4, glm::mat4, glm::uvec2, glm::uvec3,
    glm::ivec2;
using uint = std::uint32_t;

#include "shaders/types.glsl"

inline bool operator==(const FurVertex& a, const FurVertex& b) {
    return a.direction == b.direction && a.furLength == b.furLength && a.density == b.density &&
           a.tint == b.tint;
}

}  // namespace pelage
