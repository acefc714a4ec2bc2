// measure.cpp -- the references of a view, then row after row against them.
#include "app/measure/measure.h"

#include <algorithm>
#include <limits>

#include "app/render/frames.h"
#include "app/render/reference_view.h"
#include "core/pixels.h"

namespace pelage {
namespace {

struct Drawn {
    Image image;
    FrameStats stats;
};

// The picture over black, with its coverage: what a white background does not lighten.
Drawn drawn(Renderer& renderer, const Document& document, View view) {
    view.background = vec3(0.0f);
    const FrameStats stats = drawFinished(renderer, document, view);
    Image image = linearImage({view.size, renderer.pixels()});
    view.background = vec3(1.0f);
    view.patience = 0.0;  // of the same hairs
    drawFinished(renderer, document, view);
    const Image white = linearImage({view.size, renderer.pixels()});
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const vec3 through = vec3(white.pixels[i]) - vec3(image.pixels[i]);
        image.pixels[i].a =
            std::clamp(1.0f - (through.r + through.g + through.b) / 3.0f, 0.0f, 1.0f);
    }
    return {std::move(image), stats};
}

TracedPicture traced(std::shared_ptr<const ReferenceScene> scene, ReferenceView view,
                     Shadows shadows, const MeasureOptions& options) {
    view.shadows = shadows;
    view.seed = options.seed;
    ReferencePicture picture(std::move(scene), view);
    picture.add(options.spp);
    TracedPicture result{{view.size, picture.pixels()}, picture.noise(vec3(0.0f))};
    for (vec4& pixel : result.image.pixels) pixel = glm::clamp(pixel, 0.0f, 1.0f);
    return result;
}

Measured measured(Renderer& renderer, Document document, View view, const Technique& technique,
                  std::size_t value, int repeat) {
    technique.turn(value, document.fur, view);
    Measured row{.technique = &technique, .value = value};
    Drawn picture = drawn(renderer, document, view);  // settles what a FLIP asks for
    row.image = std::move(picture.image);
    row.samples = picture.stats.samples;
    row.hairsDrawn = picture.stats.hairsDrawn;
    row.segmentsDrawn = picture.stats.segmentsDrawn;
    row.bytes = renderer.bytes();
    const std::vector<double> times = timeFrames(renderer, document, view, repeat);
    row.msFrame = median(times);
    row.msLeast = *std::ranges::min_element(times);
    row.msGreatest = *std::ranges::max_element(times);
    return row;
}

}  // namespace

std::vector<Approach> approaches(const MeasuredEye& eye) {
    std::vector<Approach> all;
    double before = 0.0;
    for (const Measured& row : eye.rows) {
        const double error = row.drawing.rmse;
        if (all.empty() || all.back().technique != row.technique)
            all.push_back({row.technique, error, error, true});
        else if (error > before + static_cast<double>(eye.drawing.noise.color))
            all.back().falls = false;
        all.back().finest = before = error;
    }
    return all;
}

double noiseShare(double rmse, const TracedPicture& reference) {
    const double noise = static_cast<double>(reference.noise.color);
    return rmse > 0.0 ? noise / rmse : std::numeric_limits<double>::infinity();
}

Measurement measure(const Document& document, const MeasureOptions& options,
                    const std::function<void(const std::string&)>& tell) {
    const auto say = [&](const std::string& what) {
        if (tell) tell(what);
    };
    Renderer renderer;
    Measurement result{.size = options.size,
                       .triangles = document.skin->triangles.size(),
                       .spp = options.spp,
                       .seed = options.seed,
                       .repeat = options.repeat,
                       .device = renderer.device()};
    View view = measuredView();
    view.size = options.size;
    say("growing the reference");
    const auto scene = std::make_shared<const ReferenceScene>(document, referenceOptions(view));
    result.hairs = scene->hairs();
    for (const MeasureOptions::Eye& eye : options.eyes) {
        view.camera = eye.camera;
        MeasuredEye seen{.name = eye.name, .camera = eye.camera};
        say(eye.name + ": reference with the light of the live view");
        seen.drawing = traced(scene, referenceView(view), Shadows::live, options);
        say(eye.name + ": reference with traced light");
        seen.light = traced(scene, referenceView(view), Shadows::traced, options);
        for (const Technique* technique : options.techniques) {
            for (std::size_t value = 0; value < technique->values.size(); ++value) {
                say(eye.name + ": " + technique->name + " " + technique->values[value]);
                Measured row =
                    measured(renderer, document, view, *technique, value, options.repeat);
                row.drawing = imageErrors(row.image, seen.drawing.image);
                row.light = imageErrors(row.image, seen.light.image);
                seen.rows.push_back(std::move(row));
            }
        }
        result.eyes.push_back(std::move(seen));
    }
    return result;
}

}  // namespace pelage
