// live_picture.cpp -- the picture over black, the picture over white, frames that are timed.
#include "app/measure/live_picture.h"

#include <algorithm>
#include <utility>

#include "app/render/frames.h"
#include "core/pixels.h"

namespace pelage {
namespace {

// Coverage: what a white background does not lighten.
void findCoverage(Image& onBlack, const Image& onWhite) {
    for (std::size_t i = 0; i < onBlack.pixels.size(); ++i) {
        const vec3 through = vec3(onWhite.pixels[i]) - vec3(onBlack.pixels[i]);
        onBlack.pixels[i].a =
            std::clamp(1.0f - (through.r + through.g + through.b) / 3.0f, 0.0f, 1.0f);
    }
}

}  // namespace

std::optional<LivePicture> LiveDrawing::step(Renderer& renderer, const Document& document) {
    if (!complete_) {
        drawPicture(renderer, document);
        return std::nullopt;
    }
    const double ms = timeFrame(renderer, document, view_, turn_++);
    if (turn_ > 1) picture_.times.push_back(ms);  // the first one is of another view
    if (turn_ <= timed_) return std::nullopt;
    return std::move(picture_);
}

// Over black, which settles what the detail comes to, then over white with the same hairs.
void LiveDrawing::drawPicture(Renderer& renderer, const Document& document) {
    const bool black = picture_.image.pixels.empty();
    view_.background = vec3(black ? 0.0f : 1.0f);
    if (!black) view_.patience = 0.0;
    const FrameStats stats = renderer.draw(document, view_);
    if (!stats.finished) return;
    Image image = linearImage({view_.size, renderer.pixels()});
    if (black) {
        picture_.image = std::move(image);
        picture_.stats = stats;
        return;
    }
    findCoverage(picture_.image, image);
    complete_ = true;
}

}  // namespace pelage
