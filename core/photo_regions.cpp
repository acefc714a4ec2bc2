// photo_regions.cpp -- means over cells of the picture, two clusters of them, and every pixel's
// own.
#include "photo_regions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelage {
namespace {

vec3 oklabOf(vec3 rgb) {
    const vec3 cones(std::cbrt(glm::dot(rgb, vec3(0.4122214708f, 0.5363325363f, 0.0514459929f))),
                     std::cbrt(glm::dot(rgb, vec3(0.2119034982f, 0.6806995451f, 0.1073969566f))),
                     std::cbrt(glm::dot(rgb, vec3(0.0883024619f, 0.2817188376f, 0.6299787005f))));
    return {glm::dot(cones, vec3(0.2104542553f, 0.7936177850f, -0.0040720468f)),
            glm::dot(cones, vec3(1.9779984951f, -2.4285922050f, 0.4505937099f)),
            glm::dot(cones, vec3(0.0259040371f, 0.7827717662f, -0.8086757660f))};
}

// The colors of square cells; a cell counts by how much of it can be seen.
struct Cells {
    float side;  // pixels
    ivec2 size{0};
    std::vector<vec3> colors;  // Oklab
    std::vector<float> weights;

    std::size_t placeOf(ivec2 cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(cell.x);
    }
    // Between the middles of the cells around a pixel, one of which can be seen.
    vec3 colorAt(ivec2 pixel) const {
        const vec2 at = (vec2(pixel) + 0.5f) / side - 0.5f;
        const vec2 low = glm::floor(at), part = at - low;
        vec3 sum(0.0f);
        float weight = 0.0f;
        for (const ivec2 corner : {ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)}) {
            const std::size_t i = placeOf(glm::clamp(ivec2(low) + corner, ivec2(0), size - 1));
            const float share = (corner.x ? part.x : 1.0f - part.x) *
                                (corner.y ? part.y : 1.0f - part.y) * weights[i];
            sum += share * colors[i];
            weight += share;
        }
        return sum / weight;
    }
};

Cells cellsOf(const Image& photo) {
    Cells cells{std::max(4.0f, static_cast<float>(std::max(photo.size.x, photo.size.y)) / 64.0f),
                {},
                {},
                {}};
    cells.size = ivec2(glm::ceil(vec2(photo.size) / cells.side));
    std::vector<vec4> sums(pixelCount(cells.size), vec4(0.0f));
    for (int y = 0; y < photo.size.y; ++y)
        for (int x = 0; x < photo.size.x; ++x) {
            const ivec2 cell(vec2(x, y) / cells.side);
            sums[cells.placeOf(glm::min(cell, cells.size - 1))] +=
                photo.pixels[pixelCount({photo.size.x, y}) + static_cast<std::size_t>(x)];
        }
    for (const vec4& sum : sums) {
        cells.weights.push_back(sum.a);
        cells.colors.push_back(sum.a > 0.0f ? oklabOf(vec3(sum) / sum.a) : vec3(0.0f));
    }
    return cells;
}

using Means = std::array<vec3, 2>;

std::size_t nearerOf(const Means& means, vec3 color) {
    return glm::distance(color, means[1]) < glm::distance(color, means[0]) ? 1 : 0;
}

// The color that can be seen and is farthest from one.
vec3 farthestFrom(const Cells& cells, vec3 color) {
    vec3 farthest = color;
    for (std::size_t i = 0; i < cells.colors.size(); ++i)
        if (cells.weights[i] > 0.0f &&
            glm::distance(cells.colors[i], color) > glm::distance(farthest, color))
            farthest = cells.colors[i];
    return farthest;
}

Means twoMeans(const Cells& cells) {
    constexpr int kRounds = 100;
    vec3 middle(0.0f);
    float all = 0.0f;
    for (std::size_t i = 0; i < cells.colors.size(); ++i) {
        middle += cells.weights[i] * cells.colors[i];
        all += cells.weights[i];
    }
    const vec3 first = farthestFrom(cells, middle / all);
    Means means{first, farthestFrom(cells, first)};
    for (int round = 0; round < kRounds; ++round) {
        Means sums{vec3(0.0f), vec3(0.0f)};
        std::array<float, 2> weights{};
        for (std::size_t i = 0; i < cells.colors.size(); ++i) {
            const std::size_t nearer = nearerOf(means, cells.colors[i]);
            sums[nearer] += cells.weights[i] * cells.colors[i];
            weights[nearer] += cells.weights[i];
        }
        const Means before = means;
        for (std::size_t i = 0; i < means.size(); ++i)
            if (weights[i] > 0.0f) means[i] = sums[i] / weights[i];
        if (means == before) break;
    }
    return means;
}

}  // namespace

std::vector<unsigned char> colorRegions(const Image& photo) {
    constexpr float kSame = 0.02f;  // in Oklab, about what an eye can just tell apart
    std::vector<unsigned char> regions(photo.pixels.size());
    const Cells cells = cellsOf(photo);
    if (std::ranges::none_of(cells.weights, [](float weight) { return weight > 0.0f; }))
        return regions;
    const Means means = twoMeans(cells);
    if (glm::distance(means[0], means[1]) < kSame) return regions;
    std::array<std::size_t, 2> counts{};
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (photo.pixels[i].a <= 0.0f) continue;
        const auto width = static_cast<std::size_t>(photo.size.x);
        const ivec2 pixel(static_cast<int>(i % width), static_cast<int>(i / width));
        regions[i] = static_cast<unsigned char>(nearerOf(means, cells.colorAt(pixel)));
        ++counts[regions[i]];
    }
    if (counts[1] > counts[0])
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (photo.pixels[i].a > 0.0f) regions[i] ^= 1u;
    return regions;
}

}  // namespace pelage
