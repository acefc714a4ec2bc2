// frames.h -- whole pictures from the renderer, and how long a frame takes.
#pragma once

#include <vector>

#include "app/render/renderer.h"

namespace pelage {

// Draws until the picture has converged.
FrameStats drawFinished(Renderer& renderer, const Document& document, const View& view);

// ms of a whole frame, one sample, as it is when the camera moves. Each `turn` is another frame.
double timeFrame(Renderer& renderer, const Document& document, View view, int turn);
// ms of each of `repeat` such frames; a first one that uploads the document is not among them.
std::vector<double> timeFrames(Renderer& renderer, const Document& document, const View& view,
                               int repeat);

double median(std::vector<double> values);  // of at least one value

}  // namespace pelage
