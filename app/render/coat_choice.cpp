// coat_choice.cpp -- which coats of a frame are drawn as strands, and which in shells.
#include "app/render/coat_choice.h"

#include <algorithm>

#include "app/render/frame_view.h"
#include "core/shell_share.h"

namespace pelage {
namespace {

float shareOf(const Document& document, const View& view, const Mirror& mirror,
              const FrameData& frame, uint bit) {
    const Pelt pelt = peltOf(document.fur, bit, frame.overWidth, frame.underWidth,
                             document.skin->area, mirror.longestHair());
    const Sight sight = sightOf(frame);
    const SkinDepth none;  // only what is outside is left out
    const InSight seen = lookAt(mirror.roots(), mirror.tufts(), pelt, sight, &none);
    const float share = bit == 1u ? document.fur.share : 1.0f - document.fur.share;
    return shellShare(view.detail,
                      coatInView(mirror.roots(), seen, sight, pelt, view.detail, finenessOf(frame),
                                 share, frame.hairsPerArea, mirror.skin().vertices.size()));
}

// Van der Corput's sequence in the middles of as many steps as there are samples, (0,1).
float placeOf(int sample, int samples) {
    float place = 0.0f, digit = 0.5f;
    for (int rest = sample; rest > 0; rest /= 2, digit *= 0.5f)
        if (rest % 2) place += digit;
    return place + 0.5f / static_cast<float>(std::max(samples, 1));
}

}  // namespace

vec2 betterInShells(const Document& document, const View& view, const Mirror& mirror,
                    const FrameData& frame) {
    return {shareOf(document, view, mirror, frame, 1u), shareOf(document, view, mirror, frame, 2u)};
}

vec2 drawnInShells(const View& view, vec2 automatic) {
    if (view.shells == Shells::none || view.overlay != Overlay::none) return vec2(0.0f);
    const auto share = [](DrawnAs as, float chosen) {
        return as == DrawnAs::automatic ? chosen : as == DrawnAs::strands ? 0.0f : 1.0f;
    };
    return {share(view.over, automatic.x), share(view.under, automatic.y)};
}

Coats coatsOf(const View& view, vec2 inShells, int sample) {
    const float place = placeOf(sample, view.samples);
    Coats coats;
    if (view.showOver) (place < inShells.x ? coats.shells : coats.strands) |= 1u;
    if (view.showUnder) (place < inShells.y ? coats.shells : coats.strands) |= 2u;
    return coats;
}

}  // namespace pelage
