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
    bool showSkin, showOver, showUnder, cullByDistance;
    uint segments, sides;
    float share, budget, tolerance, seconds;
    vec3 background;
    bool operator==(const PictureKey&) const = default;

    explicit PictureKey(const View& v)
        : camera(v.camera),
          size(v.size),
          overlay(v.overlay),
          showSkin(v.showSkin),
          showOver(v.showOver),
          showUnder(v.showUnder),
          cullByDistance(v.cullByDistance),
          segments(v.segments),
          sides(v.sides),
          share(v.share),
          budget(v.budget),
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

// Predicts how many hairs fit a budget from what the last frames took.
struct CostModel {
    double perHair = 1e-6, rest = 0.02;  // s

    // From a frame whose parts were timed.
    void learn(std::size_t hairs, double strands, double others) {
        if (hairs > 1000) perHair += 0.5 * (strands / static_cast<double>(hairs) - perHair);
        rest += 0.5 * (others - rest);
    }
    // From a frame that was timed as a whole.
    void learn(std::size_t hairs, double all) {
        const double factor = all / (rest + perHair * static_cast<double>(hairs));
        perHair *= factor;
        rest *= factor;
    }
    float share(float budget, std::size_t hairs) const {
        const double room = std::max(budget - rest, 0.15 * budget);
        return static_cast<float>(room /
                                  (perHair * static_cast<double>(std::max<std::size_t>(hairs, 1))));
    }
};

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

// Below this share of the hairs a frame with a budget is drawn with half as many pixels each way:
// few hairs have to be so wide that their pixels cost more than the others would.
constexpr float kLeastSharp = 0.1f;

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
        {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 15, "storage buffers"},
        {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 13, "storage buffers in a compute shader"},
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
    CostModel fineCost, coarseCost;
    ivec2 size{0};
    std::optional<PictureKey> key;
    int samples = 0;
    bool single = false;
    bool linesShown = false;
    bool blurred = false;  // the sample in the picture was drawn coarsely
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
    // Returns the number of hairs that were tried; with a budget it waits for the GPU.
    StrandPlan plan(const Document& document, const View& view, const FrameData& frame,
                    float share) const;
    std::size_t drawStrands(const Canvas& canvas, const Document& document, const View& view,
                            const FrameData& frame, StrandPlan strands, const CostModel& cost);
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
    if (view.showSkin) skinPass.draw(mirror);
}

StrandPlan Renderer::Parts::plan(const Document& document, const View& view, const FrameData& frame,
                                 float share) const {
    const float over = document.fur.share;
    const float meanWidth = over * frame.overWidth + (1.0f - over) * frame.underWidth;
    return planStrands(mirror.roots(), frame, meanWidth, mirror.longestHair(),
                       std::clamp(view.share, 0.0f, 1.0f) * share, view.cullByDistance);
}

std::size_t Renderer::Parts::drawStrands(const Canvas& canvas, const Document& document,
                                         const View& view, const FrameData& frame,
                                         StrandPlan strands, const CostModel& cost) {
    if (view.budget > 0.0f) {
        const float fitting = cost.share(view.budget, strands.hairs);
        if (fitting < 1.0f) strands = plan(document, view, frame, fitting);
    }
    FrameData withHairs = frame;
    withHairs.hairs = strands.hairs;
    frameBlock.upload(std::span<const FrameData>(&withHairs, 1));
    strandPass.draw(mirror, document.fur, withHairs, strands, frameBlock, canvas.color,
                    canvas.depth);
    if (view.budget > 0.0f) glFinish();
    return strands.hairs;
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
    const auto start = Clock::now();
    const bool changed = p.mirror.update(document, view.posed);
    const PictureKey key(view);
    const int wanted = std::clamp(view.samples, 1, 1024);
    // A single sample is shown as it is and not kept in the sum, so more of them begin anew.
    const bool single = wanted == 1;
    if (changed || !p.key || !(*p.key == key) || (p.single && !single)) p.samples = 0;
    p.key = key;
    p.single = single;
    p.resize(view.size);

    if (p.samples < wanted) {
        const bool bounded = view.budget > 0.0f;
        FrameData frame = p.frameData(document, view, p.samples, p.fine.size);
        StrandPlan strands = p.plan(document, view, frame, 1.0f);
        p.blurred = bounded && p.fineCost.share(view.budget, strands.hairs) < kLeastSharp;
        if (p.blurred) {
            p.coarse.resize((view.size + 1) / 2);
            frame = p.frameData(document, view, p.samples, p.coarse.size);
            strands = p.plan(document, view, frame, 1.0f);
        }
        const Canvas& canvas = p.blurred ? p.coarse : p.fine;
        CostModel& cost = p.blurred ? p.coarseCost : p.fineCost;
        p.drawSkin(canvas, frame, view);
        // The parts of a frame can only be told apart where each waits for the one before.
        if (bounded) glFinish();
        const auto strandStart = Clock::now();
        const std::size_t tried =
            p.drawStrands(canvas, document, view, frame, std::move(strands), cost);
        const double strandSeconds = secondsSince(strandStart);
        if (!single) p.postPass.accumulate(canvas.color, p.samples == 0);
        ++p.samples;
        p.postPass.display(p.samples, canvas.color, view.lines, p.viewProjection(view),
                           canvas.depth);
        glFinish();
        p.stats.seconds = secondsSince(start);
        if (bounded)
            cost.learn(tried, strandSeconds, p.stats.seconds - strandSeconds);
        else
            cost.learn(tried, p.stats.seconds);
        p.stats.hairsTotal = p.mirror.roots().roots.size();
        p.stats.hairsDrawn = p.strandPass.hairsDrawn();
        p.stats.samples = p.samples;
    } else if (!view.lines.empty() || p.linesShown) {
        const Canvas& canvas = p.blurred ? p.coarse : p.fine;
        p.postPass.display(p.samples, canvas.color, view.lines, p.viewProjection(view),
                           canvas.depth);
    }
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
