// accuracy_test.cpp -- measuring a view bit by bit, with pictures that nobody has to draw.
#include "app/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "app/render/reference_view.h"
#include "core/animal.h"

namespace pelage {
namespace {

constexpr ivec2 kSize{24, 16};

AccuracySubject furrySubject() {
    AccuracySubject subject;
    subject.document = groomedAnimal(2000);
    subject.document.fur.hairs = 500;
    const Skin& skin = *subject.document.skin;
    subject.view.camera = framed(skin.center(), skin.radius, 0.5f, 0.2f, 1.5f);
    subject.view.size = kSize;
    subject.options.samples = 32;
    return subject;
}

Image flatImage(ivec2 size, float value) {
    return {size, std::vector<vec4>(pixelCount(size), vec4(value, value, value, 0.5f))};
}

// Draws flat grey in two frames and counts them.
struct Drawer {
    int frames = 0;
    ivec2 size = kSize;

    Accuracy::Draw draw() {
        return [this](const Document&, const View&) -> Accuracy::Drawing {
            return [this, left = 2]() mutable -> std::optional<LivePicture> {
                ++frames;
                if (--left > 0) return std::nullopt;
                return LivePicture{flatImage(size, 0.25f), {}, {3.0, 1.0, 2.0}};
            };
        };
    }
};

void measureOn(Accuracy& accuracy, const AccuracySubject& now) {
    while (accuracy.state() == Accuracy::State::measuring || accuracy.tracing()) {
        accuracy.follow(now);
        accuracy.step();
        std::this_thread::yield();
    }
}

TEST(Accuracy, MeasuresTheViewAndThenTheCurveFromNearToFar) {
    const AccuracySubject subject = furrySubject();
    Drawer drawer;
    Accuracy accuracy;
    accuracy.begin(subject, curveEyes(subject.view.camera, 2.0f), drawer.draw(), [] {});
    EXPECT_FALSE(accuracy.fresh());
    measureOn(accuracy, subject);
    EXPECT_EQ(accuracy.state(), Accuracy::State::measured);
    EXPECT_TRUE(accuracy.fresh());
    const std::vector<AccuracyPoint>& points = accuracy.points();
    ASSERT_EQ(points.size(), 7u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(points[i].ms(), 2.0);
        EXPECT_EQ(points[i].samples, 32u);
        EXPECT_TRUE(std::isfinite(points[i].errors.flipMean));
        const float away = 0.5f * std::exp2(static_cast<float>(i) - 1.0f);
        EXPECT_EQ(points[i].distance, i == 0 ? subject.view.camera.distance : away);
    }
    EXPECT_EQ(drawer.frames, 14);
}

TEST(Accuracy, FiguresAreThoseOfTheReferenceTracedAtOnce) {
    AccuracySubject subject = furrySubject();
    subject.options.traced = true;
    Drawer drawer;
    Accuracy accuracy;
    accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
    measureOn(accuracy, subject);

    ReferenceView from = referenceView(subject.view);
    from.shadows = Shadows::traced;
    ReferencePicture picture(
        std::make_shared<const ReferenceScene>(subject.document, referenceOptions(subject.view)),
        from);
    picture.add(32);
    const TracedPicture reference = tracedPicture(picture, kSize);
    const ImageErrors errors = imageErrors(flatImage(kSize, 0.25f), reference.image);
    ASSERT_EQ(accuracy.points().size(), 1u);
    const AccuracyPoint& view = accuracy.points()[0];
    EXPECT_EQ(view.reference.image.pixels, reference.image.pixels);
    EXPECT_EQ(view.reference.noise.color, reference.noise.color);
    EXPECT_EQ(view.errors.rmse, errors.rmse);
    EXPECT_EQ(view.errors.flipMean, errors.flipMean);
}

TEST(Accuracy, AStepDrawsOneFrameAtMostAndNoneBesideTheReference) {
    const AccuracySubject subject = furrySubject();
    Drawer drawer;
    Accuracy accuracy;
    accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
    while (accuracy.state() == Accuracy::State::measuring) {
        const int before = drawer.frames;
        const bool tracing = accuracy.tracing();
        accuracy.step();
        EXPECT_LE(drawer.frames, before + (tracing ? 0 : 1));
        accuracy.follow(subject);
    }
}

TEST(Accuracy, WhatChangesMakesItOldUntilItIsMeasuredAgain) {
    const AccuracySubject subject = furrySubject();
    std::vector<AccuracySubject> others(4, subject);
    others[0].view.camera.yaw += 0.1f;
    others[1].document.groom.fur.edit(3).density = 0.5f;
    others[2].document.fur.over.stiffness += 0.1f;
    others[3].options.traced = true;
    for (const AccuracySubject& other : others) {
        Drawer drawer;
        Accuracy accuracy;
        accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
        measureOn(accuracy, subject);
        accuracy.shown = AccuracyPicture::reference;
        accuracy.follow(subject);
        EXPECT_FALSE(accuracy.old());
        accuracy.follow(other);
        EXPECT_TRUE(accuracy.old());
        EXPECT_FALSE(accuracy.fresh());
        EXPECT_EQ(accuracy.shown, AccuracyPicture::none);
        EXPECT_EQ(accuracy.points().size(), 1u) << "old figures can still be read";
        accuracy.follow(subject);
        EXPECT_TRUE(accuracy.old());
        accuracy.begin(other, {other.view.camera}, drawer.draw(), [] {});
        EXPECT_FALSE(accuracy.fresh()) << "figures are those of before";
        measureOn(accuracy, other);
        EXPECT_TRUE(accuracy.fresh());
    }
}

TEST(Accuracy, AChangeEndsIt) {
    const AccuracySubject subject = furrySubject();
    AccuracySubject other = subject;
    other.view.camera.distance *= 2.0f;
    Drawer drawer;
    Accuracy accuracy;
    accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
    accuracy.step();
    accuracy.follow(other);
    EXPECT_EQ(accuracy.state(), Accuracy::State::ended);
    accuracy.step();
    EXPECT_EQ(drawer.frames, 1);
}

TEST(Accuracy, ACancelledJobLeavesNoTraceInTheNextRun) {
    AccuracySubject endless = furrySubject();
    endless.options.samples = 65536;
    const AccuracySubject subject = furrySubject();
    Drawer drawer;
    Accuracy accuracy;
    accuracy.begin(endless, {endless.view.camera}, drawer.draw(), [] {});
    while (!accuracy.tracing() || accuracy.points().empty()) {
        accuracy.step();
        accuracy.follow(endless);
    }
    accuracy.cancel();
    EXPECT_EQ(accuracy.state(), Accuracy::State::ended);
    EXPECT_EQ(accuracy.problem(), "");
    accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
    measureOn(accuracy, subject);
    EXPECT_EQ(accuracy.state(), Accuracy::State::measured);
    EXPECT_EQ(accuracy.points()[0].samples, 32u);
    EXPECT_EQ(accuracy.subject().options.samples, 32u);
}

TEST(Accuracy, AProblemEndsItAndIsTold) {
    const AccuracySubject subject = furrySubject();
    Drawer drawer{.size = {8, 8}};
    Accuracy accuracy;
    accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
    measureOn(accuracy, subject);
    EXPECT_EQ(accuracy.state(), Accuracy::State::ended);
    EXPECT_EQ(accuracy.problem(), "8x8 pixels, the reference has 24x16");
    EXPECT_TRUE(accuracy.points().empty());
}

TEST(Accuracy, ForgettingItLeavesNothing) {
    const AccuracySubject subject = furrySubject();
    Drawer drawer;
    Accuracy accuracy;
    accuracy.begin(subject, {subject.view.camera}, drawer.draw(), [] {});
    measureOn(accuracy, subject);
    accuracy.forget();
    EXPECT_EQ(accuracy.state(), Accuracy::State::none);
    EXPECT_TRUE(accuracy.points().empty());
    EXPECT_EQ(accuracy.subject().document.skin, nullptr);
}

TEST(Accuracy, PicturesFitTheSideAndKeepTheirShape) {
    EXPECT_EQ(measuredSize({1600, 900}, 320), ivec2(320, 180));
    EXPECT_EQ(measuredSize({300, 900}, 320), ivec2(107, 320));
    EXPECT_EQ(measuredSize({1600, 900}, 0), ivec2(1600, 900));
    EXPECT_EQ(measuredSize({200, 100}, 320), ivec2(200, 100));
    EXPECT_EQ(measuredSize({4000, 40}, 320), ivec2(320, 16));
}

TEST(Accuracy, ACameraThatIsAimedSeesTheSame) {
    Camera camera{.target = vec3(0.1f, 0.2f, 0.3f), .distance = 2.0f, .yaw = 0.7f, .pitch = 0.3f};
    const vec3 place = camera.eye() + 1.5f * camera.forward();
    const Camera aimed = aimedAt(camera, place);
    EXPECT_LT(glm::distance(aimed.eye(), camera.eye()), 1e-6f);
    EXPECT_EQ(aimed.forward(), camera.forward());
    EXPECT_LT(glm::distance(aimed.target, place), 1e-6f);
    EXPECT_NEAR(aimed.distance, 1.5f, 1e-6f);
    camera.orthographic = true;
    EXPECT_EQ(aimedAt(camera, place), camera);
}

}  // namespace
}  // namespace pelage
