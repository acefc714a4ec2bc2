// flip.cpp -- what an eye makes of colors, edges and points, and how far two of these are apart.
#include "flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "image_filter.h"

namespace pelage {
namespace {

constexpr double kPixelsPerDegree = 3840.0 * std::numbers::pi / 180.0;

// Between linear RGB and XYZ as a share of white's.
struct Space {
    mat3 fromRgb, toRgb;
    float farthest;  // the largest difference of colors: of green and blue
};

// Lightness first. As Hunt found, dark colors look less colorful.
vec3 huntLab(vec3 xyz) {
    const auto response = [](float t) {
        constexpr float kKnee = 6.0f / 29.0f;
        return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3.0f * kKnee * kKnee) + 4.0f / 29.0f;
    };
    const vec3 f(response(xyz.x), response(xyz.y), response(xyz.z));
    const float lightness = 116.0f * f.y - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (f.x - f.y),
            0.01f * lightness * 200.0f * (f.y - f.z)};
}

float colorDistance(vec3 a, vec3 b) {
    const vec3 d = a - b;
    return std::pow(std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z), 0.7f);
}

Space makeSpace() {
    const glm::dvec3 x = glm::dvec3(10135552.0, 8788810.0, 4435075.0) / 24577794.0 / 0.950428545;
    const glm::dvec3 y = glm::dvec3(2613072.0, 8788810.0, 887015.0) / 12288897.0;
    const glm::dvec3 z = glm::dvec3(1425312.0, 8788810.0, 70074185.0) / 73733382.0 / 1.088900371;
    const glm::dmat3 fromRgb = glm::transpose(glm::dmat3(x, y, z));
    const mat3 rounded(fromRgb);
    return {rounded, mat3(glm::inverse(fromRgb)),
            colorDistance(huntLab(rounded * vec3(0, 1, 0)), huntLab(rounded * vec3(0, 0, 1)))};
}

const Space& space() {
    static const Space made = makeSpace();
    return made;
}

// Large differences of color are all alike: the upper 60 % of their range are the last 5 %.
float colorError(vec3 a, vec3 b) {
    const float farthest = space().farthest, knee = 0.4f * farthest;
    const float distance = colorDistance(a, b);
    if (distance < knee) return 0.95f * distance / knee;
    return std::min(0.95f + 0.05f * (distance - knee) / (farthest - knee), 1.0f);
}

// Luminance, red against green, and blue against yellow, linear in the light.
struct Opponents {
    Plane y, xy, yz;
};

Opponents opponentsOf(const Image& image) {
    const std::size_t count = image.pixels.size();
    const Plane empty{image.size, std::vector<float>(count)};
    Opponents result{empty, empty, empty};
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        const vec3 xyz =
            space().fromRgb * glm::clamp(vec3(image.pixels[i]), vec3(0.0f), vec3(1.0f));
        result.y.values[i] = xyz.y;
        result.xy.values[i] = xyz.x - xyz.y;
        result.yz.values[i] = xyz.y - xyz.z;
    });
    return result;
}

// A Gaussian of the eye's contrast sensitivity, amplitude x sqrt(pi / width) exp(-(pi x)^2 / width)
// with x in degrees.
struct Sensitivity {
    double amplitude, width;

    std::vector<float> weights() const {
        constexpr double kWidest = 0.04;
        return gaussian(sigma(width), static_cast<int>(std::ceil(3.0 * sigma(kWidest))));
    }
    // What it sums to over the picture; the factor sqrt(pi / width) stands once for both axes.
    double sum() const {
        const std::vector<float> axisWeights = weights();
        const double axis = 1.0 / static_cast<double>(axisWeights[axisWeights.size() / 2]);
        return amplitude * std::sqrt(std::numbers::pi / width) * axis * axis;
    }

private:
    static double sigma(double width) {  // pixels
        return std::sqrt(0.5 * width) / std::numbers::pi * kPixelsPerDegree;
    }
};

Plane blurred(const Plane& plane, const Sensitivity& sensitivity) {
    const std::vector<float> weights = sensitivity.weights();
    return filterColumns(filterRows(plane, weights), weights);
}

// The colors that are left when detail too fine for the eye is gone.
std::vector<vec3> perceivedColors(const Opponents& opponents) {
    constexpr Sensitivity kLight{1.0, 0.0047}, kRedGreen{1.0, 0.0053};
    constexpr Sensitivity kBlueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};
    const Plane y = blurred(opponents.y, kLight), xy = blurred(opponents.xy, kRedGreen);
    const Plane wide = blurred(opponents.yz, kBlueYellow[0]);
    const Plane narrow = blurred(opponents.yz, kBlueYellow[1]);
    const auto share =
        static_cast<float>(kBlueYellow[0].sum() / (kBlueYellow[0].sum() + kBlueYellow[1].sum()));
    std::vector<vec3> colors(y.values.size());
    tbb::parallel_for(std::size_t(0), colors.size(), [&](std::size_t i) {
        const float yz = share * wide.values[i] + (1.0f - share) * narrow.values[i];
        const vec3 xyz(y.values[i] + xy.values[i], y.values[i], y.values[i] - yz);
        const vec3 rgb = glm::clamp(space().toRgb * xyz, vec3(0.0f), vec3(1.0f));
        colors[i] = huntLab(space().fromRgb * rgb);
    });
    return colors;
}

// The positive weights sum to 1, the negative ones to -1.
std::vector<float> balanced(const std::vector<double>& weights) {
    double sums[2] = {0.0, 0.0};
    for (const double weight : weights) sums[weight > 0.0] += std::abs(weight);
    std::vector<float> result;
    for (const double weight : weights)
        result.push_back(static_cast<float>(weight / sums[weight > 0.0]));
    return result;
}

// How strong the edge and the point (or line) at each pixel is.
struct Features {
    Plane edges, points;
};

Features featuresOf(const Plane& y) {
    constexpr double kWidth = 0.082;  // degrees, of the features that an eye finds
    const double sigma = 0.5 * kWidth * kPixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<double> slope, bend;
    for (int x = -radius; x <= radius; ++x) {
        const double t = x / sigma, bell = std::exp(-0.5 * t * t);
        slope.push_back(-t * bell);
        bend.push_back((t * t - 1.0) * bell);
    }
    const std::vector<float> across = gaussian(sigma, radius);
    const auto strength = [&](const std::vector<float>& along) {
        Plane horizontal = filterColumns(filterRows(y, along), across);
        const Plane vertical = filterColumns(filterRows(y, across), along);
        for (std::size_t i = 0; i < y.values.size(); ++i) {
            float& h = horizontal.values[i];
            const float v = vertical.values[i];
            h = std::sqrt(h * h + v * v);
        }
        return horizontal;
    };
    return {strength(balanced(slope)), strength(balanced(bend))};
}

struct Perceived {
    std::vector<vec3> colors;
    Features features;
};

Perceived perceived(const Image& image) {
    const Opponents opponents = opponentsOf(image);
    return {perceivedColors(opponents), featuresOf(opponents.y)};
}

}  // namespace

Plane flip(const Image& image, const Image& reference) {
    assert(image.size == reference.size && !image.pixels.empty());
    const Perceived a = perceived(image), b = perceived(reference);
    Plane result{image.size, std::vector<float>(image.pixels.size())};
    tbb::parallel_for(std::size_t(0), result.values.size(), [&](std::size_t i) {
        const auto difference = [i](const Plane& p, const Plane& q) {
            return std::abs(p.values[i] - q.values[i]);
        };
        const float feature = std::max(difference(a.features.edges, b.features.edges),
                                       difference(a.features.points, b.features.points));
        const float featureError = std::sqrt(feature / std::numbers::sqrt2_v<float>);
        result.values[i] = std::pow(colorError(a.colors[i], b.colors[i]), 1.0f - featureError);
    });
    return result;
}

}  // namespace pelage
