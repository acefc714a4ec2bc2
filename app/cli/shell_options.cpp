// shell_options.cpp -- pelage render: the picture that shells are cut from in place of hairs.
#include "app/cli/shell_options.h"

#include <cstdio>

namespace pelage {
namespace {

using From = ShellRecipe::From;

const char* nameOf(From from) {
    constexpr const char* kNames[] = {"", "--shell-photo", "--shell-image", "--shell-noise"};
    return kNames[static_cast<int>(from)];
}

// The one that both coats have, or the one that has any.
const ShellSource& pictureOf(const View& view) {
    return view.maps[0].texture ? view.maps[0] : view.maps[1];
}

}  // namespace

CLI::Option* addClampOption(CLI::App& verb, const char* name, std::vector<double>& clamp) {
    return verb
        .add_option(name, clamp,
                    "Percent of the pixels below the darkest and the brightest tone that counts")
        ->type_name("LOW,HIGH")
        ->delimiter(',')
        ->expected(2)
        ->allow_extra_args(false)
        ->check(CLI::Range(0.0, 100.0))
        ->default_str("1,99");
}

void expectRising(const char* option, const std::vector<double>& clamp) {
    if (clamp[0] < clamp[1]) return;
    char text[96];
    std::snprintf(text, sizeof text, "%s: %g is not below %g", option, clamp[0], clamp[1]);
    throw UsageError(text);
}

void addShellOptions(CLI::App& verb, ShellOptions& options) {
    const std::string group = "Shells from a picture in place of hairs";
    ShellRecipe& recipe = options.recipe;
    const auto file = [&](From from, const char* help) {
        return verb
            .add_option_function<std::string>(
                nameOf(from),
                [&recipe, from](const std::string& name) {
                    recipe.from = from;
                    recipe.file = name;
                },
                help)
            ->type_name("P.png")
            ->group(group);
    };
    CLI::Option* photo = file(From::photo, "A photograph of fur: what is bright lies high");
    CLI::Option* image = file(From::picture, "Any picture, bright where hair is long");
    CLI::Option* noise = verb.add_flag_callback(
        nameOf(From::noise), [&recipe] { recipe.from = From::noise; },
        "A random picture, averaged");
    noise->group(group)->excludes(photo)->excludes(image);
    photo->excludes(image);
    verb.add_option("--shell-coat", options.coats, "Which coat is cut from it")
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember({"over", "under", "both"}))
        ->group(group);
    verb.add_option("--shell-side", recipe.side,
                    "m, the shorter side of the picture on the skin; 0 = a fifth of its size")
        ->type_name("M")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1e6))
        ->group(group);
    verb.add_option("--shell-gap", recipe.gap,
                    "Between layers, as a share of what lets them fill the coat")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 1.0))
        ->group(group);
    addClampOption(verb, "--shell-clamp", options.clamp)->needs(photo)->group(group);
    verb.add_flag("--shell-two-colors", recipe.photo.twoColors,
                  "A range of tones for each color of the fur")
        ->needs(photo)
        ->group(group);
    verb.add_option("--shell-coverage", recipe.cut.coverage,
                    "Of the skin, by noise and pictures: at the root")
        ->capture_default_str()
        ->check(CLI::Range(0.001, 1.0))
        ->excludes(photo)
        ->group(group);
}

void useShellOptions(View& view, const ShellOptions& options, float skinSize) {
    ShellRecipe recipe = options.recipe;
    if (recipe.from == From::hairs) return;
    const bool over = options.coats != "under", under = options.coats != "over";
    const auto layered = [](DrawnAs as) { return as == DrawnAs::shells || as == DrawnAs::fins; };
    if ((over && !layered(view.over)) || (under && !layered(view.under)))
        throw UsageError(std::string("render ") + nameOf(recipe.from) +
                         ": needs a --technique of shells");
    expectRising("render --shell-clamp", options.clamp);
    recipe.photo.darkest = static_cast<float>(options.clamp[0] / 100.0);
    recipe.photo.brightest = static_cast<float>(options.clamp[1] / 100.0);
    if (view.layers > 0) recipe.photo.layers = static_cast<int>(view.layers);
    const ShellSource source = shellSource(shellPicture(recipe), recipe, skinSize);
    if (over) view.maps[0] = source;
    if (under) view.maps[1] = source;
}

std::size_t storedLayersBytes(const View& view) {
    const ShellSource& source = pictureOf(view);
    if (!source.texture) return 0;
    return source.layers * pixelCount(source.texture->size) * sizeof(ShellTexture::Texel);
}

std::string memoryText(ivec2 size, int layers) {
    constexpr std::size_t kTexel = sizeof(ShellTexture::Texel);
    const auto kib = [](std::size_t texels) {
        return static_cast<double>(kTexel * texels) / 1024.0;
    };
    const std::size_t one = pixelCount(size);
    char text[160];
    std::snprintf(
        text, sizeof text,
        "texture %.0f KiB, with its mips %.0f KiB; %d stored layers would take %.0f KiB\n",
        kib(one), kib(texelsWithLevels(size)), layers, kib(static_cast<std::size_t>(layers) * one));
    return text;
}

std::string pictureText(const View& view) {
    const ShellSource& source = pictureOf(view);
    if (!source.texture) return {};
    const std::string halved = halvedText(*source.texture);
    return memoryText(source.texture->size, static_cast<int>(source.layers)) +
           (halved.empty() ? "" : halved + "\n");
}

}  // namespace pelage
