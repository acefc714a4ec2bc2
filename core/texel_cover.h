// texel_cover.h -- which texels of a level one of the next coarser level covers, and how far.
#pragma once

#include <algorithm>
#include <cmath>

namespace pelage {

// Along one side: those of [first, end), of the ones at both ends a share.
struct Cover {
    double from, to;

    Cover(int at, int fine, int coarse)
        : from(static_cast<double>(at) * fine / coarse),
          to(static_cast<double>(at + 1) * fine / coarse) {}
    int first() const { return static_cast<int>(from); }
    int end() const { return static_cast<int>(std::ceil(to)); }
    double share(int i) const { return std::min(to, i + 1.0) - std::max(from, double(i)); }
};

}  // namespace pelage
