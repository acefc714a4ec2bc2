// renderer.cpp -- the frame: mirror, skin, strands, post.
#include "app/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "app/render/canvas.h"
#include "app/render/capabilities.h"
#include "app/render/check.h"
#include "app/render/coat_choice.h"
#include "app/render/flip_budget.h"
#include "app/render/frame_view.h"
#include "app/render/post_pass.h"
#include "app/render/shell_pass.h"
#include "app/render/skin_pass.h"
#include "app/render/strand_pass.h"
#include "core/pace.h"

namespace pelage {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Linear RGB and alpha where there is nothing.
vec4 behindOf(const View& view) {
    return view.transparent ? vec4(0.0f) : vec4(view.background, 1.0f);
}

// What the picture depends on besides the document. Samples are left out: more of them go on with
// the same picture.
struct PictureKey {
    Camera camera;
    ivec2 size;
    Overlay overlay;
    bool showSkin, showOver, showUnder, culls, coarsens;
    Detail detail;
    Shells shells;
    DrawnAs over, under;
    uint layers;
    bool shellShadows;
    std::array<ShellSource, 2> maps;
    uint segments, sides;
    float tolerance, seconds;
    vec4 behind;
    bool operator==(const PictureKey&) const = default;

    explicit PictureKey(const View& v)
        : camera(v.camera),
          size(v.size),
          overlay(v.overlay),
          showSkin(v.showSkin),
          showOver(v.showOver),
          showUnder(v.showUnder),
          culls(v.culls),
          coarsens(v.coarsens),
          detail(v.detail),
          shells(v.shells),
          over(v.over),
          under(v.under),
          layers(v.layers),
          shellShadows(v.shellShadows),
          maps(v.maps),
          segments(v.segments),
          sides(v.sides),
          tolerance(v.tolerance),
          seconds(v.seconds),
          behind(behindOf(v)) {}
};

// Pixels. Where a frame that is bound by time has to deviate by more it is drawn with half as many
// pixels each way, as few hairs have to be so wide that their pixels cost more than the others
// would; and with all of them again where that deviates by less.
constexpr float kBlurFrom = 4.0f, kSharpFrom = 0.5f;

void begin(PostPass& post, const View& view, const Box& box, ivec2 size) {
    post.begin(behindOf(view), vec2(box.lower) / vec2(size), vec2(box.upper) / vec2(size));
}

// What was drawn of the hair.
struct Sample {
    Coats coats;
    Box box;  // that the hair stays in
    double strandSeconds = 0.0, shellSeconds = 0.0;
    InSight seen{};
    Choice chosen{};
};

// Whether the time of the hair is measured apart from that of the rest.
bool isTimed(const Detail& detail) {
    return detail.milliseconds > 0.0f || detail.rule == Detail::Rule::flip;
}

// Where nothing is automatic but in shells.
Coats asStrands(const View& view) { return coatsOf(view, drawnInShells(view, vec2(0.0f)), 0); }

}  // namespace

bool samePicture(const View& a, const View& b) {
    return PictureKey(a) == PictureKey(b) && a.samples == b.samples && a.posed == b.posed;
}

struct Renderer::Parts {
    Mirror mirror;
    SkinPass skinPass;
    StrandPass strandPass;
    std::optional<ShellPass> shellPass;  // made when it is first needed
    PostPass postPass;
    gl::Buffer frameBlock;
    Canvas fine, coarse;
    Pace finePace, coarsePace;
    FlipBudget flipBudget;
    std::optional<Check> check;
    ivec2 size{0};
    std::optional<PictureKey> key;
    int samples = 0;
    bool single = false;
    bool linesShown = false;
    bool blurred = false;    // the sample in the picture was drawn with fewer pixels
    bool blurs = false;      // the next one is, if it is bound by time
    bool shellsErr = false;  // more than is asked for, where they were chosen in this view
    FrameStats stats;

    void resize(ivec2 wanted) {
        if (wanted == size) return;
        size = wanted;
        fine.resize(size);
        postPass.resize(size);
        samples = 0;
    }

    void drawSkin(const Canvas& canvas, const FrameData& frame, const View& view,
                  const Mirror::Surface& surface);
    Choice choice(const View& view, const FrameData& frame, const Pelt& pelt, const InSight& seen);
    double drawShells(const Document& document, const View& view, FrameData frame, uint coats,
                      const Mirror::Surface& skin, Canvas& canvas);
    // What `choose` takes of what is seen, drawn into a canvas.
    template <typename Choose>
    Sample draw(const Document& document, const View& view, Coats coats, Canvas& canvas, int sample,
                float skinDeviation, const Choose& choose);
    void chooseShells(const Document& document, const View& view);
    void drawSample(const Document& document, const View& view);
    bool mayCheck(const View& view) const;
    void drawCheck(const Document& document, const View& view);
    void count(const Sample& sample);
    void display(const View& view);
};

// Edges of the skin may be off by so many pixels of the canvas.
void Renderer::Parts::drawSkin(const Canvas& canvas, const FrameData& frame, const View& view,
                               const Mirror::Surface& surface) {
    frameBlock.upload(std::span<const FrameData>(&frame, 1));
    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.name());
    glViewport(0, 0, canvas.size.x, canvas.size.y);
    glDepthMask(GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
    const float one = 1.0f;
    const vec4 background = behindOf(view);
    glClearBufferfv(GL_COLOR, 0, &background.x);
    glClearBufferfv(GL_DEPTH, 0, &one);
    std::vector<Range> ranges;
    if (view.showSkin)
        ranges = view.culls ? inView(surface.patches, sightOf(frame)) : allOf(surface.patches);
    stats.trianglesDrawn = 0;
    for (const Range& range : ranges) stats.trianglesDrawn += range.count;
    skinPass.draw(mirror, surface, ranges, view.overlay != Overlay::none);
}

// The detail that is asked for, or as much of it as fits the time.
Choice Renderer::Parts::choice(const View& view, const FrameData& frame, const Pelt& pelt,
                               const InSight& seen) {
    const Sight sight = sightOf(frame);
    const Fineness otherwise = finenessOf(frame);
    const bool budget = view.detail.rule == Detail::Rule::flip;
    const float allowed = budget ? flipBudget.deviationWithin(view.detail.limit, mirror.roots(),
                                                              seen, sight, pelt, otherwise)
                                 : 0.0f;
    float needed = 0.0f;  // to keep to the time
    if (view.detail.milliseconds > 0.0f) {
        const Pace& pace = blurred ? coarsePace : finePace;
        const double work = pace.workWithin(1e-3 * static_cast<double>(view.detail.milliseconds));
        needed = deviationWithin(work, seen, sight, pelt, view.detail, otherwise);
    }
    blurs = needed > (blurred ? kSharpFrom : kBlurFrom);
    const float deviation = std::max(allowed, needed);  // of the pixels that are drawn
    stats.deviation = blurred ? 2.0f * deviation : deviation;
    stats.flip = budget ? flipBudget.flipAt(stats.deviation) : 0.0f;
    stats.flipMeasured = false;
    return choose(mirror.roots(), seen, sight, pelt, view.detail, deviation, otherwise);
}

// Fur in layers, before the skin in the bound framebuffer. Waits for the GPU; answers how long it
// took, s.
double Renderer::Parts::drawShells(const Document& document, const View& view, FrameData frame,
                                   uint coats, const Mirror::Surface& skin, Canvas& canvas) {
    canvas.keepSkinDepth();
    glFinish();
    const auto start = Clock::now();
    if (!shellPass) shellPass.emplace();
    frame.coats = coats;
    shellPass->draw(mirror, skin, document, view, frame, frameBlock, canvas);
    glFinish();
    return secondsSince(start);
}

// Strands come after shells, whose depth is that of the skin to them.
template <typename Choose>
Sample Renderer::Parts::draw(const Document& document, const View& view, Coats coats,
                             Canvas& canvas, int sample, float skinDeviation,
                             const Choose& choose) {
    FrameData frame = frameData(document, view, mirror, sample, canvas.size);
    const auto peltFor = [&](uint bits) {
        return peltOf(document.fur, bits, frame.overWidth, frame.underWidth, document.skin->area,
                      mirror.longestHair());
    };
    Sample drawn{.coats = coats, .box = boxOf(sightOf(frame), peltFor(frame.coats), mirror)};
    const Mirror::Surface& skin = skinDeviation > 0.0f
                                      ? mirror.surface(sightOf(frame), skinDeviation, view.waits)
                                      : mirror.surface();
    drawSkin(canvas, frame, view, skin);
    canvas.furry = false;
    if (coats.shells)
        drawn.shellSeconds = drawShells(document, view, frame, coats.shells, skin, canvas);
    if (!coats.strands) return drawn;
    const Pelt pelt = peltFor(coats.strands);
    const SkinDepth depth =
        strandPass.begin(canvas.depth, frameBlock, canvas.size, drawn.box.lower, drawn.box.upper);
    // The parts of a frame can only be told apart where each waits for the one before.
    const auto start = Clock::now();
    drawn.seen =
        lookAt(mirror.roots(), mirror.tufts(), pelt, sightOf(frame), view.culls ? &depth : nullptr);
    drawn.chosen = choose(frame, pelt, drawn.seen);
    const Fineness& fineness = drawn.chosen.fineness;
    frame.segments = fineness.segments;
    frame.tolerance = fineness.tolerance;
    frame.adapts = fineness.adapts ? 1u : 0u;
    frameBlock.upload(std::span<const FrameData>(&frame, 1));
    strandPass.draw(mirror, document.fur, pelt.coats,
                    planStrands(mirror.roots(), drawn.chosen, fineness.adapts), frameBlock,
                    canvas.color, canvas.depth);
    if (isTimed(view.detail)) glFinish();
    drawn.strandSeconds = secondsSince(start);
    return drawn;
}

// For all samples of a picture.
void Renderer::Parts::chooseShells(const Document& document, const View& view) {
    stats.flipMeasured = false;
    if (!asStrands(view).strands) stats.deviation = stats.flip = 0.0f;
    vec2 better(0.0f);
    if (!shellsErr && (view.over == DrawnAs::automatic || view.under == DrawnAs::automatic))
        better =
            betterInShells(document, view, mirror, frameData(document, view, mirror, 0, view.size));
    stats.inShells = drawnInShells(view, better);
}

void Renderer::Parts::drawSample(const Document& document, const View& view) {
    const auto start = Clock::now();
    blurred = view.detail.milliseconds > 0.0f && blurs;
    if (blurred) coarse.resize((view.size + 1) / 2);
    Canvas& canvas = blurred ? coarse : fine;
    const auto choose = [&](const FrameData& frame, const Pelt& pelt, const InSight& seen) {
        return choice(view, frame, pelt, seen);
    };
    if (samples == 0) chooseShells(document, view);
    // What hair needs to keep to its time or its FLIP is chosen once the skin is drawn: for the
    // skin that of the last frame counts.
    const float last = blurred ? 0.5f * stats.deviation : stats.deviation;
    const bool coarsens = view.coarsens && view.overlay == Overlay::none;
    const float skinDeviation = coarsens ? deviationOf(view.detail, last) : 0.0f;
    const Sample sample = draw(document, view, coatsOf(view, stats.inShells, samples), canvas,
                               samples, skinDeviation, choose);
    if (samples == 0) begin(postPass, view, sample.box, canvas.size);
    if (!single) postPass.accumulate(canvas.color, samples == 0);
    ++samples;
    display(view);
    glFinish();
    stats.seconds = secondsSince(start);
    (blurred ? coarsePace : finePace)
        .learn(sample.chosen.work, sample.strandSeconds, stats.seconds - sample.strandSeconds);
    if (!sample.coats.strands) {
        // Shells are coarser with fewer pixels only.
        const double sharp = (blurred ? 4.0 : 1.0) * sample.shellSeconds;
        blurs = sharp > 1e-3 * static_cast<double>(view.detail.milliseconds);
    }
    count(sample);
}

// Whether the picture, once it is complete, is to be held against that of all hairs. Not where it
// had to keep to a time, nor where that would take too long.
bool Renderer::Parts::mayCheck(const View& view) const {
    return view.detail.rule == Detail::Rule::flip && view.detail.milliseconds == 0.0f &&
           asStrands(view).strands != 0 && !stats.flipMeasured &&
           finePace.secondsOf(flipBudget.workOfAll()) <= view.patience;
}

void Renderer::Parts::drawCheck(const Document& document, const View& view) {
    if (!check) check.emplace();
    check->resize(view.size);
    if (check->samples > samples) check->samples = 0;
    if (check->samples < samples) {
        const auto choose = [&](const FrameData& frame, const Pelt& pelt, const InSight& seen) {
            return pelage::choose(mirror.roots(), seen, sightOf(frame), pelt,
                                  {.rule = Detail::Rule::all}, 0.0f, finenessOf(frame));
        };
        const Sample sample =
            draw(document, view, asStrands(view), check->canvas, check->samples, 0.0f, choose);
        if (check->samples == 0) begin(check->post, view, sample.box, view.size);
        check->add();
        glFinish();
    }
    if (check->samples < samples) return;
    stats.flip = check->errorOf(postPass, fine);
    stats.flipMeasured = true;
    display(view);
    const bool chosen = drawnInShells(view, vec2(0.0f)) != stats.inShells;
    if (chosen) shellsErr = stats.flip > view.detail.limit;
    if (chosen ? shellsErr : flipBudget.learn(view.detail.limit, stats.flip, stats.deviation))
        samples = 0;
}

void Renderer::Parts::count(const Sample& sample) {
    const auto counts = sample.coats.strands ? strandPass.counts() : StrandPass::Counts{};
    stats.hairsTotal = mirror.roots().roots.size();
    stats.hairsTried = counts.tried;
    stats.hairsDrawn = counts.hairs;
    stats.segmentsDrawn = counts.segments;
    stats.clusters = mirror.roots().clusters.size();
    stats.clustersDrawn = sample.chosen.clusters.size();
    stats.clustersOutside = sample.seen.outside;
    stats.clustersHidden = sample.seen.hidden;
    stats.clustersSmall = sample.chosen.small;
    stats.clustersBald = sample.seen.bald;
    stats.shellSeconds = sample.shellSeconds;
    stats.layers = sample.coats.shells ? shellPass->layers() : 0;
    stats.fins = sample.coats.shells ? shellPass->fins() : 0;
    stats.textureBytes = sample.coats.shells ? shellPass->textureBytes() : 0;
    stats.samples = samples;
}

void Renderer::Parts::display(const View& view) {
    const Canvas& canvas = blurred ? coarse : fine;
    postPass.display(samples, canvas.color, view.lines, viewProjection(view, mirror),
                     canvas.depthOfSkin());
}

Renderer::Renderer() {
    requireCapabilities();
    parts_ = std::make_unique<Parts>();
}

Renderer::~Renderer() = default;

FrameStats Renderer::draw(const Document& document, const View& view) {
    if (view.size.x < 1 || view.size.y < 1)
        throw std::runtime_error("a picture of " + std::to_string(view.size.x) + " x " +
                                 std::to_string(view.size.y) + " pixels cannot be drawn");
    Parts& p = *parts_;
    const bool changed = p.mirror.update(document, view.posed);
    const PictureKey key(view);
    const int wanted = std::clamp(view.samples, 1, 1024);
    // A single sample is shown as it is and not kept in the sum, so more of them begin anew.
    const bool single = wanted == 1;
    if (changed || !p.key || !(*p.key == key)) {
        p.samples = 0;
        p.shellsErr = false;
        if (p.check) p.check->samples = 0;
        p.flipBudget.begin();
    }
    if (p.single && !single) p.samples = 0;
    if (p.key && p.key->detail != key.detail) {
        p.blurs = false;
        p.stats.deviation = 0.0f;
    }
    p.key = key;
    p.single = single;
    p.resize(view.size);

    if (p.samples < wanted)
        p.drawSample(document, view);
    else if (p.mayCheck(view))
        p.drawCheck(document, view);
    else if (!view.lines.empty() || p.linesShown)
        p.display(view);
    p.linesShown = !view.lines.empty();
    p.stats.finished = p.samples >= wanted && !p.mayCheck(view);
    return p.stats;
}

unsigned Renderer::texture() const { return parts_->postPass.picture().name(); }

std::vector<unsigned char> Renderer::pixels() const { return parts_->postPass.pixels(); }

std::string Renderer::device() const {
    return std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", " +
           reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

std::size_t Renderer::bytes() const {
    return parts_->mirror.bytes() + parts_->strandPass.bytes() +
           (parts_->shellPass ? parts_->shellPass->bytes() : 0);
}

std::size_t Renderer::bytesPerHair() const { return sizeof(Root); }

}  // namespace pelage
