// shell_tile.cpp -- the tile of roots whose hair shells cut.
#include "app/render/shell_tile.h"

#include <algorithm>
#include <cmath>

#include "core/shell_map.h"

namespace pelage {
namespace {

// As in shaders/shell_hair.glsl.
constexpr uint kTileHairs = 1024, kTileSide = 256, kTileLevels = 9;
constexpr float kTileExcess = 1.45f;

uint packed(const RootMap& map, uint number) {
    const auto place = [](float x) { return std::min(static_cast<uint>(x * 2048.0f), 2047u); };
    return place(map.roots[number].x) | place(map.roots[number].y) << 11 | number << 22;
}

}  // namespace

// Each coarser level has the first half of the roots, which are as evenly spread.
std::vector<uvec2> tileTexels() {
    std::vector<uvec2> texels;
    for (uint level = 0; level < kTileLevels; ++level) {
        const int side = static_cast<int>(kTileSide >> (level / 2));
        const RootMap map = rootMap({.side = side, .hairs = kTileHairs >> level});
        for (const RootTexel& texel : map.texels)
            texels.emplace_back(packed(map, texel.nearest), packed(map, texel.next));
    }
    return texels;
}

float tilePeriod(float perArea) {
    return std::sqrt(static_cast<float>(kTileHairs) / std::max(kTileExcess * perArea, 1e-12f));
}

}  // namespace pelage
