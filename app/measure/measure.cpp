// measure.cpp -- the references of a view, then row after row against them.
#include "app/measure/measure.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "app/measure/live_picture.h"
#include "app/render/frames.h"
#include "app/render/reference_view.h"

namespace pelage {
namespace {

TracedPicture traced(std::shared_ptr<const ReferenceScene> scene, ReferenceView view,
                     Shadows shadows, const MeasureOptions& options) {
    view.shadows = shadows;
    view.seed = options.seed;
    ReferencePicture picture(std::move(scene), view);
    picture.add(options.spp);
    return tracedPicture(picture, view.size);
}

// Traces what is not there yet.
std::size_t referenceNumber(MeasuredEye& eye, const std::shared_ptr<const ReferenceScene>& scene,
                            ReferenceView view, std::optional<uint> style,
                            const MeasureOptions& options) {
    const auto known = std::ranges::find(eye.references, style, &References::style);
    const auto number = static_cast<std::size_t>(known - eye.references.begin());
    if (known != eye.references.end()) return number;
    view.style = style;
    eye.references.push_back({style, traced(scene, view, Shadows::live, options),
                              traced(scene, view, Shadows::traced, options)});
    return number;
}

// The style that a technique has given to both coats, if it is another one than they had. Lines and
// curves are lit alike.
std::optional<uint> styleTurned(const Fur& before, const Fur& turned) {
    if (turned.over.style == before.over.style && turned.under.style == before.under.style)
        return std::nullopt;
    return turned.over.style == kStyleLine ? kStyleCurve : turned.over.style;
}

Measured measured(Renderer& renderer, const Document& document, const View& view,
                  const Technique& technique, std::size_t value, int repeat) {
    Measured row{.technique = &technique, .value = value};
    LiveDrawing drawing(view, repeat);
    std::optional<LivePicture> picture;
    while (!picture) picture = drawing.step(renderer, document);
    row.msFrame = median(picture->times);
    row.msLeast = *std::ranges::min_element(picture->times);
    row.msGreatest = *std::ranges::max_element(picture->times);
    row.image = std::move(picture->image);
    row.samples = picture->stats.samples;
    row.hairsDrawn = picture->stats.hairsDrawn;
    row.segmentsDrawn = picture->stats.segmentsDrawn;
    row.bytes = renderer.bytes();
    return row;
}

}  // namespace

TracedPicture tracedPicture(const ReferencePicture& picture, ivec2 size) {
    TracedPicture result{{size, picture.pixels()}, picture.noise(vec3(0.0f))};
    for (vec4& pixel : result.image.pixels) pixel = glm::clamp(pixel, 0.0f, 1.0f);
    return result;
}

std::vector<Approach> approaches(const MeasuredEye& eye) {
    std::vector<Approach> all;
    double before = 0.0;
    for (const Measured& row : eye.rows) {
        const double error = row.drawing.rmse;
        const auto noise = static_cast<double>(eye.referenceOf(row).drawing.noise.color);
        if (all.empty() || all.back().technique != row.technique)
            all.push_back({row.technique, error, error, noise, true});
        else if (error > before + noise)
            all.back().falls = false;
        all.back().finest = before = error;
        all.back().noise = noise;
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
        const auto numberOf = [&](std::optional<uint> style) {
            return referenceNumber(seen, scene, referenceView(view), style, options);
        };
        say(eye.name + ": reference");
        numberOf(std::nullopt);
        for (const Technique* technique : options.techniques) {
            for (std::size_t value = 0; value < technique->values.size(); ++value) {
                say(eye.name + ": " + technique->name + " " + technique->values[value]);
                Document turned = document;
                View turnedView = view;
                technique->turn(value, turned.fur, turnedView);
                Measured row =
                    measured(renderer, turned, turnedView, *technique, value, options.repeat);
                row.reference = numberOf(styleTurned(document.fur, turned.fur));
                row.drawing = imageErrors(row.image, seen.referenceOf(row).drawing.image);
                row.light = imageErrors(row.image, seen.referenceOf(row).light.image);
                seen.rows.push_back(std::move(row));
            }
        }
        result.eyes.push_back(std::move(seen));
    }
    return result;
}

}  // namespace pelage
