// renderer.cpp -- the frame: mirror, skin, strands, post.
#include "app/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/post_pass.h"
#include "app/render/skin_pass.h"
#include "app/render/strand_pass.h"
#include "core/pace.h"

namespace pelage {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// What the picture depends on besides the document. Samples are left out: more of them go on with
// the same picture.
struct PictureKey {
    Camera camera;
    ivec2 size;
    Overlay overlay;
    bool showSkin, showOver, showUnder, culls;
    Detail detail;
    uint segments, sides;
    float tolerance, seconds;
    vec3 background;
    bool operator==(const PictureKey&) const = default;

    explicit PictureKey(const View& v)
        : camera(v.camera),
          size(v.size),
          overlay(v.overlay),
          showSkin(v.showSkin),
          showOver(v.showOver),
          showUnder(v.showUnder),
          culls(v.culls),
          detail(v.detail),
          segments(v.segments),
          sides(v.sides),
          tolerance(v.tolerance),
          seconds(v.seconds),
          background(v.background) {}
};

// Sub-pixel offset of a sample, in pixels around the center; the first one is the center itself.
// Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
vec2 sampleOffset(int sample) {
    const double n = sample;
    const auto fraction = [](double x) { return static_cast<float>(x - std::floor(x)) - 0.5f; };
    return {fraction(0.5 + n * 0.7548776662466927), fraction(0.5 + n * 0.5698402909980532)};
}

// What a sample is drawn into.
struct Canvas {
    ivec2 size{0};
    gl::Texture color, depth;
    gl::Framebuffer target;

    void resize(ivec2 wanted) {
        if (wanted == size) return;
        size = wanted;
        color = gl::makeTexture(size, GL_RGBA16F);
        glTextureParameteri(color.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        depth = gl::makeTexture(size, GL_DEPTH_COMPONENT32F);
        target = gl::makeFramebuffer(color, &depth);
    }
};

// Pixels. Where a frame that is bound by time has to deviate by more it is drawn with half as many
// pixels each way, as few hairs have to be so wide that their pixels cost more than the others
// would; and with all of them again where that deviates by less.
constexpr float kBlurFrom = 4.0f, kSharpFrom = 0.5f;
constexpr float kWidest = 26.0f;  // pixels from the middle of a hair to its edge, and some

struct Box {  // pixels
    ivec2 lower{0}, upper{0};
};

Sight sightOf(const FrameData& frame) {
    return {frame.viewProjection,     frame.eye, frame.forward, frame.pixelsPerMetre,
            frame.perspective > 0.0f, frame.size};
}

// OpenGL 4.5 promises fewer storage buffers than the shaders read; every desktop driver has more.
void requireCapabilities() {
    if (epoxy_gl_version() < 45)
        throw std::runtime_error(
            "OpenGL 4.5 is needed, the driver offers " +
            std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION))));
    const struct {
        GLenum limit;
        int needed;
        const char* name;
    } limits[] = {
        {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 16, "storage buffers"},
        {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 15, "storage buffers in a compute shader"},
        {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 6, "storage buffers in a vertex shader"},
        {GL_MAX_COMPUTE_IMAGE_UNIFORMS, 1, "images in a compute shader"},
    };
    for (const auto& [limit, needed, name] : limits) {
        int offered = 0;
        glGetIntegerv(limit, &offered);
        if (offered < needed)
            throw std::runtime_error("the graphics driver offers " + std::to_string(offered) + " " +
                                     name + ", Pelage needs " + std::to_string(needed));
    }
}

}  // namespace

Light studioLight(const Camera& camera) {
    Light light;
    const vec3 toEye(std::sin(camera.yaw), 0.0f, std::cos(camera.yaw));
    light.toKey = glm::normalize(-0.55f * camera.right() + vec3(0.0f, 0.85f, 0.0f) + 0.6f * toEye);
    light.key = 1.45f;
    light.sky = vec3(0.62f, 0.68f, 0.78f);
    light.ground = vec3(0.26f, 0.23f, 0.20f);
    return light;
}

struct Renderer::Parts {
    Mirror mirror;
    SkinPass skinPass;
    StrandPass strandPass;
    PostPass postPass;
    gl::Buffer frameBlock;
    Canvas fine, coarse;
    Pace finePace, coarsePace;
    ivec2 size{0};
    std::optional<PictureKey> key;
    int samples = 0;
    bool single = false;
    bool linesShown = false;
    bool blurred = false;  // the sample in the picture was drawn with fewer pixels
    bool blurs = false;    // the next one is, if it is bound by time
    FrameStats stats;

    void resize(ivec2 wanted) {
        if (wanted == size) return;
        size = wanted;
        fine.resize(size);
        postPass.resize(size);
        samples = 0;
    }

    FrameData frameData(const Document& document, const View& view, int sample, ivec2 pixels) const;
    void drawSkin(const Canvas& canvas, const FrameData& frame, const View& view);
    Box boxOf(const Sight& sight, const Pelt& pelt) const;
    Choice choice(const View& view, const FrameData& frame, const Pelt& pelt, const InSight& seen);
    void drawSample(const Document& document, const View& view);
    void count(const InSight& seen, const Choice& chosen);
    void display(const View& view);
    mat4 viewProjection(const View& view) const;
};

mat4 Renderer::Parts::viewProjection(const View& view) const {
    const float radius = mirror.skin().radius + mirror.longestHair();
    const float aspect = static_cast<float>(view.size.x) / static_cast<float>(view.size.y);
    return view.camera.projection(aspect, mirror.skin().center(), radius) * view.camera.view();
}

FrameData Renderer::Parts::frameData(const Document& document, const View& view, int sample,
                                     ivec2 pixels) const {
    FrameData frame;
    const Camera& camera = view.camera;
    const vec2 offset = 2.0f * sampleOffset(sample) / vec2(pixels);
    mat4 shift(1.0f);
    shift[3] = vec4(offset, 0.0f, 1.0f);
    frame.viewProjection = shift * viewProjection(view);
    frame.eye = camera.eye();
    frame.forward = camera.forward();
    frame.perspective = camera.orthographic ? 0.0f : 1.0f;
    const float halfHeight =
        std::tan(0.5f * camera.fieldOfView) * (camera.orthographic ? camera.distance : 1.0f);
    frame.pixelsPerMetre = 0.5f * static_cast<float>(pixels.y) / halfHeight;
    frame.light = studioLight(camera);
    const bool unit = view.overlay == Overlay::density || view.overlay == Overlay::mask;
    frame.overlayRange = vec2(0.0f, unit ? 1.0f : std::max(mirror.longestHair(), 1e-12f));
    frame.overlay = static_cast<uint>(view.overlay);
    frame.segments = std::clamp(view.segments, 1u, 16u);
    frame.size = pixels;
    const Fur& fur = document.fur;
    frame.overWidth = coatWidth(*document.skin, fur.hairs, fur.over);
    frame.underWidth = coatWidth(*document.skin, fur.hairs, fur.under);
    frame.hairsPerArea =
        document.skin->area > 0.0 ? static_cast<float>(fur.hairs / document.skin->area) : 0.0f;
    frame.coats = (view.showOver ? 1u : 0u) | (view.showUnder ? 2u : 0u);
    frame.seconds = view.seconds;
    frame.tolerance = std::max(view.tolerance, 0.01f);
    frame.sides = view.sides;
    frame.textured = mirror.textured() ? 1u : 0u;
    return frame;
}

// The pixels that skin and hair may reach.
Box Renderer::Parts::boxOf(const Sight& sight, const Pelt& pelt) const {
    const Skin& skin = mirror.skin();
    const float reach = std::max(pelt.reach() * mirror.longestHair(), pelt.clumpReach);
    const Outline outline = outlineOf(sight, skin.lower, skin.upper, reach);
    if (!outline.known) return {ivec2(0), sight.size};
    const vec2 limit(sight.size);
    return {ivec2(glm::clamp(glm::floor(outline.lower - kWidest), vec2(0.0f), limit)),
            ivec2(glm::clamp(glm::ceil(outline.upper + kWidest), vec2(0.0f), limit))};
}

void Renderer::Parts::drawSkin(const Canvas& canvas, const FrameData& frame, const View& view) {
    frameBlock.upload(std::span<const FrameData>(&frame, 1));
    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.name());
    glViewport(0, 0, canvas.size.x, canvas.size.y);
    glDepthMask(GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
    const float one = 1.0f;
    const vec4 background(view.background, 1.0f);
    glClearBufferfv(GL_COLOR, 0, &background.x);
    glClearBufferfv(GL_DEPTH, 0, &one);
    std::vector<Range> ranges;
    if (view.showSkin)
        ranges = view.culls ? inView(mirror.patches(), sightOf(frame)) : allOf(mirror.patches());
    stats.trianglesDrawn = 0;
    for (const Range& range : ranges) stats.trianglesDrawn += range.count;
    skinPass.draw(mirror, ranges, view.overlay != Overlay::none);
}

// The detail that is asked for, or as much of it as fits the time.
Choice Renderer::Parts::choice(const View& view, const FrameData& frame, const Pelt& pelt,
                               const InSight& seen) {
    const Sight sight = sightOf(frame);
    const Fineness otherwise{frame.segments, frame.tolerance, false};
    float deviation = 0.0f;  // of the pixels that are drawn
    if (view.detail.milliseconds > 0.0f) {
        const Pace& pace = blurred ? coarsePace : finePace;
        const double work = pace.workWithin(1e-3 * static_cast<double>(view.detail.milliseconds));
        deviation = deviationWithin(work, seen, sight, pelt, view.detail, otherwise);
    }
    blurs = deviation > (blurred ? kSharpFrom : kBlurFrom);
    stats.deviation = blurred ? 2.0f * deviation : deviation;
    return choose(mirror.roots(), seen, sight, pelt, view.detail, deviation, otherwise);
}

void Renderer::Parts::drawSample(const Document& document, const View& view) {
    const auto start = Clock::now();
    const bool bounded = view.detail.milliseconds > 0.0f;
    blurred = bounded && blurs;
    if (blurred) coarse.resize((view.size + 1) / 2);
    const Canvas& canvas = blurred ? coarse : fine;
    FrameData frame = frameData(document, view, samples, canvas.size);
    const Pelt pelt = peltOf(document.fur, frame.coats, frame.overWidth, frame.underWidth,
                             document.skin->area, mirror.longestHair());
    drawSkin(canvas, frame, view);
    const Box box = boxOf(sightOf(frame), pelt);
    const SkinDepth depth =
        strandPass.begin(canvas.depth, frameBlock, canvas.size, box.lower, box.upper);
    // The parts of a frame can only be told apart where each waits for the one before.
    const auto strandStart = Clock::now();
    const InSight seen =
        lookAt(mirror.roots(), mirror.tufts(), pelt, sightOf(frame), view.culls ? &depth : nullptr);
    const Choice chosen = choice(view, frame, pelt, seen);
    frame.segments = chosen.fineness.segments;
    frame.tolerance = chosen.fineness.tolerance;
    frame.adapts = chosen.fineness.adapts ? 1u : 0u;
    frameBlock.upload(std::span<const FrameData>(&frame, 1));
    strandPass.draw(mirror, document.fur, pelt.coats,
                    planStrands(mirror.roots(), chosen, chosen.fineness.adapts), frameBlock,
                    canvas.color, canvas.depth);
    if (bounded) glFinish();
    const double strandSeconds = secondsSince(strandStart);

    if (samples == 0)
        postPass.begin(view.background, vec2(box.lower) / vec2(canvas.size),
                       vec2(box.upper) / vec2(canvas.size));
    if (!single) postPass.accumulate(canvas.color, samples == 0);
    ++samples;
    display(view);
    glFinish();
    stats.seconds = secondsSince(start);
    (blurred ? coarsePace : finePace)
        .learn(chosen.work, strandSeconds, stats.seconds - strandSeconds);
    count(seen, chosen);
}

void Renderer::Parts::count(const InSight& seen, const Choice& chosen) {
    const StrandPass::Counts counts = strandPass.counts();
    stats.hairsTotal = mirror.roots().roots.size();
    stats.hairsTried = counts.tried;
    stats.hairsDrawn = counts.hairs;
    stats.segmentsDrawn = counts.segments;
    stats.clusters = mirror.roots().clusters.size();
    stats.clustersDrawn = chosen.clusters.size();
    stats.clustersOutside = seen.outside;
    stats.clustersHidden = seen.hidden;
    stats.clustersSmall = chosen.small;
    stats.clustersBald = seen.bald;
    stats.samples = samples;
}

void Renderer::Parts::display(const View& view) {
    const Canvas& canvas = blurred ? coarse : fine;
    postPass.display(samples, canvas.color, view.lines, viewProjection(view), canvas.depth);
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
    if (changed || !p.key || !(*p.key == key) || (p.single && !single)) p.samples = 0;
    if (p.key && p.key->detail != key.detail) p.blurs = false;
    p.key = key;
    p.single = single;
    p.resize(view.size);

    if (p.samples < wanted)
        p.drawSample(document, view);
    else if (!view.lines.empty() || p.linesShown)
        p.display(view);
    p.linesShown = !view.lines.empty();
    p.stats.finished = p.samples >= wanted;
    return p.stats;
}

unsigned Renderer::texture() const { return parts_->postPass.picture().name(); }

std::vector<unsigned char> Renderer::pixels() const {
    const ivec2 size = parts_->size;
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<unsigned char> upward(row * static_cast<std::size_t>(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(upward.size()),
                      upward.data());
    std::vector<unsigned char> downward(upward.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
        std::copy_n(upward.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    downward.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    return downward;
}

std::string Renderer::device() const {
    return std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", " +
           reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

std::size_t Renderer::bytes() const { return parts_->mirror.bytes() + parts_->strandPass.bytes(); }

std::size_t Renderer::bytesPerHair() const { return sizeof(Root); }

}  // namespace pelage
