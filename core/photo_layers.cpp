// photo_layers.cpp -- tones to thresholds, and pixels to layers by them.
#include "photo_layers.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "photo_regions.h"
#include "srgb.h"

namespace pelage {
namespace {

float luminanceOf(vec4 pixel) { return luminance(vec3(pixel)) / pixel.a; }

// Luminances of the pixels of one region, from the darkest.
using Tones = std::vector<float>;

float toneAt(const Tones& tones, float share) {
    const auto last = static_cast<double>(tones.size() - 1);
    return tones[static_cast<std::size_t>(std::lround(static_cast<double>(share) * last))];
}

// Thresholds that so many tones of equal number lie between.
std::vector<float> evenThresholds(const Tones& tones, int layers) {
    const auto n = static_cast<std::size_t>(layers);
    std::vector<float> thresholds;
    for (std::size_t k = 1; k <= n; ++k)
        thresholds.push_back(tones[tones.size() - (k * tones.size() + n - 1) / n]);
    return thresholds;
}

// Finds the range and the thresholds.
void measure(PhotoRegion& region, const Tones& tones, const PhotoOptions& options) {
    const float step = linearFromSrgb(1.0f / 255.0f);
    region.high = toneAt(tones, options.brightest);
    region.low = std::min(std::max(toneAt(tones, options.darkest), step), region.high);
    if (options.uniform) {
        region.thresholds = evenThresholds(tones, options.layers);
    } else if (region.low < region.high) {
        region.thresholds = layerThresholds(region.low, region.high, options.layers);
    } else {  // all tones reach the first
        region.thresholds.assign(static_cast<std::size_t>(options.layers), 0.0f);
    }
}

std::string plural(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string rounded(float number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", static_cast<double>(number));
    return text;
}

void warn(PhotoLayers& layers, const std::vector<Tones>& tones, const PhotoOptions& options) {
    for (std::size_t i = 0; i < layers.regions.size(); ++i) {
        const PhotoRegion& region = layers.regions[i];
        const bool flat =
            options.uniform ? tones[i].front() == tones[i].back() : !(region.low < region.high);
        if (flat)
            layers.warnings.push_back("the luminance is " + rounded(region.high) +
                                      " nearly everywhere: " + plural(region.pixels, "pixel") +
                                      " in layer 1");
    }
    if (options.twoColors && layers.regions.size() == 1)
        layers.warnings.push_back("there are no two colors to tell apart");
    const auto empty = static_cast<std::size_t>(std::ranges::count(layers.populations, 0u));
    if (empty == 0 || !layers.warnings.empty()) return;
    std::string text = std::to_string(empty) + " of " + plural(layers.populations.size(), "layer") +
                       (empty == 1 ? " holds" : " hold") + " no pixel";
    int told = kMostLayers;
    for (std::size_t i = 0; !options.uniform && i < tones.size(); ++i) {
        const float low = layers.regions[i].low;
        const float next = *std::ranges::upper_bound(tones[i], low);
        told = std::min(told, layersToldApart(low, layers.regions[i].high, next - low));
    }
    if (told < options.layers)
        text += ": the darkest tones tell " + plural(static_cast<std::size_t>(told), "layer") +
                " apart";
    layers.warnings.push_back(text);
}

}  // namespace

std::vector<float> layerThresholds(float low, float high, int layers) {
    assert(low > 0.0f && low <= high && layers >= 1);
    const double ratio = std::log(static_cast<double>(low) / static_cast<double>(high));
    std::vector<float> thresholds;
    for (int k = 1; k < layers; ++k)
        thresholds.push_back(
            static_cast<float>(static_cast<double>(high) * std::exp(ratio * k / layers)));
    thresholds.push_back(low);
    return thresholds;
}

int layerOf(float intensity, std::span<const float> thresholds) {
    const auto reached = std::ranges::lower_bound(thresholds, intensity, std::greater<>());
    const auto before = static_cast<std::size_t>(reached - thresholds.begin());
    return static_cast<int>(std::min(before + 1, thresholds.size()));
}

double extinction(float low, float high, double thickness) {
    return std::log(static_cast<double>(high) / static_cast<double>(low)) / thickness;
}

int layersToldApart(float low, float high, float step) {
    const double most = std::log(static_cast<double>(high) / static_cast<double>(low)) /
                        std::log1p(static_cast<double>(step) / static_cast<double>(low));
    return static_cast<int>(std::clamp(most, 1.0, static_cast<double>(kMostLayers)));
}

double entropy(std::span<const std::size_t> counts) {
    double all = 0.0, sum = 0.0;
    for (const std::size_t count : counts) all += static_cast<double>(count);
    for (const std::size_t count : counts) {
        const double share = static_cast<double>(count) / all;
        if (count > 0) sum -= share * std::log2(share);
    }
    return sum;
}

PhotoLayers photoLayers(const Image& photo, const PhotoOptions& options) {
    return photoLayers(photo, options,
                       options.twoColors ? colorRegions(photo) : std::vector<unsigned char>());
}

PhotoLayers photoLayers(const Image& photo, const PhotoOptions& options,
                        std::span<const unsigned char> regions) {
    assert(options.layers >= 1 && options.layers <= kMostLayers);
    assert(0.0f <= options.darkest && options.darkest < options.brightest &&
           options.brightest <= 1.0f);
    PhotoLayers layers;
    layers.size = photo.size;
    layers.layers = options.layers;
    std::vector<unsigned char> regionOf(regions.begin(), regions.end());
    regionOf.resize(photo.pixels.size());
    const std::size_t regionCount = std::ranges::count(regionOf, 1) > 0 ? 2 : 1;
    layers.regions.resize(regionCount);
    std::vector<Tones> tones(regionCount);
    std::vector<glm::dvec3> colors(regionCount, glm::dvec3(0.0));
    for (std::size_t i = 0; i < photo.pixels.size(); ++i) {
        if (photo.pixels[i].a <= 0.0f) continue;
        const float tone = luminanceOf(photo.pixels[i]);
        tones[regionOf[i]].push_back(tone);
        colors[regionOf[i]] += vec3(photo.pixels[i]) / photo.pixels[i].a;
        const float encoded = std::clamp(srgbFromLinear(tone), 0.0f, 1.0f);
        ++layers.histogram[static_cast<std::size_t>(std::lround(255.0f * encoded))];
    }
    if (tones[0].empty())
        throw std::runtime_error("all of " + std::to_string(photo.size.x) + "x" +
                                 std::to_string(photo.size.y) + " pixels are transparent");
    for (std::size_t i = 0; i < regionCount; ++i) {
        tbb::parallel_sort(tones[i].begin(), tones[i].end());
        layers.regions[i].pixels = tones[i].size();
        layers.regions[i].color = colors[i] / static_cast<double>(tones[i].size());
        measure(layers.regions[i], tones[i], options);
    }

    layers.populations.resize(static_cast<std::size_t>(options.layers));
    layers.layerOfPixel.resize(photo.pixels.size());
    for (std::size_t i = 0; i < photo.pixels.size(); ++i) {
        if (photo.pixels[i].a <= 0.0f) continue;
        const int k = layerOf(luminanceOf(photo.pixels[i]), layers.regions[regionOf[i]].thresholds);
        layers.layerOfPixel[i] = static_cast<std::uint16_t>(k);
        ++layers.populations[static_cast<std::size_t>(k - 1)];
    }
    layers.bits = entropy(layers.populations);
    warn(layers, tones, options);
    return layers;
}

std::vector<unsigned char> layerPicture(std::span<const unsigned char> photo,
                                        const PhotoLayers& layers, int k, bool cumulative) {
    assert(photo.size() == 4 * layers.layerOfPixel.size());
    std::vector<unsigned char> picture(photo.size());
    for (std::size_t i = 0; i < layers.layerOfPixel.size(); ++i) {
        const int layer = layers.layerOfPixel[i];
        if (layer == k || (cumulative && layer > 0 && layer < k))
            std::copy_n(photo.begin() + static_cast<std::ptrdiff_t>(4 * i), 4,
                        picture.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    return picture;
}

}  // namespace pelage
