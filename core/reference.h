// reference.h -- the slow, right answer: a picture of the same hairs by ray tracing.
//
// Every hair that grows is a round tapered curve of its true width, whatever the style of its coat
// and the distance. What the style decides is how it is lit (shaders/fiber.glsl): ribbons and tubes
// by the normals of their round sides, all others as thin lines by the normal of the hair.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "document.h"
#include "progress.h"

namespace pelage {

struct ReferenceOptions {
    uint segments = 0;     // of each hair, [1, 64]; 0 = as many as its shape needs
    float seconds = 0.0f;  // how long the wind has blown
    bool skin = true, over = true, under = true;  // what there is
    std::shared_ptr<const Skin> posed;  // the document's skin as it stands (pose.h); null = at rest
    std::size_t memory = std::size_t{4} << 30;  // bytes that the hairs may take
};

struct TracedDocument;  // known to the reference only

// A document made ready for rays; it does not change afterwards. May be used from several threads.
class ReferenceScene {
public:
    // Grows every hair and builds its hierarchy. Throws Cancelled, and std::runtime_error that says
    // how much memory the hairs need where that is more than allowed.
    explicit ReferenceScene(const Document& document, const ReferenceOptions& options = {},
                            Progress* progress = nullptr);
    ~ReferenceScene();
    ReferenceScene(const ReferenceScene&) = delete;
    ReferenceScene& operator=(const ReferenceScene&) = delete;

    std::size_t hairs() const;
    uint segments() const;      // of each hair
    std::size_t bytes() const;  // of the hierarchy
    const TracedDocument& traced() const { return *traced_; }

private:
    std::unique_ptr<const TracedDocument> traced_;
};

// How light is kept from a place in the coat.
enum class Shadows {
    // By rays towards the key light and into the hemisphere around the skin's normal. Skin blocks
    // light; a hair blocks the share kStraightShare (fiber.glsl) of it, the rest goes on as
    // scattered light does. The mean over a random coat is what `live` computes.
    traced,
    live  // by the functions of the live view, from the optical depth of the coat
};

// How what a ray meets is lit.
struct Lighting {
    Shadows shadows = Shadows::traced;
    std::optional<uint> style;  // kStyle... by which both coats are lit; none = each by its own
};

struct ReferenceView {
    ivec2 size{900, 900};                                                            // pixels
    vec3 eye{0.0f};                                                                  // world
    vec3 forward{0.0f, 0.0f, -1.0f}, right{1.0f, 0.0f, 0.0f}, up{0.0f, 1.0f, 0.0f};  // unit
    float halfHeight = 0.3f;  // of the picture: m, or in perspective the tangent of half its angle
    bool orthographic = false;
    Light light{};
    Shadows shadows = Shadows::traced;  // as of Lighting
    std::optional<uint> style;
    uint seed = 1;
};

// Root mean square error of a picture, over its pixels.
struct ReferenceNoise {
    float color = 0.0f;  // and over red, green and blue, in linear light
    float coverage = 0.0f;
};

// A picture that gets better with every sample. The same for any number of threads, and however the
// samples are divided among calls of add; in a pixel they are spread evenly (stratified.h).
class ReferencePicture {
public:
    // `more` are further pictures by the same rays, each as it would be alone. Throws
    // std::runtime_error for a size that is not in [1, 16384] each way.
    ReferencePicture(std::shared_ptr<const ReferenceScene> scene, const ReferenceView& view,
                     std::span<const Lighting> more = {});

    // Adds so many samples to each pixel, rounded up to an even number, up to 65536 in all. Throws
    // Cancelled; the picture is then as before the call.
    void add(uint samples, Progress* progress = nullptr);

    uint samples() const { return 2 * ofHalf_; }
    std::size_t rays() const { return rays_; }  // traced so far, shadows among them

    // Mean radiance (linear RGB, times coverage) and coverage of each pixel, first row at the top.
    // Picture 0 is lit as the view says, the others follow.
    std::vector<vec4> pixels(std::size_t picture = 0) const;

    // The error of pixels() over a background that randomness leaves. Samples are taken in two
    // halves A and B that know nothing of each other; the picture is (A + B) / 2, its variance
    // a quarter of the mean of (A - B)^2. Needs samples.
    ReferenceNoise noise(vec3 background, std::size_t picture = 0) const;

private:
    std::shared_ptr<const ReferenceScene> scene_;
    ReferenceView view_;
    std::vector<Lighting> lightings_;  // of the pictures
    std::vector<vec4>
        sums_;         // of the samples of each half: for each pixel A of each picture, then B
    uint ofHalf_ = 0;  // samples
    std::size_t rays_ = 0;
};

}  // namespace pelage
