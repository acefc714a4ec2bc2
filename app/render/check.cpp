// check.cpp -- the picture of all hairs that one of fewer is held against.
#include "app/render/check.h"

#include "core/flip.h"
#include "core/pixels.h"

namespace pelage {
namespace {

Image imageOf(PostPass& picture, int samples, const Canvas& last) {
    picture.display(samples, last.color, {}, mat4(1.0f), last.depthOfSkin());
    return linearImage({last.size, picture.pixels()});
}

}  // namespace

void Check::resize(ivec2 size) {
    canvas.resize(size);
    post.resize(size);
}

void Check::add() {
    post.accumulate(canvas.color, samples == 0);
    ++samples;
}

float Check::errorOf(PostPass& picture, const Canvas& last) {
    return static_cast<float>(
        meanOf(flip(imageOf(picture, samples, last), imageOf(post, samples, canvas))));
}

}  // namespace pelage
