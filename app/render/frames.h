// frames.h -- whole pictures from the renderer, and how long a frame takes.
#pragma once

#include <vector>

#include "app/render/renderer.h"

namespace pelage {

// Draws until the picture has converged.
FrameStats drawFinished(Renderer& renderer, const Document& document, const View& view);

// ms of each of `repeat` whole frames, one sample each, as they are when the camera moves; a first
// frame that uploads the document is not among them.
std::vector<double> timeFrames(Renderer& renderer, const Document& document, View view, int repeat);

double median(std::vector<double> values);  // of at least one value

}  // namespace pelage
