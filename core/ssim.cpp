// ssim.cpp -- means and variances of small windows.
#include "ssim.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

#include "image_filter.h"
#include "srgb.h"

namespace pelage {

double ssim(const Image& image, const Image& reference) {
    assert(image.size == reference.size && !image.pixels.empty());
    constexpr float kC1 = 0.01f * 0.01f, kC2 = 0.03f * 0.03f;
    const Plane empty{image.size, std::vector<float>(image.pixels.size())};
    Plane a = empty, b = empty, squares = empty, squaredDifference = empty;
    tbb::parallel_for(std::size_t(0), image.pixels.size(), [&](std::size_t i) {
        const auto luma = [](vec4 pixel) {
            return srgbFromLinear(std::clamp(luminance(vec3(pixel)), 0.0f, 1.0f));
        };
        const float x = luma(image.pixels[i]), y = luma(reference.pixels[i]);
        a.values[i] = x;
        b.values[i] = y;
        squares.values[i] = x * x + y * y;
        squaredDifference.values[i] = (x - y) * (x - y);
    });
    const std::vector<float> weights = gaussian(1.5, 5);
    for (Plane* plane : {&a, &b, &squares, &squaredDifference})
        *plane = filterColumns(filterRows(*plane, weights), weights);

    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float x = a.values[i], y = b.values[i];
        const float light = (2.0f * x * y + kC1) / (x * x + y * y + kC1);
        // 2 x covariance = the sum of the variances - the variance of the difference.
        const float variances = std::max(squares.values[i] - x * x - y * y, 0.0f);
        const float ofDifference = std::max(squaredDifference.values[i] - (x - y) * (x - y), 0.0f);
        sum += static_cast<double>(light * (1.0f - ofDifference / (variances + kC2)));
    }
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace pelage
