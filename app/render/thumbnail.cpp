// thumbnail.cpp -- the view of the ball.
#include "app/render/thumbnail.h"

#include "app/render/headless.h"
#include "core/pixels.h"
#include "core/swatch.h"

namespace pelage {
namespace {

// From the left side and a little above: hair runs down and to the right.
View viewOf(const Document& ball) {
    View view;
    view.size = ivec2(kThumbnailSide);
    view.samples = 16;
    view.background = vec3(0.145f, 0.15f, 0.16f);
    view.camera = framed(ball.skin->center(), 1.12f * ball.skin->radius, 1.2f, 0.3f, 1.0f);
    return view;
}

}  // namespace

std::optional<std::vector<std::byte>> Thumbnailer::draw(const Fur& fur) {
    if (fur_ != fur) ball_ = swatch(fur);
    fur_ = fur;
    if (!renderer_.draw(ball_, viewOf(ball_)).finished) return std::nullopt;
    return encodeJpeg(ivec2(kThumbnailSide), renderer_.pixels());
}

}  // namespace pelage
