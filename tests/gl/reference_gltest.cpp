// reference_gltest.cpp -- the live picture of an animal and the traced one of the same hairs.
#include <gtest/gtest.h>

#include <cstdio>

#include "app/render/reference_view.h"
#include "core/animal.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

double meanOf(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
}

// With the occlusion of the live view both pictures hold the same colors of the same hairs:
// texture, tint, light, camera and display agree.
TEST(ReferenceView, ThePictureWithLiveShadowsIsThatOfTheRenderer) {
    Document document = groomedAnimal(5000);
    document.fur.hairs = 10000;
    View view;
    view.size = ivec2(160);
    view.camera = framed(document.skin->center(), 0.6f, 0.6f, 0.2f, 1.0f);
    view.detail.rule = Detail::Rule::all;
    view.segments = 16;
    view.samples = 32;
    Renderer renderer;
    for (const bool orthographic : {false, true}) {
        view.camera.orthographic = orthographic;
        const std::vector<float> live = test::linear(test::picture(renderer, document, view));
        ReferenceView traced = referenceView(view);
        traced.shadows = Shadows::live;
        ReferencePicture picture(
            std::make_shared<const ReferenceScene>(document, referenceOptions(view)), traced);
        picture.add(64);
        const std::vector<float> truth = test::linear(displayed(picture, view.background));
        const double error = test::distanceOf(live, truth),
                     bias = meanOf(live) / meanOf(truth) - 1.0;
        std::printf("error %.4f, bias of the mean %.4f, noise %.4f\n", error, bias,
                    static_cast<double>(picture.noise(view.background).color));
        EXPECT_LT(error, 0.03);
        EXPECT_LT(std::abs(bias), 0.01);
    }
}

}  // namespace
}  // namespace pelage
