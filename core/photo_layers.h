// photo_layers.h -- layers of fur from one photograph: what is bright lies high, what is dark deep.
//
// After Ukaji, Kosaka, Hattori, Kubo and Morishima, "Acquiring Shell Textures from a Single Image
// for Realistic Fur Rendering": light that enters fur dies away by I = high exp(-extinction depth),
// so that the luminance of a pixel tells how deep it lies. Luminance is linear. Layer 1 is the
// outermost, the last one lies on the skin.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "image.h"

namespace pelage {

inline constexpr int kMostLayers = 256;

// p(k) = high (low/high)^(k/layers) for k = 1 to layers; the last is `low`. 0 < low <= high.
std::vector<float> layerThresholds(float low, float high, int layers);

// The first layer whose threshold the luminance reaches, the last where it reaches none; so
// p(k) <= I < p(k-1). With the thresholds above it is what a shader finds without a table:
// clamp(ceil(layers ln(high/I) / ln(high/low)), 1, layers).
int layerOf(float intensity, std::span<const float> thresholds);

// Per unit of thickness of the fur, > 0 where high > low > 0.
double extinction(float low, float high, double thickness);

// So many layers at most are told apart by tones that are `step` apart where they are darkest: with
// more, the darkest layers are narrower than a step.
int layersToldApart(float low, float high, float step);

// Of shares of a whole, in bits; 0 for counts that are all 0.
double entropy(std::span<const std::size_t> counts);

struct PhotoOptions {
    int layers = 16;          // 1 to kMostLayers
    float darkest = 0.01f;    // share of the pixels below `low`,
    float brightest = 0.99f;  // and below `high`: outliers do not count
    bool uniform = false;     // as many pixels in each layer as in any other
    bool twoColors = false;   // as colorRegions has them, each with a range of its own

    bool operator==(const PhotoOptions&) const = default;
};

// Fur of one color.
struct PhotoRegion {
    std::size_t pixels = 0;
    vec3 color{0.0f};               // mean, linear RGB
    float low = 0.0f, high = 0.0f;  // luminance; `low` is at least one step of 8 bits
    std::vector<float> thresholds;  // of its layers, from the outermost
};

struct PhotoLayers {
    ivec2 size{0};
    int layers = 0;
    std::vector<std::uint16_t> layerOfPixel;   // from 1; 0 where the photograph is transparent
    std::vector<PhotoRegion> regions;          // one, or two with pixels in each
    std::vector<std::size_t> populations;      // pixels of each layer, from the outermost
    std::array<std::size_t, 256> histogram{};  // pixels by display-encoded luminance, rounded
    double bits = 0.0;                         // entropy of the populations
    std::vector<std::string> warnings;
};

// Every pixel that is not transparent is in exactly one layer. A region of one luminance lies in
// layer 1 as a whole. That, two colors asked for where there is one, and layers without pixels are
// warned of. Throws std::runtime_error "all of 8x8 pixels are transparent".
PhotoLayers photoLayers(const Image& photo, const PhotoOptions& options);
// With the regions of its pixels, 0 or 1, found before; none = all of region 0.
PhotoLayers photoLayers(const Image& photo, const PhotoOptions& options,
                        std::span<const unsigned char> regions);

// The photograph where it is in layer k, and transparent elsewhere; `cumulative`: where it is in
// any of the layers 1 to k, so that hairs are columns. `photo` is RGBA8 of the same size.
std::vector<unsigned char> layerPicture(std::span<const unsigned char> photo,
                                        const PhotoLayers& layers, int k, bool cumulative);

// The histogram with the thresholds of the layers as lines, of each region in a color of its own:
// one SVG document.
std::string histogramSvg(const PhotoLayers& layers, const std::string& title);

}  // namespace pelage
