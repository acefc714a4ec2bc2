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

// The style that a technique has given to both coats, if it is another one than they had. Lines and
// curves are lit alike.
std::optional<uint> styleTurned(const Fur& before, const Fur& turned) {
    if (turned.over.style == before.over.style && turned.under.style == before.under.style)
        return std::nullopt;
    return turned.over.style == kStyleLine ? kStyleCurve : turned.over.style;
}

// One value of one technique from one eye.
struct Trial {
    const Technique* technique;
    std::size_t value;
    Fur fur;
    View view;
    std::optional<uint> style;  // that its reference is lit by

    std::string name() const {
        return std::string(technique->name) + " " + technique->values[value];
    }
};

std::vector<Trial> trialsOf(const Fur& fur, const View& view,
                            const std::vector<const Technique*>& techniques) {
    std::vector<Trial> trials;
    for (const Technique* technique : techniques)
        for (std::size_t value = 0; value < technique->values.size(); ++value) {
            Trial& trial = trials.emplace_back(Trial{technique, value, fur, view, {}});
            technique->turn(value, trial.fur, trial.view);
            trial.style = styleTurned(fur, trial.fur);
        }
    return trials;
}

// With every light that the trials ask for, all by the same rays.
std::vector<References> tracedReferences(std::shared_ptr<const ReferenceScene> scene,
                                         ReferenceView view, const std::vector<Trial>& trials,
                                         const MeasureOptions& options) {
    std::vector<References> references(1);
    for (const Trial& trial : trials)
        if (std::ranges::find(references, trial.style, &References::style) == references.end())
            references.push_back({.style = trial.style});
    view.shadows = Shadows::live;
    view.seed = options.seed;
    std::vector<Lighting> more = {{Shadows::traced, {}}};
    for (std::size_t i = 1; i < references.size(); ++i)
        for (const Shadows shadows : {Shadows::live, Shadows::traced})
            more.push_back({shadows, references[i].style});
    ReferencePicture picture(std::move(scene), view, more);
    picture.add(options.spp);
    for (std::size_t i = 0; i < references.size(); ++i) {
        references[i].drawing = tracedPicture(picture, view.size, 2 * i);
        references[i].light = tracedPicture(picture, view.size, 2 * i + 1);
    }
    return references;
}

bool sameFrame(const Trial& a, const Trial& b) {
    View view = a.view;
    view.samples = b.view.samples;
    return a.fur == b.fur && samePicture(view, b.view);
}

// Takes the times from a row of the same frames, if there is one.
Measured drawn(Renderer& renderer, Document document, const Trial& trial, std::size_t repeat,
               const Measured* twin) {
    Measured row;
    document.fur = trial.fur;
    LiveDrawing drawing(trial.view, twin ? 0 : repeat);
    std::optional<LivePicture> picture;
    while (!picture) picture = drawing.step(renderer, document);
    if (twin) {
        row = *twin;
    } else {
        row.msFrame = median(picture->times);
        row.msLeast = *std::ranges::min_element(picture->times);
        row.msGreatest = *std::ranges::max_element(picture->times);
        row.framesTimed = picture->times.size();
    }
    row.image = std::move(picture->image);
    row.samples = picture->stats.samples;
    row.hairsDrawn = picture->stats.hairsDrawn;
    row.segmentsDrawn = picture->stats.segmentsDrawn;
    row.layers = picture->stats.layers;
    row.msShells = 1e3 * picture->stats.shellSeconds;
    row.textureBytes = picture->stats.textureBytes;
    row.bytes = renderer.bytes();
    return row;
}

// The row of trial `number`, those before it being measured.
Measured measured(Renderer& renderer, const Document& document, const std::vector<Trial>& trials,
                  std::size_t number, const MeasuredEye& eye, std::size_t repeat) {
    const Trial& trial = trials[number];
    const Measured *twin = nullptr, *same = nullptr;
    for (std::size_t i = 0; i < number && !same; ++i) {
        if (!sameFrame(trials[i], trial)) continue;
        twin = &eye.rows[i];
        if (trials[i].view.samples == trial.view.samples) same = twin;
    }
    Measured row = same ? *same : drawn(renderer, document, trial, repeat, twin);
    row.technique = trial.technique;
    row.value = trial.value;
    if (same) return row;
    const auto reference = std::ranges::find(eye.references, trial.style, &References::style);
    row.reference = static_cast<std::size_t>(reference - eye.references.begin());
    row.drawing = imageErrors(row.image, reference->drawing.image);
    row.light = imageErrors(row.image, reference->light.image);
    return row;
}

}  // namespace

TracedPicture tracedPicture(const ReferencePicture& traced, ivec2 size, std::size_t picture) {
    TracedPicture result{{size, traced.pixels(picture)}, traced.noise(vec3(0.0f), picture)};
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
        const std::vector<Trial> trials = trialsOf(document.fur, view, options.techniques);
        say(eye.name + ": reference");
        seen.references = tracedReferences(scene, referenceView(view), trials, options);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            say(eye.name + ": " + trials[i].name());
            seen.rows.push_back(measured(renderer, document, trials, i, seen, options.repeat));
        }
        result.eyes.push_back(std::move(seen));
    }
    return result;
}

}  // namespace pelage
