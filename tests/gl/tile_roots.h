// tile_roots.h -- where the hairs of the tile of shells stand, reckoned apart from the shaders.
#pragma once

#include <cmath>
#include <vector>

#include "core/shell_map.h"
#include "core/types.h"

namespace pelage::test {

// The roots of the tile within a square of 1 m around the origin, where so many hairs stand on a
// square metre, from what shaders/shell_hair.glsl says of the overcoat along the axis y: x and z,
// m.
inline std::vector<vec2> rootsAround(float hairs) {
    const float period = std::sqrt(1024.0f / (1.45f * hairs));
    const RootMap map = rootMap({.side = 1, .hairs = 1024});
    constexpr uint kStream = 4;
    std::vector<vec2> roots;
    const int reach = static_cast<int>(0.5f / period) + 2;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (uint k = 0; k < 1024; ++k) {
                const uvec2 at(map.roots[k] * 2048.0f);
                const float rank = 0.6180340f * static_cast<float>(k) +
                                   glm::dot(vec2(i, j), vec2(0.7548777f, 0.5698403f));
                const float chance = 1021.7f * (rank - std::floor(rank));
                if (!(chance - std::floor(chance) < 1.0f / 1.45f)) continue;
                const vec2 place = (vec2(at) + 0.5f) / 2048.0f + vec2(i, j) -
                                   static_cast<float>(kStream) * vec2(0.7548777f, 0.5698403f);
                const vec2 zx = period * place;
                if (std::abs(zx.x) < 0.5f && std::abs(zx.y) < 0.5f) roots.emplace_back(zx.y, zx.x);
            }
    return roots;
}

}  // namespace pelage::test
