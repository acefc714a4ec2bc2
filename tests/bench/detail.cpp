// detail.cpp -- what level of detail saves, and whether frames keep to their time.
//
// pelage_detail: 500,000 hairs on the animal of 126,000 triangles at 900x900, one sample a frame.
// From near to far the median of a frame of all hairs and of one off by at most half a pixel, drawn
// in turns; then 300 frames of a camera that turns around the animal and moves away and back, each
// asked to take 33 ms.
//
// pelage_detail MODEL PRESET HAIRS SIZE: what a FLIP of 0.1, 0.05 and 0.02 that is asked for gives:
// a mesh file or "animal" with so many hairs of a preset, in square pictures of so many pixels, 16
// samples, from close, middle and far. The error is the mean of FLIP against the picture of all
// hairs and against the reference with the light of the live view.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "app/measure/knobs.h"
#include "app/render/frames.h"
#include "app/render/framing.h"
#include "app/render/headless.h"
#include "app/render/reference_view.h"
#include "core/animal.h"
#include "core/flip.h"
#include "core/pixels.h"
#include "core/preset_file.h"
#include "core/source.h"

namespace pelage {
namespace {

constexpr int kRepeat = 9, kPath = 300;
constexpr float kAsked = 33.0f;  // ms

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

Document hairyAnimal() {
    Document document = groomedAnimal(126000);
    document.fur.hairs = 500000;
    return document;
}

void compareViews(Renderer& renderer, const Document& document, View view) {
    std::printf("%9s %9s %9s %6s | of the frame off by half a pixel at most\n", "distance",
                "all ms", "ms", "ratio");
    for (const float distance : {0.7f, 2.0f, 12.0f}) {
        view.camera.distance = distance;
        std::vector<double> all, some;
        FrameStats stats;
        for (int i = 0; i <= kRepeat; ++i)
            for (const Detail& detail : {Detail{.rule = Detail::Rule::all},
                                         Detail{.rule = Detail::Rule::pixels, .limit = 0.5f}}) {
                view.camera.yaw += 1e-5f;  // so that the picture begins anew
                view.detail = detail;
                stats = renderer.draw(document, view);
                if (i > 0)
                    (detail.rule == Detail::Rule::all ? all : some).push_back(1e3 * stats.seconds);
            }
        const double full = quantile(all, 0.5), fast = quantile(some, 0.5);
        std::printf(
            "%7.1f m %9.1f %9.1f %6.1f | hairs %zu, segments %zu, clusters %zu of %zu, "
            "outside %zu, hidden %zu, small %zu\n",
            static_cast<double>(distance), full, fast, full / fast, stats.hairsDrawn,
            stats.segmentsDrawn, stats.clustersDrawn, stats.clusters, stats.clustersOutside,
            stats.clustersHidden, stats.clustersSmall);
    }
}

void followPath(Renderer& renderer, const Document& document, View view) {
    view.detail = {.rule = Detail::Rule::all, .milliseconds = kAsked};
    std::vector<double> times, deviations;
    for (int i = 0; i < kPath; ++i) {
        const float turn = 6.2831853f * static_cast<float>(i) / kPath;
        view.camera.yaw = turn;
        view.camera.distance = 3.0f - 1.5f * std::cos(2.0f * turn);
        const FrameStats stats = renderer.draw(document, view);
        times.push_back(1e3 * stats.seconds);
        deviations.push_back(static_cast<double>(stats.deviation));
    }
    std::printf(
        "%d frames asked to take %.0f ms: median %.1f, 95 %% within %.1f, longest %.1f; off by "
        "%.2f pixels at the median\n",
        kPath, static_cast<double>(kAsked), quantile(times, 0.5), quantile(times, 0.95),
        quantile(times, 1.0), quantile(deviations, 0.5));
}

Document modelOf(const std::string& file, const std::string& preset, const std::string& hairs) {
    Document document = file == "animal" ? groomedAnimal(126000) : openDocument(readSource(file));
    const uint seed = document.fur.seed;
    document.fur = findPreset(preset).fur;
    document.fur.seed = seed;
    document.fur.hairs = static_cast<uint>(std::stoul(hairs));
    return document;
}

void keepBudgets(Renderer& renderer, const Document& document, int side) {
    View view;
    view.size = ivec2(side);
    view.samples = 16;
    const auto scene = std::make_shared<const ReferenceScene>(document, referenceOptions(view));
    const auto drawn = [&](const Detail& detail) {
        view.detail = detail;
        drawFinished(renderer, document, view);
        return linearImage({view.size, renderer.pixels()});
    };
    const auto meanFlip = [](const Image& image, const Image& reference) {
        return meanOf(flip(image, reference));
    };
    const Camera whole =
        framedCamera(document, glm::radians(35.0f), glm::radians(12.0f), view.size);
    const auto milliseconds = [&] { return median(timeFrames(renderer, document, view, 5)); };
    std::printf("%7s %6s %9s | %6s %6s %9s | %7s %8s %6s\n", "view", "asked", "pixels off", "FLIP",
                "to ref", "all to ref", "hairs", "ms", "ratio");
    for (const Nearness& nearness : nearnesses()) {
        view.camera = zoomed(document, whole, nearness.share);
        ReferenceView traced = referenceView(view);
        traced.shadows = Shadows::live;
        ReferencePicture picture(scene, traced);
        picture.add(64);
        const Image reference = linearImage({view.size, displayed(picture, view.background)});
        const Image all = drawn({.rule = Detail::Rule::all});
        const double allError = meanFlip(all, reference), allTime = milliseconds();
        for (const float asked : {0.1f, 0.05f, 0.02f}) {
            const Image image = drawn({.rule = Detail::Rule::flip, .limit = asked});
            const FrameStats stats = renderer.draw(document, view);
            const double time = milliseconds();
            std::printf("%7s %6.2f %10.3f | %6.4f %6.4f %10.4f | %7zu %8.1f %6.1f\n", nearness.name,
                        static_cast<double>(asked), static_cast<double>(stats.deviation),
                        meanFlip(image, all), meanFlip(image, reference), allError,
                        stats.hairsDrawn, time, allTime / time);
            std::fflush(stdout);
        }
    }
}

void run(int count, char** arguments) {
    const HeadlessContext context;
    Renderer renderer;
    if (count == 5) {
        std::printf("%s, %s, %s hairs, %s pixels\n", arguments[1], arguments[2], arguments[3],
                    arguments[4]);
        const Document model = modelOf(arguments[1], arguments[2], arguments[3]);
        keepBudgets(renderer, model, std::stoi(arguments[4]));
        return;
    }
    const Document document = hairyAnimal();
    View view;
    view.camera = framed(document.skin->center(), 1.2f * document.skin->radius, 0.6f, 0.2f, 1.0f);
    compareViews(renderer, document, view);
    followPath(renderer, document, view);
}

}  // namespace
}  // namespace pelage

int main(int count, char** arguments) {
    try {
        pelage::run(count, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pelage_detail: %s\n", error.what());
        return 1;
    }
    return 0;
}
