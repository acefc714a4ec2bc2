// styles.cpp -- what each hair style costs, at equal error of shape.
//
// 90,000 hairs on the built-in animal at 900x900, none culled, as in the paper's figure 8 (van
// Gelder and Wilhelms, 1997). Polylines have 7 segments; ribbons, curves and surfaces get the
// tolerance that such a polyline keeps on screen, and surfaces 6 sides. `hair` is the frame without
// that of the bare skin. Errors are those of the drawn chords against the exact curve, in pixels.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "app/render/frames.h"
#include "app/render/headless.h"
#include "core/animal.h"
#include "core/clumps.h"
#include "core/coat.h"
#include "core/scatter.h"
#include "core/strand.h"

namespace pelage {
namespace {

constexpr uint kHairs = 90'000, kPolylineSegments = 7, kSides = 6;
constexpr int kFrames = 15;

View viewOf(const Document& document) {
    View view;
    view.camera = framed(document.skin->center(), 1.2f * document.skin->radius, glm::radians(35.0f),
                         glm::radians(12.0f), 1.0f);
    view.segments = kPolylineSegments;
    view.sides = kSides;
    view.detail.rule = Detail::Rule::all;
    return view;
}

double medianFrame(Renderer& renderer, const Document& document, const View& view) {
    return median(timeFrames(renderer, document, view, kFrames));
}

struct Hairs {
    std::vector<Strand> strands;  // of which every one is a polyline's
    std::vector<float> pixels;    // of a metre at each root
};

Hairs hairsOf(const Document& document, const View& view) {
    const Skin& skin = *document.skin;
    const Roots roots = scatterRoots(skin, document.fur.hairs, document.fur.seed);
    const float scale =
        0.5f * static_cast<float>(view.size.y) / std::tan(0.5f * view.camera.fieldOfView);
    Hairs hairs;
    for (const Root& root : roots.roots) {
        const uvec3 t = skin.triangles[root.triangle];
        const auto fur = [&](uint v) { return furToWorld(skin, v, document.groom.fur[v]); };
        const Strand s =
            growStrand(root, skin.vertices[t.x], skin.vertices[t.y], skin.vertices[t.z], fur(t.x),
                       fur(t.y), fur(t.z), document.fur, 1e-4f, 0.0f);
        if (!(s.spineLength > 0.0f)) continue;
        hairs.strands.push_back(s);
        hairs.pixels.push_back(scale /
                               glm::dot(s.origin - view.camera.eye(), view.camera.forward()));
    }
    return hairs;
}

// How far the straight hair of the line style strays from the curve, m.
float lineError(const Strand& s) {
    float worst = 0.0f;
    for (int i = 1; i < 16; ++i) {
        const vec3 p = strandPoint(s, static_cast<float>(i) / 16.0f) - s.origin;
        const float along = glm::clamp(glm::dot(p, s.end), 0.0f, s.spineLength);
        worst = std::max(worst, glm::distance(p, along * s.end));
    }
    return std::max(worst, glm::distance(strandPoint(s, 1.0f), s.origin + s.spineLength * s.end));
}

struct Errors {
    double mean = 0.0, greatest = 0.0, segments = 0.0;  // pixels, pixels, mean number
};

Errors errorsOf(const Hairs& hairs, uint style, float tolerance) {
    Errors errors;
    for (std::size_t i = 0; i < hairs.strands.size(); ++i) {
        const Strand& s = hairs.strands[i];
        const uint segments = style == kStyleLine ? 1u
                              : style == kStylePolyline
                                  ? kPolylineSegments
                                  : segmentsFor(s, tolerance / hairs.pixels[i]);
        const float error =
            style == kStyleLine ? lineError(s) : chordError(s, static_cast<float>(segments));
        const double pixels = static_cast<double>(error * hairs.pixels[i]);
        errors.mean += pixels;
        errors.greatest = std::max(errors.greatest, pixels);
        errors.segments += segments;
    }
    errors.mean /= static_cast<double>(hairs.strands.size());
    errors.segments /= static_cast<double>(hairs.strands.size());
    return errors;
}

void run() {
    const HeadlessContext context;
    Renderer renderer;
    Document document = groomedAnimal(126'000);
    document.fur.hairs = kHairs;
    View view = viewOf(document);
    const Hairs hairs = hairsOf(document, view);
    view.tolerance = static_cast<float>(errorsOf(hairs, kStylePolyline, 0.0f).greatest);

    View bald = view;
    bald.showOver = bald.showUnder = false;
    const double skin = medianFrame(renderer, document, bald);
    std::printf("%u hairs, 900x900, skin alone %.1f ms, %s\n", kHairs, skin,
                renderer.device().c_str());
    std::printf("%-14s %8s %8s %8s %8s %10s %10s %9s\n", "style", "frame ms", "hair ms", "ratio",
                "paper", "mean px", "worst px", "segments");
    const double paper[] = {2.6, 6.1, 0.0, 70.2, 277.5};  // s, figure 8
    double line = 0.0;
    for (uint style = 0; style < styleRow().choices.size(); ++style) {
        document.fur.over.style = document.fur.under.style = style;
        const double frame = medianFrame(renderer, document, view);
        const double hair = frame - skin;
        if (style == kStyleLine) line = hair;
        const Errors errors = errorsOf(hairs, style, view.tolerance);
        std::printf("%-14s %8.1f %8.1f %8.2f ", styleRow().choices[style], frame, hair,
                    hair / line);
        if (paper[style] > 0.0)
            std::printf("%8.2f", paper[style] / paper[0]);
        else
            std::printf("%8s", "-");
        std::printf(" %10.3f %10.3f %9.1f\n", errors.mean, errors.greatest, errors.segments);
    }
}

}  // namespace
}  // namespace pelage

int main() {
    pelage::run();
    return 0;
}
