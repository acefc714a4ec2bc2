// flank.h -- where a stroke along the animal's flank meets the skin.
#pragma once

#include <utility>
#include <vector>

#include "core/skin_query.h"

namespace pelage::bench {

// 24 places, `spacing` (m) apart, at the height at which most rays from the side meet the skin.
inline std::vector<SkinHit> flank(const SkinQuery& query, float spacing) {
    const Skin& skin = query.skin();
    std::vector<SkinHit> most;
    for (const float up : {0.0f, 0.05f, 0.1f, 0.15f, -0.05f, -0.1f}) {
        std::vector<SkinHit> hits;
        for (int i = 0; i < 24; ++i) {
            const vec3 from(skin.upper.x + skin.size(), skin.center().y + up * skin.size(),
                            skin.center().z + (static_cast<float>(i) - 12.0f) * spacing);
            if (const auto hit = query.cast(from, {-1.0f, 0.0f, 0.0f})) hits.push_back(*hit);
        }
        if (hits.size() > most.size()) most = std::move(hits);
    }
    return most;
}

}  // namespace pelage::bench
