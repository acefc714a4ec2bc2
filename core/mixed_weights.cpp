// mixed_weights.cpp -- mixes influences of two vertices.
#include "mixed_weights.h"

#include <algorithm>
#include <cmath>

namespace pelage {

Influences normalised(Influences influences) {
    double sum = 0.0;
    for (const Influence& influence : influences) sum += influence.weight;
    if (!(sum > 0.0) || !std::isfinite(sum) || std::abs(sum - 1.0) < 1e-7) return influences;
    for (Influence& influence : influences)
        influence.weight = static_cast<float>(influence.weight / sum);
    return influences;
}

Influences halfway(const Influences& a, const Influences& b, std::size_t most) {
    Influences mixed;
    for (const Influences* end : {&a, &b})
        for (const auto& [joint, weight] : *end) {
            if (!(weight > 0.0f)) continue;
            const auto known =
                std::find_if(mixed.begin(), mixed.end(),
                             [&, of = joint](const Influence& i) { return i.joint == of; });
            if (known != mixed.end())
                known->weight += 0.5f * weight;
            else
                mixed.push_back({joint, 0.5f * weight});
        }
    std::sort(mixed.begin(), mixed.end(), [](const Influence& x, const Influence& y) {
        return x.weight != y.weight ? x.weight > y.weight : x.joint < y.joint;
    });
    mixed.resize(std::min(mixed.size(), most));
    return normalised(std::move(mixed));
}

}  // namespace pelage
