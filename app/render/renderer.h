// renderer.h -- the frame: skin, hair, overlays, into a texture that a window or a file shows.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/render/camera.h"
#include "core/detail.h"
#include "core/document.h"
#include "core/shell_source.h"

namespace pelage {

enum class Overlay { none, length, density, direction, mask, segment };

// Fur drawn in layers in place of single hairs: in one pass, whole between two layers or only at
// the layers; or the skin drawn once for each.
enum class Shells { none, swept, plain, instanced };

enum class DrawnAs { strands, shells, fins, automatic };  // of a coat; fins: shells with them

struct OverlayLine {        // drawn over everything, with the depth of the skin tested
    vec3 a{0.0f}, b{0.0f};  // world
    vec4 color{1.0f};       // display RGB, alpha
};

struct View {
    Camera camera;
    ivec2 size{900, 900};  // pixels
    Overlay overlay = Overlay::none;
    bool showSkin = true, showOver = true, showUnder = true;
    uint segments = 8;       // of a polyline, [1, 16]; at most, where the detail is bound by time
    float tolerance = 0.3f;  // pixels by which ribbons, curves and tubes may miss their curve
    uint sides = 0;          // of a tube, [3, 8]; 0 = as many as its width on screen needs
    float seconds = 0.0f;    // how long the wind has blown
    std::shared_ptr<const Skin> posed;  // the document's skin as it stands (pose.h); null = at rest
    Shells shells = Shells::none;       // overlays are shown on single hairs in any case
    DrawnAs over = DrawnAs::shells, under = DrawnAs::shells;  // where there are shells
    uint layers = 0;                  // of shells, [0, 256]; 0 = as many as they need
    bool shellShadows = false;        // of single hairs in shells on hair below them
    std::array<ShellSource, 2> maps;  // what shells of over- and undercoat are cut from
    Detail detail;                    // how many hairs, and how fine
    bool coarsens = true;             // the skin too, where edges may be off; half as far
    bool waits = true;                // for coarser skin to be made; else draws finer till then
    bool culls = true;                // leaves out early what cannot be seen; changes no picture
    int samples = 1;                  // frames that the still picture averages, [1, 1024]
    double patience = 1e9;  // s that a frame of all hairs may take, for the error to be measured
    vec3 background{0.58f, 0.63f, 0.69f};  // linear RGB
    bool transparent = false;              // nothing is behind: the coverage is the alpha
    std::span<const OverlayLine> lines;
    bool operator==(const View&) const = delete;
};

// True if both give the same picture of a document, but for lines.
bool samePicture(const View& a, const View& b);

struct FrameStats {
    std::size_t hairsTotal = 0;  // that grow at density 1
    // The rest up to `seconds` is of the last sample.
    std::size_t hairsTried = 0;     // for which something was done on the GPU, in each pass
    std::size_t hairsDrawn = 0;     // of those, that the skin did not hide
    std::size_t segmentsDrawn = 0;  // of these
    // Triangles near each other with their hair: all are drawn or left out for one of four reasons.
    std::size_t clusters = 0, clustersDrawn = 0, clustersOutside = 0, clustersHidden = 0,
                clustersSmall = 0, clustersBald = 0;
    std::size_t trianglesDrawn = 0;  // of the skin
    float deviation = 0.0f;        // pixels by which it is coarser to keep to its FLIP or its time
    float flip = 0.0f;             // where one is asked for: the error (fidelity.h), as reckoned
    bool flipMeasured = false;     // or as measured, once the picture is complete
    double seconds = 0.0;          // to the end of the GPU's work
    double shellSeconds = 0.0;     // of those, for the shells
    vec2 inShells{0.0f};           // share of overcoat and undercoat in the picture, [0,1]
    uint layers = 0;               // of shells
    uint fins = 0;                 // edges of the skin that have them, counted for each coat
    std::size_t textureBytes = 0;  // of shells: what they are cut from, all levels
    int samples = 0;               // averaged in the picture so far
    bool finished = false;         // nothing will change unless document or view do
};

// Needs a current OpenGL 4.5 context, the same for its whole life. Throws std::runtime_error that
// names the missing capability or the shader, file and line.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws one more sample of the picture. If document and view (apart from lines) are those of
    // the call before, the sample is averaged in until view.samples are reached, and after that
    // only the lines are drawn anew, if they changed. Otherwise the picture begins anew. Where a
    // FLIP is asked for and no time, a complete picture is then held against that of all hairs,
    // drawn aside one sample a call, and begins anew until it has no greater error
    // and uses most of what it may have.
    FrameStats draw(const Document& document, const View& view);

    // The finished picture: RGBA8, display-encoded (sRGB), alpha straight and 1 unless the view is
    // transparent, view.size, first row at the bottom.
    unsigned texture() const;
    // The same as bytes, first row at the top; 4 bytes a pixel.
    std::vector<unsigned char> pixels() const;

    // Renderer and version of the driver, for reports.
    std::string device() const;
    // GPU memory held for the document, bytes: all of it, and the part that is stored per hair.
    std::size_t bytes() const;
    std::size_t bytesPerHair() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace pelage
