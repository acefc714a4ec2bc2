// live_picture.cpp -- frames of a picture, then more of them where more are to be timed.
#include "app/measure/live_picture.h"

#include <chrono>
#include <utility>

#include "app/render/frames.h"
#include "core/pixels.h"

namespace pelage {

std::optional<LivePicture> LiveDrawing::step(Renderer& renderer, const Document& document) {
    if (!picture_.stats.finished) {
        drawSample(renderer, document);
    } else {
        picture_.times.push_back(timeFrame(renderer, document, view_, turn_++));
    }
    if (!picture_.stats.finished || picture_.times.size() < timed_) return std::nullopt;
    return std::move(picture_);
}

void LiveDrawing::drawSample(Renderer& renderer, const Document& document) {
    const int before = picture_.stats.samples;
    const auto start = std::chrono::steady_clock::now();
    picture_.stats = renderer.draw(document, view_);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    // The first one uploads the document; no other one counts without a new sample of the picture;
    // and where that began anew it is with another detail.
    if (picture_.stats.samples < before) picture_.times.clear();
    if (before > 0 && picture_.stats.samples != before) picture_.times.push_back(time.count());
    if (picture_.stats.finished) picture_.image = linearImage({view_.size, renderer.pixels()});
}

}  // namespace pelage
