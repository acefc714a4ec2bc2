// measure.h -- what each way to draw hair costs, and how far its picture is from the reference.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/knobs.h"
#include "core/image_error.h"
#include "core/reference.h"

namespace pelage {

struct MeasureOptions {
    struct Eye {
        std::string name;
        Camera camera;
    };
    std::vector<Eye> eyes;
    std::vector<const Technique*> techniques;
    ivec2 size{320, 320};    // pixels
    uint spp = 256;          // samples of each pixel of a reference
    uint seed = 1;           // of them
    std::size_t repeat = 5;  // frames that are timed, at least
};

// Pictures are linear light over black, of what a display shows: no more than 1.
struct TracedPicture {
    Image image;
    ReferenceNoise noise;  // over black
};
TracedPicture tracedPicture(const ReferencePicture& traced, ivec2 size, std::size_t picture = 0);

struct Measured {  // one value of a knob
    const Technique* technique = nullptr;
    std::size_t value = 0;
    double msFrame = 0.0, msLeast = 0.0, msGreatest = 0.0;  // median and spread of one frame
    std::size_t framesTimed = 0;
    int samples = 0;             // frames in the mean
    std::size_t hairsDrawn = 0;  // that the skin did not hide
    std::size_t segmentsDrawn = 0;
    uint layers = 0;               // of shells, as asked; 0 = as many as they need, or none
    double msShells = 0.0;         // of the last frame
    std::size_t textureBytes = 0;  // of shells
    std::size_t bytes = 0;         // of GPU memory
    Image image{};
    std::size_t reference = 0;  // number of those that it is held against
    ImageErrors drawing{};      // against the reference with the light of the live view
    ImageErrors light{};        // against the reference with traced light

    double ms() const { return samples * msFrame; }  // of the whole picture
};

// What pictures are held against whose hair is lit by one style.
struct References {
    std::optional<uint> style;         // kStyle..., of both coats; none = each its own
    TracedPicture drawing{}, light{};  // with the light of the live view, and with traced light
};

struct MeasuredEye {
    std::string name;
    Camera camera;
    std::vector<References> references{};  // the first of the coats as they are
    std::vector<Measured> rows{};          // technique after technique

    const References& referenceOf(const Measured& row) const { return references[row.reference]; }
};

struct Measurement {
    ivec2 size{0};
    std::size_t triangles = 0, hairs = 0;
    uint spp = 0, seed = 0;
    std::size_t repeat = 0;
    std::string device;  // Renderer::device
    std::vector<MeasuredEye> eyes{};
};

// How near a technique comes in one view.
struct Approach {
    const Technique* technique;
    double coarsest, finest;  // RMSE of drawing
    double noise;             // of the reference of the finest
    bool falls;  // from value to value, except by what the noise of the reference allows
};
std::vector<Approach> approaches(const MeasuredEye& eye);

// The share of an error that may be noise of the reference; above kMostNoise its figure is not
// to be trusted.
double noiseShare(double rmse, const TracedPicture& reference);
inline constexpr double kMostNoise = 0.2;

// Draws each value of each technique from each eye; what is drawn alike is drawn and timed once.
// `tell` is called with what is done next. Needs a current OpenGL context.
Measurement measure(const Document& document, const MeasureOptions& options,
                    const std::function<void(const std::string&)>& tell = {});

}  // namespace pelage
