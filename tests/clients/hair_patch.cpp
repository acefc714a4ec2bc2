// hair_patch.cpp -- writes a patch of hairs as curves, and the coverage that the reference gives it
// from several angles, as JSON for another renderer to hold against: hair_patch OUT.json
#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "core/reference.h"
#include "core/scatter.h"
#include "core/strands_out.h"
#include "tests/core/test_skins.h"

namespace pelage {
namespace {

constexpr float kPixel = 1e-3f;  // m
constexpr uint kSamples = 256, kSegments = 1;

// Hair 2 pixels wide at the root, 64 long, pointed and straight, on half a metre of skin; black, so
// that it is told from white skin.
Document patch() {
    Document document = test::evenDocument(test::sheet(4, glm::scale(mat4(1.0f), vec3(0.5f))));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.3f, 0.0f, 0.2f), 64.0f * kPixel, vec3(1.0f), 1.0f});
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        coat->width = 2.0f * kPixel;
        coat->taper = 1.0f;
        coat->relativeLength = 1.0f;
        coat->ambient = coat->diffuse = coat->specular = vec3(0.0f);
    }
    document.fur.gravity = 0.0f;
    document.fur.hairs = 5000;
    return document;
}

nlohmann::json curvesOf(const Document& document) {
    const Roots roots = scatterRoots(*document.skin, document.fur.hairs, document.fur.seed);
    const Curves curves = growCurves(document, roots, kSegments);
    nlohmann::json hairs = nlohmann::json::array();
    for (std::size_t h = 0; h < curves.root.size(); ++h) {
        nlohmann::json hair = nlohmann::json::array();
        for (uint p = 0; p <= kSegments; ++p) {
            const vec3 at = curves.points[h * curves.pointsPerHair + p];
            const float t = static_cast<float>(p) / static_cast<float>(kSegments);
            hair.push_back({at.x, at.y, at.z, 0.5f * curves.rootWidth[h] * (1.0f - t)});
        }
        hairs.push_back(std::move(hair));
    }
    return hairs;
}

ReferenceView fromAngle(float degrees) {
    const float angle = glm::radians(degrees);
    ReferenceView view;
    view.size = ivec2(96, 64);
    view.forward = vec3(0.0f, -std::cos(angle), -std::sin(angle));
    view.up = glm::cross(view.right, view.forward);
    view.eye = -view.forward;
    view.orthographic = true;
    view.halfHeight = 32.0f * kPixel;
    view.light.sky = view.light.ground = vec3(1.0f);
    view.shadows = Shadows::live;
    return view;
}

std::vector<float> listOf(vec3 v) { return {v.x, v.y, v.z}; }

// Sum over the picture.
double brightness(const std::shared_ptr<const ReferenceScene>& scene, const ReferenceView& view) {
    ReferencePicture picture(scene, view);
    picture.add(kSamples);
    double sum = 0.0;
    for (const vec4& pixel : picture.pixels()) sum += static_cast<double>(pixel.g);
    return sum;
}

void write(const char* path) {
    const Document document = patch();
    ReferenceOptions options;
    options.segments = kSegments;
    const auto scene = std::make_shared<const ReferenceScene>(document, options);
    options.over = options.under = false;
    const auto bald = std::make_shared<const ReferenceScene>(document, options);
    nlohmann::json out{{"hairs", curvesOf(document)}, {"samples", kSamples}};
    for (const float degrees : {10.0f, 45.0f, 70.0f}) {
        const ReferenceView view = fromAngle(degrees);
        out["views"].push_back(
            {{"degrees", degrees},
             {"size", {view.size.x, view.size.y}},
             {"width", 96.0f * kPixel},
             {"eye", listOf(view.eye)},
             {"right", listOf(view.right)},
             {"up", listOf(view.up)},
             {"forward", listOf(view.forward)},
             {"coverage", 1.0 - brightness(scene, view) / brightness(bald, view)}});
    }
    std::ofstream(path) << out;
}

}  // namespace
}  // namespace pelage

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    pelage::write(argv[1]);
    return 0;
}
