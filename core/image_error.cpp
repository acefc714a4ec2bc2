// image_error.cpp -- sums over pixels, and what flip and ssim say.
#include "image_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "flip.h"
#include "pixels.h"
#include "ssim.h"

namespace pelage {
namespace {

void check(const Image& image, const std::string& name) {
    if (image.size.x < 1 || image.size.y < 1) throw std::runtime_error(name + " has no pixels");
    assert(image.pixels.size() == pixelCount(image.size));
    const auto finite = [](vec4 p) {
        return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.a);
    };
    const auto bad = std::ranges::find_if_not(image.pixels, finite);
    if (bad == image.pixels.end()) return;
    const auto place = bad - image.pixels.begin();
    throw std::runtime_error("pixel " + std::to_string(place % image.size.x) + ", " +
                             std::to_string(place / image.size.x) + " of " + name +
                             " is not finite");
}

double ratio(double value, double reference) {
    if (reference != 0.0) return value / reference;
    return value == 0.0 ? 1.0 : std::numeric_limits<double>::infinity();
}

double coverageOf(vec4 pixel) { return static_cast<double>(std::clamp(pixel.a, 0.0f, 1.0f)); }

CoverageErrors coverageErrors(const Image& image, const Image& reference) {
    constexpr double kHalfStep = 0.5 / 65535.0;
    double area = 0.0, referenceArea = 0.0, either = 0.0, notBoth = 0.0;
    double bias = 0.0, square = 0.0;
    std::size_t band = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double a = coverageOf(image.pixels[i]), b = coverageOf(reference.pixels[i]);
        area += a;
        referenceArea += b;
        either += std::max(a, b);
        notBoth += std::abs(a - b);
        if (b <= kHalfStep || b >= 1.0 - kHalfStep) continue;
        ++band;
        bias += a - b;
        square += (a - b) * (a - b);
    }
    const double count = static_cast<double>(std::max<std::size_t>(band, 1));
    return {band, bias / count, std::sqrt(square / count), ratio(area, referenceArea),
            either > 0.0 ? notBoth / either : 0.0};
}

bool isOpaque(const Image& image) {
    return std::ranges::all_of(image.pixels, [](vec4 p) { return p.a >= 1.0f; });
}

// The smallest value that at least `share` of the values do not exceed.
double percentile(std::vector<float> values, double share) {
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(values.begin(), at, values.end());
    return static_cast<double>(*at);
}

}  // namespace

ImageErrors imageErrors(const Image& image, const Image& reference) {
    check(image, "the picture");
    check(reference, "the reference");
    if (image.size != reference.size) {
        throw std::runtime_error(sizeText(image.size) + " pixels, the reference has " +
                                 sizeText(reference.size));
    }
    double squares = 0.0, light = 0.0, referenceLight = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const vec3 a(image.pixels[i]), b(reference.pixels[i]);
        const glm::dvec3 difference = glm::dvec3(a) - glm::dvec3(b);
        squares += glm::dot(difference, difference);
        light += static_cast<double>(luminance(a));
        referenceLight += static_cast<double>(luminance(b));
    }
    ImageErrors errors{};
    errors.rmse = std::sqrt(squares / (3.0 * static_cast<double>(image.pixels.size())));
    errors.luminanceBias = ratio(light, referenceLight) - 1.0;
    errors.flipMap = flip(image, reference);
    errors.flipMean = meanOf(errors.flipMap);
    errors.flip99 = percentile(errors.flipMap.values, 0.99);
    errors.ssim = ssim(image, reference);
    if (!isOpaque(image) || !isOpaque(reference))
        errors.coverage = coverageErrors(image, reference);
    return errors;
}

}  // namespace pelage
