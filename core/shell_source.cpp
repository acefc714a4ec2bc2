// shell_source.cpp -- pictures to textures whose levels cover alike, and what is drawn from them.
#include "shell_source.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "photo_regions.h"
#include "pixels.h"
#include "srgb.h"
#include "texel_cover.h"

namespace pelage {
namespace {

constexpr int kLargestShownSide = 1024;

using Texel = ShellTexture::Texel;

std::size_t placeOf(ivec2 size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(x);
}

// The averages of texels under those of the next coarser level, by their area.
template <class Value>
std::vector<Value> halved(ivec2 size, const std::vector<Value>& fine) {
    const ivec2 half = halfSize(size);
    std::vector<Value> coarse(pixelCount(half));
    tbb::parallel_for(0, half.y, [&](int y) {
        const Cover down(y, size.y, half.y);
        for (int x = 0; x < half.x; ++x) {
            const Cover across(x, size.x, half.x);
            Value sum{0.0f};
            float area = 0.0f;
            for (int j = down.first(); j < down.end(); ++j)
                for (int i = across.first(); i < across.end(); ++i) {
                    const auto share = static_cast<float>(across.share(i) * down.share(j));
                    sum += share * fine[placeOf(size, i, j)];
                    area += share;
                }
            coarse[placeOf(half, x, y)] = sum / area;
        }
    });
    return coarse;
}

// What levels average: premultiplied colors with coverage, and how much of it is of region 1.
struct Averages {
    ivec2 size{0};
    std::vector<vec4> colors;
    std::vector<float> second;

    void halve() {
        colors = halved(size, colors);
        second = halved(size, second);
        size = halfSize(size);
    }
};

bool fits(ivec2 size, int side) { return std::max(size.x, size.y) <= side; }

Image fitted(Image image) {
    while (!fits(image.size, kLargestSourceSide)) {
        image.pixels = halved(image.size, image.pixels);
        image.size = halfSize(image.size);
    }
    return image;
}

// The color in another luminance, as far as display colors go in its own saturation.
vec3 inLuminance(vec3 color, float tone) {
    const float own = luminance(color);
    const vec3 scaled = own > 0.0f ? color * (tone / own) : vec3(tone);
    const float most = std::max({scaled.r, scaled.g, scaled.b});
    return most > 1.0f ? tone + (scaled - tone) * ((1.0f - tone) / (most - tone)) : scaled;
}

Texel texelOf(vec3 color, unsigned char alpha) {
    const auto byte = [](float linear) {
        return static_cast<unsigned char>(
            std::lround(255.0f * std::clamp(srgbFromLinear(linear), 0.0f, 1.0f)));
    };
    return {byte(color.r), byte(color.g), byte(color.b), alpha};
}

struct Ranked {
    float tone;
    std::size_t place;
    auto operator<=>(const Ranked&) const = default;
};
using ByRegion = std::array<std::vector<Ranked>, 2>;

// The texels of each region that are covered for the most part, from the darkest.
ByRegion rankedTexels(const Averages& averages) {
    ByRegion ranked;
    for (std::size_t i = 0; i < averages.colors.size(); ++i) {
        const vec4 color = averages.colors[i];
        if (color.a < 0.5f) continue;
        const std::size_t region = averages.second[i] > 0.5f * color.a ? 1 : 0;
        ranked[region].push_back({luminance(vec3(color)) / color.a, i});
    }
    for (std::vector<Ranked>& region : ranked) tbb::parallel_sort(region.begin(), region.end());
    return ranked;
}

// `tones` of all of the photograph.
std::vector<Texel> levelOf(const Averages& averages, const ByRegion& tones) {
    std::vector<Texel> level(averages.colors.size());
    const ByRegion ranked = rankedTexels(averages);
    for (std::size_t region = 0; region < ranked.size(); ++region) {
        const std::size_t n = ranked[region].size(), all = tones[region].size();
        tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
            const vec4 color = averages.colors[ranked[region][i].place];
            const float tone = tones[region][(2 * i + 1) * all / (2 * n)].tone;
            level[ranked[region][i].place] =
                texelOf(inLuminance(vec3(color) / color.a, tone), region == 0 ? 255 : 128);
        });
    }
    return level;
}

}  // namespace

std::size_t ShellTexture::bytes() const {
    std::size_t texels = 0;
    for (const std::vector<Texel>& level : levels) texels += level.size();
    return texels * sizeof(Texel);
}

Image drawnPhoto(Image photo) {
    photo = fitted(std::move(photo));
    Pixels pixels = displayPixels(photo);
    for (std::size_t i = 0; i < photo.pixels.size(); ++i)
        pixels.rgba[4 * i + 3] = photo.pixels[i].a > 0.0f ? 255 : 0;
    return linearImage(pixels);
}

ShellTexture photoTexture(const Image& photo, std::span<const unsigned char> regions) {
    Averages averages{photo.size, photo.pixels, std::vector<float>(photo.pixels.size())};
    for (std::size_t i = 0; i < regions.size(); ++i)
        averages.second[i] = regions[i] == 1 ? photo.pixels[i].a : 0.0f;
    const ByRegion tones = rankedTexels(averages);
    ShellTexture texture{.photo = true, .size = photo.size, .levels = {levelOf(averages, tones)}};
    while (averages.colors.size() > 1) {
        averages.halve();
        texture.levels.push_back(levelOf(averages, tones));
    }
    return texture;
}

ShellTexture heightTexture(const ShellMap& map) {
    static_assert(sizeof(ShellTexel) == sizeof(Texel));
    ShellTexture texture{.size = map.levels.front().size};
    for (const ShellLevel& level : map.levels) {
        std::vector<Texel>& texels = texture.levels.emplace_back();
        for (const ShellTexel& texel : level.texels) texels.push_back(std::bit_cast<Texel>(texel));
    }
    return texture;
}

Plane greyOf(const Image& image) {
    Plane plane{image.size, {}};
    for (const vec4& pixel : image.pixels)
        plane.values.push_back(
            pixel.a > 0.0f ? pixel.a * srgbFromLinear(luminance(vec3(pixel)) / pixel.a) : 0.0f);
    return plane;
}

bool samePicture(const ShellRecipe& a, const ShellRecipe& b) {
    return a.from == b.from && a.file == b.file && a.photo.twoColors == b.photo.twoColors &&
           a.noise == b.noise;
}

ShellPicture photoPicture(std::shared_ptr<const ShellTexture> texture) {
    ShellPicture picture;
    ivec2 size = texture->size;
    std::size_t level = 0;
    for (; !fits(size, kLargestShownSide); ++level) size = halfSize(size);
    Pixels pixels{size, {}};
    pixels.rgba.reserve(4 * pixelCount(size));
    picture.regions.reserve(pixelCount(size));
    for (const Texel& texel : texture->levels[level]) {
        pixels.rgba.insert(pixels.rgba.end(), texel.begin(), texel.begin() + 3);
        pixels.rgba.push_back(texel[3] > 0 ? 255 : 0);
        picture.regions.push_back(texel[3] == 128 ? 1 : 0);
    }
    picture.photo = linearImage(pixels);
    picture.texture = std::move(texture);
    return picture;
}

std::string halvedText(const ShellTexture& texture) {
    if (fits(texture.fileSize, kLargestSourceSide)) return {};
    return sizeText(texture.fileSize) + " pixels are drawn as " + sizeText(texture.size);
}

ShellPicture shellPicture(const ShellRecipe& recipe, Progress* progress) {
    assert(recipe.from != ShellRecipe::From::hairs);
    const auto report = [&](float done) {
        if (progress) progress->report(done);
    };
    ivec2 fileSize(0);
    const auto shared = [&](ShellTexture texture) {
        texture.fileSize = fileSize;
        return std::make_shared<const ShellTexture>(std::move(texture));
    };
    constexpr ShellCut kRanks{.coverage = 1.0f, .taper = 1.0f};
    const uint seed = recipe.noise.seed;
    if (recipe.from == ShellRecipe::From::noise)
        return {.texture =
                    shared(heightTexture(rankedMap(noisePicture(recipe.noise), kRanks, seed)))};
    Image image = readImage(recipe.file);
    report(0.3f);
    fileSize = image.size;
    if (recipe.from == ShellRecipe::From::picture) {
        const Plane grey = greyOf(fitted(std::move(image)));
        report(0.4f);
        return {.texture = shared(heightTexture(rankedMap(grey, kRanks, seed)))};
    }
    image = drawnPhoto(std::move(image));
    report(0.6f);
    if (std::ranges::none_of(image.pixels, [](vec4 pixel) { return pixel.a > 0.0f; }))
        throw std::runtime_error(recipe.file + ": all of " + sizeText(fileSize) +
                                 " pixels are transparent");
    ShellPicture picture = photoPicture(shared(photoTexture(
        image, recipe.photo.twoColors ? colorRegions(image) : std::vector<unsigned char>())));
    report(1.0f);
    return picture;
}

PhotoLayers photoLayers(const ShellPicture& picture, const PhotoOptions& options) {
    return photoLayers(picture.photo, options, picture.regions);
}

ShellSource shellSource(const ShellPicture& picture, const ShellRecipe& recipe,
                        const PhotoLayers& layers, float skinSize) {
    ShellSource source;
    source.texture = picture.texture;
    source.layers = static_cast<uint>(recipe.photo.layers);
    source.cut = recipe.cut;
    source.gap = recipe.gap;
    source.side = recipe.side > 0.0f ? recipe.side : 0.2f * skinSize;
    for (std::size_t i = 0; i < layers.regions.size(); ++i)
        if (layers.regions[i].low < layers.regions[i].high)
            source.tones[i] = {layers.regions[i].low, layers.regions[i].high};
    return source;
}

ShellSource shellSource(const ShellPicture& picture, const ShellRecipe& recipe, float skinSize) {
    const PhotoLayers layers = recipe.from == ShellRecipe::From::photo
                                   ? photoLayers(picture, recipe.photo)
                                   : PhotoLayers{};
    return shellSource(picture, recipe, layers, skinSize);
}

}  // namespace pelage
