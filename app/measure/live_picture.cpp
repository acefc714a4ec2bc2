// live_picture.cpp -- frames that are timed, the picture over white, the picture over black.
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
    if (turn_ <= timed_) {
        const double ms = timeFrame(renderer, document, view_, turn_);
        if (turn_ > 0) picture_.times.push_back(ms);  // the first one uploads the document
        ++turn_;
        return std::nullopt;
    }
    view_.background = vec3(onWhite_ ? 0.0f : 1.0f);
    picture_.stats = renderer.draw(document, view_);
    if (!picture_.stats.finished) return std::nullopt;
    Image image = linearImage({view_.size, renderer.pixels()});
    if (!onWhite_) {
        onWhite_ = std::move(image);
        return std::nullopt;
    }
    findCoverage(image, *onWhite_);
    picture_.image = std::move(image);
    return std::move(picture_);
}

}  // namespace pelage
