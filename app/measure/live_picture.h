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
    std::vector<double> times{};  // ms of single frames, as timeFrame
};

class LiveDrawing {
public:
    // What the view shows but for its background, before so many frames that are only timed.
    LiveDrawing(const View& view, int timed) : view_(view), timed_(timed) {}

    // Draws one more frame; the picture with the last of them, nothing before. The document has to
    // be the same each time.
    std::optional<LivePicture> step(Renderer& renderer, const Document& document);

private:
    void drawPicture(Renderer& renderer, const Document& document);

    View view_;
    int timed_, turn_ = 0;
    bool complete_ = false;  // the picture, with its coverage
    LivePicture picture_;
};

}  // namespace pelage
