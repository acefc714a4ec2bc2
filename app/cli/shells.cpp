// shells.cpp -- pelage shells: the layers of fur that a photograph, noise, hairs or a picture make.
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/cli/cli.h"
#include "app/cli/print.h"
#include "app/cli/shell_options.h"
#include "core/files.h"
#include "core/pixels.h"
#include "core/shell_source.h"

namespace pelage {
namespace {

constexpr std::size_t kTexelBytes = 4;  // of an RGBA8 photograph, and of a ShellTexel

struct Options {
    std::string photo, image;  // empty = none
    bool noise = false;
    uint hairs = 0;  // 0 = none
    std::string folder;
    int layers = 16;
    bool uniform = false, cumulative = false, twoColors = false, raw = false, box = false;
    std::vector<double> clamp = {1.0, 99.0};  // percent of the pixels
    NoisePattern pattern;                     // with the side and seed of all maps
    ShellCut cut;
    float radius = HairPattern{}.radius;
};

// Files by their names in the folder. All are made before the first is written.
struct Files {
    std::vector<std::pair<std::string, std::vector<std::byte>>> files;

    void add(const std::string& name, std::vector<std::byte> bytes) {
        files.emplace_back(name, std::move(bytes));
    }
    void write(const std::string& folder) const {
        makeFolder(folder);
        for (const auto& [name, bytes] : files) writeFileAtomically(folder + "/" + name, bytes);
    }
};

std::string layerName(int k, int layers) {
    const int digits = layers > 99 ? 3 : 2;
    char name[32];
    std::snprintf(name, sizeof name, "layer-%0*d.png", digits, k);
    return name;
}

template <class... Values>
std::string format(const char* how, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, how, values...);
    return text;
}

// Of one texture; with all its levels; of one texture for each layer.
OrderedJson memoryOf(ivec2 size, int layers) {
    const std::size_t one = kTexelBytes * pixelCount(size);
    return {{"textureBytes", one},
            {"textureBytesWithMips", kTexelBytes * texelsWithLevels(size)},
            {"storedLayersBytes", static_cast<std::size_t>(layers) * one}};
}

std::string writtenText(const std::string& folder, const Files& files) {
    return "wrote " + std::to_string(files.files.size()) + " files to " + folder + "\n";
}

OrderedJson jsonOf(const PhotoRegion& region) {
    OrderedJson thresholds = OrderedJson::array();
    for (const float threshold : region.thresholds) thresholds.push_back(threshold);
    const bool flat = !(region.low < region.high);
    return {{"pixels", region.pixels},
            {"color", {region.color.r, region.color.g, region.color.b}},
            {"low", region.low},
            {"high", region.high},
            {"extinctionTimesThickness", flat ? 0.0 : extinction(region.low, region.high, 1.0)},
            {"thresholds", thresholds}};
}

OrderedJson jsonOf(const Options& options, const PhotoLayers& layers) {
    OrderedJson regions = OrderedJson::array();
    for (const PhotoRegion& region : layers.regions) regions.push_back(jsonOf(region));
    OrderedJson result = {{"photo", options.photo},
                          {"width", layers.size.x},
                          {"height", layers.size.y},
                          {"layers", layers.layers},
                          {"uniform", options.uniform},
                          {"cumulative", options.cumulative},
                          {"clamp", options.clamp},
                          {"regions", regions},
                          {"populations", layers.populations},
                          {"entropy", layers.bits},
                          {"entropyAtMost", std::log2(static_cast<double>(layers.layers))}};
    result.update(memoryOf(layers.size, layers.layers));
    result["warnings"] = layers.warnings;
    result["output"] = options.folder;
    return result;
}

std::string textOf(const Options& options, const PhotoLayers& layers) {
    std::string text = options.photo + format(": %dx%d pixels, %d layers\n", layers.size.x,
                                              layers.size.y, layers.layers);
    std::size_t all = 0;
    for (const PhotoRegion& region : layers.regions) {
        text += format("  luminance %.4g to %.4g of %zu pixels", static_cast<double>(region.low),
                       static_cast<double>(region.high), region.pixels);
        if (region.low < region.high)
            text +=
                format(", extinction %.3g / thickness", extinction(region.low, region.high, 1.0));
        text += "\n";
        all += region.pixels;
    }
    for (std::size_t k = 0; k < layers.populations.size(); ++k) {
        text += format("  layer %3zu  from luminance", k + 1);
        for (const PhotoRegion& region : layers.regions)
            text += format(" %9.6f", static_cast<double>(region.thresholds[k]));
        text +=
            format("  %9zu pixels, %5.1f %%\n", layers.populations[k],
                   100.0 * static_cast<double>(layers.populations[k]) / static_cast<double>(all));
    }
    text += format("entropy %.2f of %.2f bits\n", layers.bits,
                   std::log2(static_cast<double>(layers.layers)));
    text += memoryText(layers.size, layers.layers);
    for (const std::string& warning : layers.warnings) text += "warning: " + warning + "\n";
    return text;
}

PhotoLayers layersOf(const Image& photo, const Options& options) {
    PhotoOptions wanted;
    wanted.layers = options.layers;
    wanted.darkest = static_cast<float>(options.clamp[0] / 100.0);
    wanted.brightest = static_cast<float>(options.clamp[1] / 100.0);
    wanted.uniform = options.uniform;
    wanted.twoColors = options.twoColors;
    try {
        return photoLayers(photo, wanted);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(options.photo + ": " + error.what());
    }
}

void writePhoto(const Options& options, bool json) {
    expectRising("shells --clamp", options.clamp);
    Image photo = readImage(options.photo);
    const PhotoLayers layers = layersOf(photo, options);
    const Pixels pixels = displayPixels(photo);
    photo = {};
    Files files;
    for (int k = 1; k <= layers.layers; ++k)
        files.add(
            layerName(k, layers.layers),
            encodePng(layers.size, 4, layerPicture(pixels.rgba, layers, k, options.cumulative)));
    const std::string svg = histogramSvg(layers, options.photo);
    const auto bytes = std::as_bytes(std::span(svg));
    files.add("histogram.svg", {bytes.begin(), bytes.end()});
    files.write(options.folder);
    if (json) {
        printJson(jsonOf(options, layers));
    } else {
        print(textOf(options, layers) + writtenText(options.folder, files));
    }
}

ShellMap mapOf(const Options& options) {
    const NoisePattern& pattern = options.pattern;
    if (options.noise) return rankedMap(noisePicture(pattern), options.cut, pattern.seed);
    if (options.hairs > 0)
        return hairMap({.seed = pattern.seed,
                        .side = pattern.side,
                        .hairs = options.hairs,
                        .radius = options.radius,
                        .taper = options.cut.taper});
    const Plane picture = greyOf(readImage(options.image));
    return options.raw ? rawMap(picture, pattern.seed)
                       : rankedMap(picture, options.cut, pattern.seed);
}

// One channel of the tile as grey.
std::vector<std::byte> greyPng(const ShellLevel& tile, std::uint16_t ShellTexel::*channel) {
    std::vector<unsigned char> grey;
    for (const ShellTexel& texel : tile.texels)
        grey.push_back(static_cast<unsigned char>(texel.*channel / 257));
    return encodePng(tile.size, 1, grey);
}

// White where there is hair at the height t, else transparent.
std::vector<std::byte> opacityPng(const ShellLevel& tile, float t) {
    std::vector<unsigned char> rgba;
    for (const ShellTexel& texel : tile.texels)
        rgba.insert(rgba.end(), 4, reaches(texel, t) ? 255 : 0);
    return encodePng(tile.size, 4, rgba);
}

void writeMap(const Options& options, bool json) {
    const ShellMap map = mapOf(options);
    const ShellLevel& tile = map.levels.front();
    Files files;
    OrderedJson layers = OrderedJson::array();
    std::string text =
        format("%dx%d texels, %d layers\n", tile.size.x, tile.size.y, options.layers);
    for (int k = 1; k <= options.layers; ++k) {
        const float t = 1.0f - (static_cast<float>(k) - 0.5f) / static_cast<float>(options.layers);
        const double covered = coverage(tile, t);
        const std::string name = layerName(k, options.layers);
        files.add(name, opacityPng(tile, t));
        layers.push_back({{"file", name}, {"height", t}, {"coverage", covered}});
        text += format("  layer %3d  at %.4f of the length, covers %.4f\n", k,
                       static_cast<double>(t), covered);
    }
    files.add("heights.png", greyPng(tile, &ShellTexel::height));
    files.add("ids.png", greyPng(tile, &ShellTexel::id));
    files.write(options.folder);
    if (json) {
        OrderedJson result = {{"width", tile.size.x}, {"height", tile.size.y}, {"layers", layers}};
        result.update(memoryOf(tile.size, options.layers));
        result["output"] = options.folder;
        printJson(result);
    } else {
        print(text + memoryText(tile.size, options.layers) + writtenText(options.folder, files));
    }
}

void addPhotoOptions(CLI::App& verb, Options& options, CLI::Option& photo) {
    const std::string group = "Of a photograph";
    verb.add_flag("--uniform", options.uniform, "As many pixels in each layer as in any other")
        ->needs(&photo)
        ->group(group);
    verb.add_flag("--cumulative", options.cumulative,
                  "Each layer also holds what is in those outside it, so that hairs are columns")
        ->needs(&photo)
        ->group(group);
    addClampOption(verb, "--clamp", options.clamp)->needs(&photo)->group(group);
    verb.add_flag("--two-colors", options.twoColors, "A range of tones for each color of the fur")
        ->needs(&photo)
        ->group(group);
}

void addMapOptions(CLI::App& verb, Options& options) {
    const std::string group = "Of the others";
    verb.add_option("--side", options.pattern.side, "Texels of the noise and of hairs")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 8192))
        ->group(group);
    verb.add_option("--mask", options.pattern.mask, "Texels of the mask that averages noise")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::IsMember({1, 3, 5, 7, 9}))
        ->group(group);
    verb.add_flag("--box", options.box, "All weights of that mask alike")->group(group);
    verb.add_option("--coverage", options.cut.coverage, "Of the skin, of noise and pictures")
        ->capture_default_str()
        ->check(CLI::Range(0.001, 1.0))
        ->group(group);
    verb.add_option("--taper", options.cut.taper, "1 = hairs end in points")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1.0))
        ->group(group);
    verb.add_option("--radius", options.radius, "Of hairs at the root, as a share of the tile")
        ->capture_default_str()
        ->check(CLI::Range(0.0001, 0.5))
        ->group(group);
    verb.add_flag("--raw", options.raw,
                  "The values of the picture are heights, not only their order")
        ->group(group);
    verb.add_option("--seed", options.pattern.seed, "Of the chance")
        ->type_name("N")
        ->capture_default_str()
        ->group(group);
}

}  // namespace

void addShells(CLI::App& app, bool& json) {
    CLI::App* verb =
        app.add_subcommand("shells", "Write the layers that fur is drawn with as pictures");
    const auto options = std::make_shared<Options>();
    CLI::Option_group* source = verb->add_option_group("Source", "One of these");
    CLI::Option* photo =
        source->add_option("--photo", options->photo, "A photograph of fur, seen from above")
            ->type_name("P.png");
    source->add_flag("--noise", options->noise, "A random picture, averaged");
    source->add_option("--hairs", options->hairs, "Round hairs, so many in the tile")
        ->type_name("N")
        ->check(CLI::Range(1, 65536));
    source->add_option("--image", options->image, "Any picture, bright where hair is long")
        ->type_name("P.png");
    source->require_option(1);
    verb->add_option("-o,--output", options->folder, "The folder to write to, made if need be")
        ->type_name("DIR")
        ->required();
    verb->add_option("--layers", options->layers, "1 to 256")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, kMostLayers));
    addPhotoOptions(*verb, *options, *photo);
    addMapOptions(*verb, *options);
    addJsonFlag(*verb, json);
    verb->callback([options, photo, &json] {
        options->pattern.weighted = !options->box;
        if (photo->count() > 0) {
            writePhoto(*options, json);
        } else {
            writeMap(*options, json);
        }
    });
}

}  // namespace pelage
