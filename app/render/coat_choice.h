// coat_choice.h -- which coats of a frame are drawn as strands, and which in shells.
#pragma once

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/renderer.h"

namespace pelage {

// As bits of FrameData::coats.
struct Coats {
    uint strands = 0, shells = 0;
};

// Of overcoat and undercoat, [0,1]: how much of them is better drawn in shells.
vec2 betterInShells(const Document& document, const View& view, const Mirror& mirror,
                    const FrameData& frame);

// How much of them is, where what is automatic has the share that is given.
vec2 drawnInShells(const View& view, vec2 automatic);

// In one sample of a picture each coat is one or the other, and so many samples of all are in
// shells that their mean is as much of both as its share says.
Coats coatsOf(const View& view, vec2 inShells, int sample);

}  // namespace pelage
