// reference.cpp -- pelage render --technique reference: the slow, right answer.
#include "app/cli/reference.h"

#include <chrono>
#include <cstdio>

#include "app/render/headless.h"
#include "app/render/reference_view.h"
#include "core/pixels.h"

namespace pelage {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

void addTraceOptions(CLI::App& verb, TraceOptions& options) {
    const std::string group = "Of the reference";
    verb.add_option("--spp", options.samples, "Samples of each pixel, an even number")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(2, 65536))
        ->group(group);
    verb.add_option("--shadows", options.shadows, "Traced by rays, or reckoned as in the live view")
        ->capture_default_str()
        ->check(CLI::IsMember({"traced", "live"}))
        ->group(group);
    verb.add_option("--segments", options.segments, "Of each hair, 0 = as its shape needs")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0, 64))
        ->group(group);
    verb.add_option("--seed", options.seed, "Of the samples")
        ->type_name("N")
        ->capture_default_str()
        ->group(group);
}

void traceReference(const Document& document, const View& view, const TraceOptions& options,
                    const std::string& output, bool json) {
    ReferenceOptions wanted = referenceOptions(view);
    wanted.segments = options.segments;
    ReferenceView traced = referenceView(view);
    traced.shadows = options.shadows == "live" ? Shadows::live : Shadows::traced;
    traced.seed = options.seed;

    auto start = Clock::now();
    const auto scene = std::make_shared<const ReferenceScene>(document, wanted);
    const double building = secondsSince(start);
    start = Clock::now();
    ReferencePicture picture(scene, traced);
    picture.add(options.samples);
    const double tracing = secondsSince(start);
    if (view.transparent)
        writeImage(output, {view.size, picture.pixels()});
    else
        writePng(output, view.size, displayed(picture, view.background));

    const ReferenceNoise noise = picture.noise(view.transparent ? vec3(0.0f) : view.background);
    const OrderedJson result = {{"output", output},
                                {"width", view.size.x},
                                {"height", view.size.y},
                                {"technique", kReferenceTechnique},
                                {"shadows", options.shadows},
                                {"hairs", scene->hairs()},
                                {"segments", scene->segments()},
                                {"samples", picture.samples()},
                                {"seed", options.seed},
                                {"noise", noise.color},
                                {"coverageNoise", noise.coverage},
                                {"secondsBuilding", building},
                                {"secondsTracing", tracing},
                                {"rays", picture.rays()},
                                {"bytes", scene->bytes()},
                                {"distance", view.camera.distance}};
    if (json) {
        printJson(result);
        return;
    }
    char text[256];
    std::snprintf(text, sizeof text,
                  ": %dx%d, %zu hairs of %u segments, %u samples, noise %.5f in linear light, %.1f "
                  "s, %.2f million rays a second\n",
                  view.size.x, view.size.y, scene->hairs(), scene->segments(), picture.samples(),
                  static_cast<double>(noise.color), building + tracing,
                  1e-6 * static_cast<double>(picture.rays()) / tracing);
    print("wrote " + output + text);
}

}  // namespace pelage
