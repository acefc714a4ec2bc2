// frame_view.h -- a view of a document as shaders and level of detail take it.
#pragma once

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/renderer.h"

namespace pelage {

// A key light over the shoulder, so that the animal is lit from wherever it is looked at.
Light studioLight(const Camera& camera);

// From the world to clip space, with room for all that the mirror holds.
mat4 viewProjection(const View& view, const Mirror& mirror);

// The frame of one sample in so many pixels. Samples lie around the centers of pixels; the first
// one is the center itself.
FrameData frameData(const Document& document, const View& view, const Mirror& mirror, int sample,
                    ivec2 pixels);

Sight sightOf(const FrameData& frame);
Fineness finenessOf(const FrameData& frame);

struct Box {  // pixels
    ivec2 lower{0}, upper{0};
};

// That skin and hair stay in.
Box boxOf(const Sight& sight, const Pelt& pelt, const Mirror& mirror);

}  // namespace pelage
