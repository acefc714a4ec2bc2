// picture.h -- one picture of a document, drawn without a window, and how long a frame takes.
#pragma once

#include <string>
#include <vector>

#include "app/render/headless.h"
#include "app/render/renderer.h"
#include "core/document.h"

namespace pelage {

// The camera that frames the animal with its hair; angles in rad.
Camera framedCamera(const Document& document, float yaw, float pitch, ivec2 size);

// Draws until the picture has converged.
FrameStats drawFinished(Renderer& renderer, const Document& document, const View& view);

// ms of each of `repeat` whole frames, one sample each, as they are when the camera moves; a first
// frame that uploads the document is not among them.
std::vector<double> timeFrames(Renderer& renderer, const Document& document, View view, int repeat);

double median(std::vector<double> values);  // of at least one value

// The picture that was drawn last, into a PNG file.
void writePicture(const std::string& path, const Renderer& renderer, ivec2 size);

}  // namespace pelage
