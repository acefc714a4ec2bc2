// measure_gltest.cpp -- the table of techniques, and that their errors fall.
#include "app/measure/measure.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/gl/furry_scenes.h"

namespace pelage {
namespace {

// Hair so wide and so far bent that each value of each knob shows.
Document longHairedBall() {
    Document document = test::furryBall(300);
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 0.0f, 0.5f), 0.6f, vec3(1.0f), 1.0f});
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        coat->relativeLength = 1.0f;
        coat->stiffness = 0.2f;
        coat->width = 0.03f;
    }
    document.fur.gravity = 1.0f;
    return document;
}

View nearView(const Document& document, int side) {
    View view = measuredView();
    view.size = ivec2(side);
    view.camera = framed(document.skin->center(), 1.6f, 0.5f, 0.3f, 1.0f);
    view.camera.distance *= 0.7f;
    return view;
}

const Technique& techniqueNamed(const std::string& name) {
    for (const Technique& technique : techniques())
        if (technique.name == name) return technique;
    throw std::runtime_error("no technique " + name);
}

TEST(Measure, EveryValueOfATechniqueDrawsAnotherPictureThanTheOneBefore) {
    const Document document = longHairedBall();
    Renderer renderer;
    std::set<std::string> names;
    for (const Technique& technique : techniques()) {
        EXPECT_TRUE(names.insert(technique.name).second) << technique.name << " stands twice";
        EXPECT_GT(std::string(technique.leavesOut).size(), 0u);
        test::Pixels before;
        for (std::size_t value = 0; value < technique.values.size(); ++value) {
            Document turned = document;
            View view = nearView(document, 128);
            view.samples = 2;
            technique.turn(value, turned.fur, view);
            const test::Pixels pixels = test::picture(renderer, turned, view);
            EXPECT_TRUE(pixels != before) << technique.name << " " << technique.values[value];
            before = pixels;
        }
    }
}

TEST(Measure, ErrorsOfDrawingFallWithHairsSegmentsAndSamples) {
    const Document document = longHairedBall();
    MeasureOptions options;
    options.size = ivec2(128);
    options.eyes = {{"near", nearView(document, 128).camera}};
    for (const char* name : {"hairs", "segments", "samples"})
        options.techniques.push_back(&techniqueNamed(name));
    options.spp = 64;
    options.repeat = 1;
    const Measurement measurement = measure(document, options);
    ASSERT_EQ(measurement.eyes.size(), 1u);
    const MeasuredEye& eye = measurement.eyes[0];
    ASSERT_EQ(eye.rows.size(), 4u + 5u + 4u);
    for (const Approach& approach : approaches(eye)) {
        std::printf("%s: %.4f to %.4f, noise %.4f\n", approach.technique->name, approach.coarsest,
                    approach.finest, approach.noise);
        EXPECT_TRUE(approach.falls) << approach.technique->name;
        EXPECT_LT(approach.finest, 0.8 * approach.coarsest) << approach.technique->name;
    }
    for (const Measured& row : eye.rows) {
        EXPECT_GT(row.msFrame, 0.0);
        EXPECT_LE(row.msLeast, row.msFrame);
        EXPECT_GE(row.msGreatest, row.msFrame);
        EXPECT_NEAR(row.ms(), row.samples * row.msFrame, 1e-9);
        EXPECT_GT(row.hairsDrawn, 0u);
        EXPECT_GE(row.segmentsDrawn, row.hairsDrawn);
        EXPECT_GT(row.bytes, 0u);
    }
    ASSERT_TRUE(eye.rows[3].drawing.coverage);
    EXPECT_NEAR(eye.rows[3].drawing.coverage->areaRatio, 1.0, 0.02);
    EXPECT_LT(eye.rows[3].drawing.coverage->silhouette, 0.1);
    // Light that is traced is another one.
    ASSERT_EQ(eye.references.size(), 1u);
    EXPECT_NE(eye.references[0].drawing.image.pixels, eye.references[0].light.image.pixels);
    EXPECT_GT(eye.rows[3].light.rmse, eye.rows[3].drawing.rmse);
}

// A view of one technique whose errors are given.
MeasuredEye eyeWith(const std::vector<double>& errors, float noise) {
    MeasuredEye eye;
    eye.references.resize(1);
    eye.references[0].drawing.noise.color = noise;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        Measured row;
        row.technique = &techniques()[0];
        row.value = i;
        row.drawing.rmse = errors[i];
        eye.rows.push_back(std::move(row));
    }
    return eye;
}

TEST(Measure, ErrorsFallExceptByWhatTheNoiseOfTheReferenceAllows) {
    const auto falls = [](const std::vector<double>& errors) {
        return approaches(eyeWith(errors, 0.1f)).at(0).falls;
    };
    EXPECT_TRUE(falls({3.0, 2.0, 2.05, 1.0}));
    EXPECT_FALSE(falls({3.0, 2.0, 2.2, 1.0}));
    EXPECT_TRUE(falls({3.0}));
    MeasuredEye two = eyeWith({1.0, 0.5, 2.0}, 0.1f);
    two.rows[2].technique = &techniques()[1];
    const std::vector<Approach> all = approaches(two);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_TRUE(all[0].falls && all[1].falls);
    EXPECT_EQ(all[0].coarsest, 1.0);
    EXPECT_EQ(all[0].finest, 0.5);
}

TEST(Measure, TheShareOfNoiseIsThatOfTheReference) {
    TracedPicture reference;
    reference.noise.color = 0.5f;
    EXPECT_DOUBLE_EQ(noiseShare(2.0, reference), 0.25);
    EXPECT_GT(noiseShare(0.0, reference), 1e9);
}

}  // namespace
}  // namespace pelage
