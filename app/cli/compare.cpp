// compare.cpp -- pelage compare: how far a picture is from its reference.
#include "app/cli/compare.h"

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/cli/cli.h"
#include "app/cli/input.h"
#include "app/cli/print.h"
#include "core/heat_map.h"
#include "core/image_error.h"
#include "core/pixels.h"

namespace pelage {
namespace {

struct Options {
    std::string image, reference;
    std::string heat;  // empty = none
};

OrderedJson jsonOf(const std::optional<CoverageErrors>& coverage) {
    if (!coverage) return nullptr;
    return {{"bandPixels", coverage->bandPixels},
            {"bandBias", coverage->bandBias},
            {"bandRmse", coverage->bandRmse},
            {"areaRatio", coverage->areaRatio},
            {"silhouette", coverage->silhouette}};
}

OrderedJson jsonOf(const Options& options, const ImageErrors& errors) {
    OrderedJson result = {{"image", options.image},
                          {"reference", options.reference},
                          {"width", errors.flipMap.size.x},
                          {"height", errors.flipMap.size.y}};
    result.update(jsonOf(errors));
    if (!options.heat.empty()) result["heat"] = options.heat;
    return result;
}

std::string textOf(const Options& options, const ImageErrors& errors) {
    std::string text = options.image + " against " + options.reference + ", " +
                       std::to_string(errors.flipMap.size.x) + "x" +
                       std::to_string(errors.flipMap.size.y) + " pixels\n";
    const auto line = [&](const char* name, double value, const char* unit = "") {
        char row[96];
        std::snprintf(row, sizeof row, "  %-22s %.6g%s\n", name, value, unit);
        text += row;
    };
    line("RMSE, linear RGB", errors.rmse);
    line("luminance bias", 100.0 * errors.luminanceBias, " %");
    line("FLIP, mean", errors.flipMean);
    line("FLIP, 99 %", errors.flip99);
    line("SSIM", errors.ssim);
    if (const auto& coverage = errors.coverage) {
        line("silhouette band", static_cast<double>(coverage->bandPixels), " pixels");
        line("coverage bias in it", coverage->bandBias);
        line("coverage RMSE in it", coverage->bandRmse);
        line("covered area", coverage->areaRatio, " of the reference's");
        line("silhouette error", coverage->silhouette);
    }
    return text;
}

ImageErrors errorsOf(const Options& options) {
    const Image image = readImage(options.image), reference = readImage(options.reference);
    try {
        return imageErrors(image, reference);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(options.image + " against " + options.reference + ": " +
                                 error.what());
    }
}

void compare(const Options& options, bool json) {
    const ImageErrors errors = errorsOf(options);
    if (!options.heat.empty()) writeImage(options.heat, heatMap(errors.flipMap));
    if (json) {
        printJson(jsonOf(options, errors));
    } else {
        print(textOf(options, errors));
    }
}

}  // namespace

OrderedJson jsonOf(const ImageErrors& errors) {
    return {{"rmse", errors.rmse},         {"luminanceBias", errors.luminanceBias},
            {"flipMean", errors.flipMean}, {"flip99", errors.flip99},
            {"ssim", errors.ssim},         {"coverage", jsonOf(errors.coverage)}};
}

void addCompare(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("compare", "Say how far a picture is from its reference");
    const auto options = std::make_shared<Options>();
    verb->add_option("IMAGE", options->image, "A .png or .jpg picture")->required();
    verb->add_option("REFERENCE", options->reference, "What it should be, of the same size")
        ->required();
    verb->add_option("--heat", options->heat, "A picture of where they differ: the FLIP map")
        ->type_name("OUT.png")
        ->check(endsIn(".png"));
    addJsonFlag(*verb, json);
    verb->callback([options, &json] { compare(*options, json); });
}

}  // namespace pelage
