// strand_source.h -- the shared source of hairs as C++, to be included inside a namespace.
// NOLINTBEGIN: the dialect is GLSL's.
using glm::abs, glm::acos, glm::ceil, glm::clamp, glm::cos, glm::cross, glm::dot, glm::exp,
    glm::floatBitsToUint, glm::floor, glm::isinf, glm::isnan, glm::length, glm::log, glm::max,
    glm::min, glm::mix, glm::normalize, glm::pow, glm::sin, glm::sqrt, glm::uintBitsToFloat;

// What rod.glsl asks for.
inline vec4 rodTexel(uint i) { return rodTable()[i]; }
constexpr bool kRods = true;

#define precise  // as every operation of C++ is, compiled without fused ones
#include "shaders/strand.glsl"

#include "shaders/fiber.glsl"
#undef precise
// NOLINTEND
