// base_color.h -- the color of the skin's material at a place, as the renderer shows it.
#pragma once

#include <vector>

#include "pixels.h"
#include "skin.h"

namespace pelage {

class BaseColor {
public:
    // Decodes the pictures of the skin's source; one that is damaged counts as white.
    explicit BaseColor(const Skin& skin);

    // Linear RGB where the three corners of a triangle have these weights: factor of the material
    // times color of the vertices times picture (repeating, mixed linearly between its pixels).
    vec3 at(uint triangle, vec3 weights) const;

private:
    vec3 texel(const Pixels& picture, ivec2 at) const;

    const Source* source_;
    std::vector<int> materialOf_;  // of each triangle, -1 = white
    std::vector<Pixels> pictures_;
    std::vector<float> linear_;  // of each value of a byte
};

}  // namespace pelage
