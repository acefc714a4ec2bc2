// accuracy.cpp -- from eye to eye: frames, the reference, their difference.
#include "app/accuracy.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "app/render/frames.h"
#include "app/render/reference_view.h"

namespace pelage {
namespace {

constexpr uint kFirstSamples = 16;  // after which the view has its first figures
constexpr uint kNearSamples = 64;   // at most; a picture full of hair costs more and errs more
constexpr std::size_t kNearEyes = 3;
constexpr float kNearest = 0.25f;  // of the framing distance
constexpr int kCurveEyes = 6;      // each twice as far as the one before
constexpr int kLeastSide = 16;     // pixels

}  // namespace

bool sameSubject(const AccuracySubject& a, const AccuracySubject& b) {
    return a.document == b.document && samePicture(a.view, b.view) && a.options == b.options;
}

ivec2 measuredSize(ivec2 view, int side) {
    const int longer = std::max(view.x, view.y);
    if (side == 0 || longer <= side) return view;
    return glm::max((view * side + longer / 2) / longer, ivec2(kLeastSide));
}

Camera aimedAt(Camera camera, vec3 place) {
    if (camera.orthographic) return camera;
    const float distance = glm::dot(place - camera.eye(), camera.forward());
    if (distance <= 0.0f) return camera;
    camera.target = camera.eye() + distance * camera.forward();
    camera.distance = distance;
    return camera;
}

std::vector<Camera> curveEyes(const Camera& camera, float framingDistance) {
    std::vector<Camera> eyes(1 + kCurveEyes, camera);
    float distance = kNearest * framingDistance;
    for (std::size_t i = 1; i < eyes.size(); ++i, distance *= 2.0f) eyes[i].distance = distance;
    return eyes;
}

double AccuracyPoint::ms() const { return median(live.times); }

bool AccuracyPoint::trusted() const { return noiseShare(errors.rmse, reference) <= kMostNoise; }

void Accuracy::begin(AccuracySubject subject, std::vector<Camera> eyes, Draw draw,
                     std::function<void()> wake) {
    assert(!eyes.empty());
    cancel();
    subject_ = std::move(subject);
    eyes_ = std::move(eyes);
    draw_ = std::move(draw);
    wake_ = std::move(wake);
    state_ = State::measuring;
    old_ = false;
    problem_.clear();
    ++run_;
    eye_ = 0;
    samples_ = 0;
}

void Accuracy::cancel() {
    asked = false;
    if (state_ != State::measuring) return;
    state_ = State::ended;
    work_.cancel();
    draw_ = nullptr;
    drawing_ = nullptr;
    live_.reset();
    scene_.reset();
    picture_.reset();
}

void Accuracy::forget() {
    cancel();
    state_ = State::none;
    old_ = false;
    points_.clear();
    shown = AccuracyPicture::none;
    subject_ = measured_ = {};
}

void Accuracy::follow(const AccuracySubject& now) {
    work_.collect();
    if (state_ == State::none || old_ || sameSubject(subject_, now)) return;
    cancel();
    old_ = true;
    shown = AccuracyPicture::none;
}

View Accuracy::viewAt(std::size_t eye) const {
    View view = subject_.view;
    view.camera = eyes_[eye];
    return view;
}

uint Accuracy::wanted() const {
    const uint samples = subject_.options.samples;
    return eye_ >= 1 && eye_ <= kNearEyes ? std::min(samples, kNearSamples) : samples;
}

void Accuracy::step() {
    if (!drawing()) return;
    if (live_) return trace();
    if (!drawing_) drawing_ = draw_(subject_.document, viewAt(eye_));
    live_ = drawing_();
}

void Accuracy::trace() {
    const uint first = eye_ == 0 ? kFirstSamples : wanted();
    const uint more = std::min(std::max(samples_, first), wanted() - samples_);
    const View view = viewAt(eye_);
    ReferenceView from = referenceView(view);
    from.shadows = subject_.options.traced ? Shadows::traced : Shadows::live;
    auto job = [this, more, from, run = run_, document = subject_.document,
                options = referenceOptions(view), live = *live_, distance = view.camera.distance,
                grown = scene_, begun = picture_](Progress& progress) -> Finish {
        const auto scene =
            grown ? grown : std::make_shared<const ReferenceScene>(document, options, &progress);
        const auto picture = begun ? begun : std::make_shared<ReferencePicture>(scene, from);
        picture->add(more, &progress);
        AccuracyPoint point{distance, live, tracedPicture(*picture, from.size), picture->samples()};
        point.errors = imageErrors(point.live.image, point.reference.image);
        return [this, run, scene, picture, point = std::move(point)] {
            if (run != run_ || state_ != State::measuring) return;
            scene_ = scene;
            picture_ = picture;
            take(point);
        };
    };
    const auto failed = [this, run = run_](const std::string& problem) {
        if (run != run_ || state_ != State::measuring) return;
        cancel();
        problem_ = problem;
    };
    work_.start("measuring", std::move(job), failed, wake_);
}

void Accuracy::take(AccuracyPoint point) {
    const bool last = point.samples >= wanted();
    if (eye_ == 0) {
        points_.clear();
        measured_ = subject_;
        pointsRun_ = run_;
        ++version_;
    }
    samples_ = point.samples;
    points_.push_back(std::move(point));
    if (!last) return;
    drawing_ = nullptr;
    live_.reset();
    picture_.reset();
    samples_ = 0;
    if (++eye_ < eyes_.size()) return;
    cancel();  // nothing is left to hold
    state_ = State::measured;
}

float Accuracy::done() const {
    if (state_ != State::measuring) return 1.0f;
    const float samples = static_cast<float>(samples_) / static_cast<float>(wanted());
    return (static_cast<float>(eye_) + samples) / static_cast<float>(eyes_.size());
}

std::string Accuracy::doing() const {
    if (state_ != State::measuring) return "";
    if (eye_ > 0)
        return "Curve: distance " + std::to_string(eye_) + " of " +
               std::to_string(eyes_.size() - 1);
    if (!live_) return "Drawing the live picture";
    return "Reference: " + std::to_string(samples_) + " of " + std::to_string(wanted()) +
           " samples";
}

}  // namespace pelage
