// live_picture.h -- a picture of the renderer as it is measured, drawn a frame at a time.
#pragma once

#include <optional>
#include <vector>

#include "app/render/renderer.h"
#include "core/image.h"

namespace pelage {

struct LivePicture {
    Image image{};                // linear light over black
    FrameStats stats{};           // of its last frame
    std::vector<double> times{};  // ms of single frames
};

class LiveDrawing {
public:
    // What the view shows but for its background. At least so many frames are timed: those of the
    // picture but for the first, and as many more as it takes.
    LiveDrawing(const View& view, std::size_t timed) : view_(view), timed_(timed) {
        view_.transparent = true;
    }

    // Draws one more frame; the picture with the last of them, nothing before. The document has to
    // be the same each time.
    std::optional<LivePicture> step(Renderer& renderer, const Document& document);

private:
    void drawSample(Renderer& renderer, const Document& document);

    View view_;
    std::size_t timed_;
    int turn_ = 0;
    LivePicture picture_;
};

}  // namespace pelage
