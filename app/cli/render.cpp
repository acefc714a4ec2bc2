// render.cpp -- pelage render: a picture of the fur, and how long it took.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "app/cli/cli.h"
#include "app/cli/input.h"
#include "app/cli/picture.h"
#include "app/cli/print.h"
#include "app/cli/reference.h"
#include "app/cli/shell_options.h"
#include "app/render/framing.h"
#include "core/pose.h"

namespace pelage {
namespace {

constexpr int kMaxSide = 8192;  // pixels
constexpr uint kMostLayers = 256;

struct InLayers {  // a way to draw fur
    const char* name;
    Shells shells;
    DrawnAs as;
};
constexpr InLayers kShells[] = {{"shells", Shells::swept, DrawnAs::shells},
                                {"shells-fins", Shells::swept, DrawnAs::fins},
                                {"shells-plain", Shells::plain, DrawnAs::shells},
                                {"shells-instanced", Shells::instanced, DrawnAs::shells}};

constexpr const char* kAutomatic = "auto";
constexpr const char* kCoatTechniques[] = {"strands", "shells", "shells-fins", kAutomatic};

struct Options {
    InputOptions input;
    std::string output;
    std::string size = "900x900";
    std::string technique;             // of both coats; empty = each its own style
    std::string over, under;           // of one coat: kCoatTechniques; empty = as both
    std::string clip;                  // name or number; empty = at rest
    float time = 0.0f;                 // s
    int frames = 1;                    // of a sequence
    float rate = 25.0f;                // of them, Hz
    std::optional<float> distance;     // m
    float yaw = 35.0f, pitch = 12.0f;  // degrees
    std::string layers = "auto";
    bool shellShadows = false;
    ShellOptions shells;
    int samples = 16, repeat = 3;
    bool transparent = false;
    Detail detail;
    TraceOptions trace;
};

// "900x600" as pixels; nothing where it is not two numbers of [1, kMaxSide].
std::optional<ivec2> parseSize(const std::string& text) {
    ivec2 size{0};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.y);
    if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
    if (size.x < 1 || size.y < 1 || size.x > kMaxSide || size.y > kMaxSide) return std::nullopt;
    return size;
}

std::string checkSize(const std::string& text) {
    if (parseSize(text)) return "";
    return "\"" + text + "\" is not WIDTHxHEIGHT, each 1 to " + std::to_string(kMaxSide);
}

// "auto" is 0; nothing where it is not a number of [0, kMostLayers].
std::optional<uint> parseLayers(const std::string& text) {
    if (text == "auto") return 0u;
    uint layers = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), layers);
    if (error != std::errc() || end != text.data() + text.size() || layers > kMostLayers)
        return std::nullopt;
    return layers;
}

std::string checkLayers(const std::string& text) {
    if (parseLayers(text)) return "";
    return "\"" + text + "\" is neither auto nor a number of 0 to " + std::to_string(kMostLayers);
}

std::string checkDetail(const std::string& text) {
    try {
        detailFromText(text);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

// CLI::Range lets NaN through.
CLI::Validator between(float least, float greatest) {
    return {[=](const std::string& text) -> std::string {
                float value = 0.0f;
                const char* end = text.data() + text.size();
                const auto [stop, error] = std::from_chars(text.data(), end, value);
                const bool number = error == std::errc() && stop == end;
                if (number && value >= least && value <= greatest) return "";
                char range[64];
                std::snprintf(range, sizeof range, "%g to %g", static_cast<double>(least),
                              static_cast<double>(greatest));
                return "\"" + text + "\" is not a number of " + range;
            },
            ""};
}

// Null where the name is that of no shells.
const InLayers* shellsNamed(const std::string& name) {
    const auto way = std::ranges::find(kShells, name, &InLayers::name);
    return way == std::end(kShells) ? nullptr : way;
}

void setTechnique(View& view, const Options& options) {
    const auto as = [&](const std::string& coat) {
        const std::string& name = coat.empty() ? options.technique : coat;
        if (name == kAutomatic) return DrawnAs::automatic;
        const InLayers* way = shellsNamed(name);
        return way ? way->as : DrawnAs::strands;
    };
    const InLayers* both = shellsNamed(options.technique);
    view.shells = both ? both->shells : Shells::swept;
    view.over = as(options.over);
    view.under = as(options.under);
}

View viewOf(const Document& document, const Options& options) {
    View view;
    view.size = *parseSize(options.size);
    view.samples = options.samples;
    view.camera =
        framedCamera(document, glm::radians(options.yaw), glm::radians(options.pitch), view.size);
    view.detail = options.detail;
    setTechnique(view, options);
    view.layers = *parseLayers(options.layers);
    view.shellShadows = options.shellShadows;
    useShellOptions(view, options.shells, document.skin->size());
    view.transparent = options.transparent;
    if (options.distance) view.camera.distance = *options.distance;
    return view;
}

// Skin and wind as they are after so many seconds.
void moveTo(View& view, const Document& document, const Options& options, float seconds) {
    view.seconds = seconds;
    if (options.clip.empty()) return;
    try {
        view.posed =
            posedSkin(document.skin, {clipNamed(*document.skin, options.clip), seconds, {}});
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(sourceName(options.input) + ": " + error.what());
    }
}

// "walk-0001.png" is the first of "walk.png".
std::string frameFile(const std::string& output, int frame) {
    char number[16];
    std::snprintf(number, sizeof number, "-%04d", frame + 1);
    return output.substr(0, output.size() - 4) + number + output.substr(output.size() - 4);
}

// Each is finished and written; answers for the last.
FrameStats writeFrames(Renderer& renderer, const Document& document, View& view,
                       const Options& options) {
    FrameStats stats;
    for (int frame = 0; frame < options.frames; ++frame) {
        moveTo(view, document, options, options.time + static_cast<float>(frame) / options.rate);
        stats = drawFinished(renderer, document, view);  // settles what FLIP asks for
        writePicture(options.frames > 1 ? frameFile(options.output, frame) : options.output,
                     renderer, view.size);
    }
    return stats;
}

// Styles and shells by name: "ribbon", or "ribbon/shells" for overcoat and undercoat.
std::string techniqueOf(const View& view, const Fur& fur) {
    const auto of = [&](DrawnAs as, const Coat& coat) -> std::string {
        if (as == DrawnAs::automatic) return kAutomatic;
        if (as == DrawnAs::strands) return styleRow().choices[coat.style];
        for (const auto& [name, shells, way] : kShells)
            if (view.shells == shells && (as == way || shells != Shells::swept)) return name;
        return "";
    };
    const std::string over = of(view.over, fur.over), under = of(view.under, fur.under);
    return over == under ? over : over + "/" + under;
}

OrderedJson jsonOf(const Options& options, const Document& document, const View& view,
                   const FrameStats& stats, const std::vector<double>& times,
                   const Renderer& renderer) {
    return {{"output", options.frames > 1 ? frameFile(options.output, 0) : options.output},
            {"frames", options.frames},
            {"width", view.size.x},
            {"height", view.size.y},
            {"technique", techniqueOf(view, document.fur)},
            {"hairsTotal", stats.hairsTotal},
            {"detail", textOf(view.detail)},
            {"hairsTried", stats.hairsTried},
            {"hairsDrawn", stats.hairsDrawn},
            {"segments", view.segments},
            {"segmentsDrawn", stats.segmentsDrawn},
            {"clusters", stats.clusters},
            {"clustersDrawn", stats.clustersDrawn},
            {"clustersOutside", stats.clustersOutside},
            {"clustersHidden", stats.clustersHidden},
            {"clustersSmall", stats.clustersSmall},
            {"clustersBald", stats.clustersBald},
            {"deviation", stats.deviation},
            {"flip", stats.flip},
            {"samples", stats.samples},
            {"inShells", {stats.inShells.x, stats.inShells.y}},
            {"layers", stats.layers},
            {"fins", stats.fins},
            {"shellShadows", view.shellShadows},
            {"textureBytes", stats.textureBytes},
            {"storedLayersBytes", storedLayersBytes(view)},
            {"msShellPass", 1e3 * stats.shellSeconds},
            {"msFrame", median(times)},
            {"msFrames", times},
            {"distance", view.camera.distance},
            {"yaw", options.yaw},
            {"pitch", options.pitch},
            {"triangles", document.skin->triangles.size()},
            {"bytesPerHair", renderer.bytesPerHair()},
            {"bytes", renderer.bytes()},
            {"device", renderer.device()}};
}

std::string textOf(const OrderedJson& result) {
    char times[64];
    std::snprintf(times, sizeof times, "%.1f ms a frame", result["msFrame"].get<double>());
    const auto& shares = result["inShells"];
    const bool shells = shares[0] > 0.0 || shares[1] > 0.0;
    const bool strands = shares[0] < 1.0 || shares[1] < 1.0;
    const std::string hairs =
        result["hairsDrawn"].dump() + " of " + result["hairsTotal"].dump() + " hairs";
    return "wrote " + result["output"].get<std::string>() + ": " + result["width"].dump() + "x" +
           result["height"].dump() + ", " + (strands ? hairs : "in shells") +
           (shells && strands ? " and shells, " : ", ") + times + " on " +
           result["device"].get<std::string>() + "\n";
}

void render(const Options& options, bool json) {
    Document document = openInput(options.input);
    View view = viewOf(document, options);
    if (options.technique == kReferenceTechnique) {
        if (options.frames > 1) throw UsageError("render --frames: not of the reference");
        moveTo(view, document, options, options.time);
        traceReference(document, view, options.trace, options.output, json);
        return;
    }
    if (std::ranges::count(styleRow().choices, options.technique) > 0)
        setParameter(document.fur, "both.style", options.technique);
    const HeadlessContext context;
    Renderer renderer;
    FrameStats stats = writeFrames(renderer, document, view, options);
    const std::vector<double> times = timeFrames(renderer, document, view, options.repeat);
    // Without the programs that the first frame makes.
    if (stats.shellSeconds > 0.0) stats.shellSeconds = renderer.draw(document, view).shellSeconds;
    const OrderedJson result = jsonOf(options, document, view, stats, times, renderer);
    if (json) {
        printJson(result);
    } else {
        print(textOf(result) + pictureText(view));
    }
}

}  // namespace

void addRender(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("render", "Draw a picture without a window");
    const auto options = std::make_shared<Options>();
    addInputOptions(*verb, options->input);
    verb->add_option("-o,--output", options->output, "The .png file to write")
        ->type_name("OUT.png")
        ->check(endsIn(".png"))
        ->required();
    verb->add_option("--size", options->size, "Pixels")
        ->type_name("WxH")
        ->capture_default_str()
        ->check(CLI::Validator(checkSize, ""));
    const auto styles = styleRow().choices;
    std::vector<std::string> techniques(styles.begin(), styles.end());
    for (const InLayers& way : kShells) techniques.emplace_back(way.name);
    techniques.emplace_back(kAutomatic);
    techniques.emplace_back(kReferenceTechnique);
    verb->add_option("--technique", options->technique,
                     "How hair is drawn, in place of the coats' own styles")
        ->type_name("NAME")
        ->check(CLI::IsMember(techniques));
    for (const auto& [flag, coat, help] :
         {std::tuple("--over", &options->over, "The overcoat, in place of the technique of both"),
          {"--under", &options->under, "The undercoat, likewise"}})
        verb->add_option(flag, *coat, help)
            ->type_name("NAME")
            ->check(CLI::IsMember(
                std::vector<std::string>(std::begin(kCoatTechniques), std::end(kCoatTechniques))));
    verb->add_option("--layers", options->layers, "Of shells: how many at least, 0 to 256, or auto")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Validator(checkLayers, ""));
    verb->add_flag("--shell-shadows", options->shellShadows,
                   "Of shells: single hairs cast shadows on hair below them");
    addShellOptions(*verb, options->shells);
    verb->add_option("--clip", options->clip,
                     "Stand as in this animation, by name or number; see pelage info")
        ->type_name("NAME");
    verb->add_option("--time", options->time,
                     "Seconds from the start of the clip, and that the wind has blown")
        ->type_name("T")
        ->capture_default_str()
        ->check(between(-1e6f, 1e6f));
    verb->add_option("--frames", options->frames,
                     "Pictures of a sequence from that time on: OUT-0001.png and so on")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 9999));
    verb->add_option("--rate", options->rate, "Pictures of a sequence for each second")
        ->type_name("HZ")
        ->capture_default_str()
        ->check(between(0.001f, 1000.0f));
    verb->add_option("--distance", options->distance,
                     "m from the eye to the middle of the model; without it the model is framed")
        ->type_name("D")
        ->check(between(1e-6f, 1e6f));
    verb->add_option("--yaw", options->yaw, "Degrees to the animal's left; 0 looks at its face")
        ->type_name("A")
        ->capture_default_str()
        ->check(between(-3600.0f, 3600.0f));
    verb->add_option("--pitch", options->pitch, "Degrees from above")
        ->type_name("A")
        ->capture_default_str()
        ->check(between(-90.0f, 90.0f));
    verb->add_option("--samples", options->samples, "Frames that the picture averages")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    verb->add_flag("--transparent", options->transparent,
                   "Leave the background out: the alpha is the share of a pixel that is covered");
    verb->add_option("--repeat", options->repeat, "Frames that are timed")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 10000));
    verb->add_option_function<std::string>(
            "--detail",
            [options](const std::string& text) { options->detail = detailFromText(text); },
            "How many hairs, and how fine: all, distance (fewer and wider ones far away), share:S, "
            "pixels:P (off by P pixels at most), flip:F (a mean FLIP of F at most against the "
            "picture of all hairs), ms:T (what a frame of T ms can show); a time may "
            "follow another one after a comma")
        ->type_name("DETAIL")
        ->default_str(textOf(options->detail))
        ->check(CLI::Validator(checkDetail, ""));
    addTraceOptions(*verb, options->trace);
    addJsonFlag(*verb, json);
    verb->callback([options, &json] { render(*options, json); });
}

}  // namespace pelage
