// image_filter.cpp -- sums of shifted rows, on all cores.
#include "image_filter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace pelage {
namespace {

constexpr int kGrain = 8;  // rows

// out[x] = the sum over i of weights[i] x rows[i][x]: the sums of a block stay in registers.
void sumRows(std::span<const float> weights, std::span<const float* const> rows,
             std::span<float> out) {
    constexpr std::size_t kBlock = 32;
    std::size_t x = 0;
    for (; x + kBlock <= out.size(); x += kBlock) {
        std::array<float, kBlock> sum{};
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const float* row = rows[i] + x;
            for (std::size_t j = 0; j < kBlock; ++j) sum[j] += weights[i] * row[j];
        }
        std::ranges::copy(sum, out.data() + x);
    }
    for (; x < out.size(); ++x) {
        float sum = 0.0f;
        for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * rows[i][x];
        out[x] = sum;
    }
}

// Fills the rows of a plane of `size`: sum(y, row).
template <class Sum>
Plane byRows(ivec2 size, const Sum& sum) {
    Plane result{size, std::vector<float>(pixelCount(size))};
    const auto width = static_cast<std::size_t>(size.x);
    tbb::parallel_for(tbb::blocked_range<int>(0, size.y, kGrain), [&](const auto& range) {
        for (int y = range.begin(); y < range.end(); ++y) {
            sum(y, std::span(result.values).subspan(static_cast<std::size_t>(y) * width, width));
        }
    });
    return result;
}

const float* rowOf(const Plane& plane, int y) {
    return plane.values.data() + pixelCount({plane.size.x, std::clamp(y, 0, plane.size.y - 1)});
}

}  // namespace

std::vector<float> gaussian(double sigma, int radius) {
    std::vector<double> weights;
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
        sum += weights.back();
    }
    std::vector<float> result;
    for (const double weight : weights) result.push_back(static_cast<float>(weight / sum));
    return result;
}

Plane filterRows(const Plane& plane, std::span<const float> weights) {
    assert(weights.size() % 2 == 1);
    const std::size_t radius = weights.size() / 2;
    return byRows(plane.size, [&](int y, std::span<float> out) {
        const float* row = rowOf(plane, y);
        std::vector<float> padded(out.size() + 2 * radius, row[0]);
        std::copy_n(row, out.size(), padded.data() + radius);
        std::fill(padded.end() - static_cast<std::ptrdiff_t>(radius), padded.end(),
                  row[out.size() - 1]);
        std::vector<const float*> rows;
        for (std::size_t i = 0; i < weights.size(); ++i) rows.push_back(padded.data() + i);
        sumRows(weights, rows, out);
    });
}

Plane filterColumns(const Plane& plane, std::span<const float> weights) {
    assert(weights.size() % 2 == 1);
    const int radius = static_cast<int>(weights.size()) / 2;
    return byRows(plane.size, [&](int y, std::span<float> out) {
        std::vector<const float*> rows;
        for (int i = -radius; i <= radius; ++i) rows.push_back(rowOf(plane, y + i));
        sumRows(weights, rows, out);
    });
}

}  // namespace pelage
