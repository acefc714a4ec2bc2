// strand.cpp -- strand.glsl and fiber.glsl, as C++.
#include "strand.h"

namespace pelage {

using glm::abs, glm::acos, glm::clamp, glm::cos, glm::cross, glm::dot, glm::exp,
    glm::floatBitsToUint, glm::isinf, glm::isnan, glm::length, glm::log, glm::max, glm::min,
    glm::mix, glm::normalize, glm::pow, glm::sin, glm::sqrt;

#include "shaders/strand.glsl"

#include "shaders/fiber.glsl"

}  // namespace pelage
