// accuracy.h -- what the live picture's shortcuts cost in one view, measured bit by bit.
//
// Frames are drawn on the main thread, one in each step; the reference and the errors are a job
// beside it. The first eye is the view itself, the others make the curve over the distance.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/live_picture.h"
#include "app/measure/measure.h"
#include "app/work.h"

namespace pelage {

// What a person chooses.
struct AccuracyOptions {
    uint samples = 256;   // of each pixel of the reference, an even number
    bool traced = false;  // its light is traced by rays, else that of the live view
    int side = 320;       // pixels that a picture has at most each way; 0 = those of the view
    bool operator==(const AccuracyOptions&) const = default;
};

struct AccuracySubject {
    Document document;
    View view;  // what to draw, but for its camera where there are other eyes
    AccuracyOptions options;
};
// True if both would be measured alike.
bool sameSubject(const AccuracySubject& a, const AccuracySubject& b);

// The size of the pictures for a view of this size.
ivec2 measuredSize(ivec2 view, int side);

// The camera that sees the same but turns around, and comes closer to, this place; not of
// a parallel view, where what is seen depends on the distance.
Camera aimedAt(Camera camera, vec3 place);

// The camera itself, then at 1/4 to 8 times the distance that frames the model, from near to far.
std::vector<Camera> curveEyes(const Camera& camera, float framingDistance);

struct AccuracyPoint {
    float distance = 0.0f;  // m, of the camera
    LivePicture live{};
    TracedPicture reference{};
    uint samples = 0;  // of the reference so far
    ImageErrors errors{};

    double ms() const;     // of a live frame
    bool trusted() const;  // the noise of the reference is small against the error
};

// The pictures of the view.
enum class AccuracyPicture { none, live, reference, heat };

class Accuracy {
public:
    // Draws one more frame of a picture; the picture with the last one.
    using Drawing = std::function<std::optional<LivePicture>()>;
    using Draw = std::function<Drawing(const Document&, const View&)>;
    enum class State { none, measuring, ended, measured };  // ended: given up before it was done

    // Chosen in the panel.
    AccuracyOptions options;
    bool open = false;                              // the panel is there
    bool automatic = false;                         // measures by itself
    bool asked = false;                             // to begin as soon as the hand rests
    AccuracyPicture shown = AccuracyPicture::none;  // in place of the window's picture

    // Begins anew; what was measured stays until there are new figures. `wake` is called from
    // another thread when step() has something to do.
    void begin(AccuracySubject subject, std::vector<Camera> eyes, Draw draw,
               std::function<void()> wake);
    // One small piece of work: at most one frame.
    void step();
    void cancel();
    // Gives up what was measured as well.
    void forget();
    // Once a frame: takes over what the job has finished. If what was begun last is not `now` it is
    // old until the next begin(); measuring it ends, and no picture is shown.
    void follow(const AccuracySubject& now);

    // Of what was begun last.
    State state() const { return state_; }
    bool old() const { return old_; }
    // The points are of it, and it is not old.
    bool fresh() const { return !old_ && !points_.empty() && pointsRun_ == run_; }
    bool drawing() const { return state_ == State::measuring && !work_.running(); }
    bool tracing() const { return work_.running(); }
    float done() const;                                      // share of the work, [0,1]
    std::string doing() const;                               // in words
    const std::string& problem() const { return problem_; }  // why it ended; empty if by choice

    // So far, the view itself first. Those of an earlier subject until the first is there.
    const std::vector<AccuracyPoint>& points() const { return points_; }
    const AccuracySubject& subject() const { return measured_; }  // of the points
    std::size_t version() const { return version_; }  // another one, other pictures of the view

private:
    View viewAt(std::size_t eye) const;
    uint wanted() const;  // samples of this eye's reference
    void trace();
    void take(AccuracyPoint point);

    AccuracySubject subject_, measured_;
    std::vector<Camera> eyes_;
    Draw draw_;
    std::function<void()> wake_;
    State state_ = State::none;
    bool old_ = false;
    std::string problem_;
    std::vector<AccuracyPoint> points_;
    std::size_t version_ = 0, run_ = 0, pointsRun_ = 0;

    std::size_t eye_ = 0;  // that is being measured
    uint samples_ = 0;     // of its reference
    Drawing drawing_;
    std::optional<LivePicture> live_;
    std::shared_ptr<const ReferenceScene> scene_;
    std::shared_ptr<ReferencePicture> picture_;
    Work work_;  // last: its thread ends before the rest goes
};

}  // namespace pelage
