// accuracy_steps.cpp -- the verbs of the Accuracy panel, and what goes on beside the work.
#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/accuracy_pictures.h"
#include "app/accuracy_report.h"
#include "app/app.h"
#include "app/render/framing.h"

namespace pelage {
namespace {

constexpr double kRest = 0.15;     // s without change until frames are drawn
constexpr double kPatience = 1.0;  // s until it measures by itself
constexpr double kOften = 0.1;     // s between looks at what a job has done
constexpr double kNever = 1e9;     // s

AccuracySubject subjectOf(const App& app) {
    AccuracySubject subject{app.document(), viewAtRest(app), app.accuracy.options};
    View& view = subject.view;
    view.overlay = Overlay::none;
    view.lines = {};
    view.size = measuredSize(view.size, subject.options.side);
    return subject;
}

// Around what is in the middle of the view, where something is.
std::vector<Camera> eyesOf(const App& app, const View& view) {
    const Viewport& viewport = app.viewport;
    const auto hit = hitAt(app, viewport.corner + 0.5f * viewport.size);
    const Camera camera = hit ? aimedAt(view.camera, hit->position) : view.camera;
    const Skin& skin = app.skin();
    const float aspect = viewport.size.x / viewport.size.y;
    return curveEyes(camera, framed(skin.center(), modelRadius(skin), 0.0f, 0.0f, aspect).distance);
}

void begin(App& app) {
    if (!app.accuracyPictures) app.accuracyPictures = std::make_shared<AccuracyPictures>();
    AccuracySubject subject = subjectOf(app);
    std::vector<Camera> eyes = eyesOf(app, subject.view);
    app.accuracy.begin(std::move(subject), std::move(eyes), app.accuracyPictures->draw(), app.wake);
}

// What is new since it had this state and these pictures.
void traceNews(const App& app, Accuracy::State state, std::size_t version) {
    const Accuracy& accuracy = app.accuracy;
    if (accuracy.version() != version) {
        const AccuracyPoint& view = accuracy.points().front();
        char text[160];
        std::snprintf(text, sizeof text,
                      "accuracy %u samples, flip %.6g rmse %.6g ssim %.6g noise %.6g ms %.6g",
                      view.samples, view.errors.flipMean, view.errors.rmse, view.errors.ssim,
                      static_cast<double>(view.reference.noise.color), view.ms());
        trace(app, text);
    }
    if (accuracy.state() == state) return;
    if (accuracy.state() == Accuracy::State::measured)
        trace(app, "accuracy measured " + std::to_string(accuracy.points().size()));
    if (accuracy.state() == Accuracy::State::ended)
        trace(app, "accuracy ended " + accuracy.problem());
}

}  // namespace

void toggleAccuracy(App& app) {
    Accuracy& accuracy = app.accuracy;
    accuracy.open = !accuracy.open;
    if (accuracy.open) return;
    accuracy.forget();
    app.accuracyPictures.reset();
}

void measureAccuracy(App& app) { app.accuracy.open = app.accuracy.asked = true; }

void cancelAccuracy(App& app) {
    app.accuracy.cancel();
    trace(app, "accuracy ended");
}

void showAccuracy(App& app, AccuracyPicture picture) {
    app.accuracy.shown = picture;
    trace(app, "accuracy shows " + std::to_string(static_cast<int>(picture)));
}

unsigned accuracyTexture(const App& app, AccuracyPicture picture) {
    return app.accuracyPictures->texture(picture);
}

double stepAccuracy(App& app, double rested, bool busy) {
    Accuracy& accuracy = app.accuracy;
    if (!accuracy.open && !accuracy.tracing()) return kNever;
    const auto state = accuracy.state();
    const bool old = accuracy.old();
    const std::size_t version = accuracy.version();
    accuracy.follow(subjectOf(app));
    double wait = kNever;
    if (accuracy.open && accuracy.automatic && !app.moves() &&
        (accuracy.old() || accuracy.state() == Accuracy::State::none)) {
        accuracy.asked = rested >= kPatience;
        if (!accuracy.asked) wait = kPatience - rested;
    }
    try {
        if (rested >= kRest && !busy && app.stats.finished) {
            if (accuracy.asked) begin(app);
            accuracy.step();
        }
        if (app.accuracyPictures) app.accuracyPictures->follow(accuracy, kBackground);
    } catch (const std::exception& error) {
        accuracy.cancel();
        complain(app, error.what());
    }
    const bool news = accuracy.state() != state || accuracy.version() != version;
    if (accuracy.old() && !old) trace(app, "accuracy old");
    traceNews(app, state, version);
    if (news || accuracy.old() != old) return 0.0;  // one more frame, to show it
    if (app.stats.finished && (accuracy.asked || accuracy.drawing())) return 0.0;
    return accuracy.tracing() ? std::min(wait, kOften) : wait;
}

void saveAccuracy(App& app, const std::string& path) {
    try {
        writeAccuracyReport(path, app.accuracy, app.device);
        tell(app, "Saved " + path + " and the pictures beside it");
        trace(app, "saved " + path);
    } catch (const std::exception& error) {
        complain(app, error.what());
    }
}

}  // namespace pelage
