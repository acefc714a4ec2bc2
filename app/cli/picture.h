// picture.h -- one picture of a document, drawn without a window.
#pragma once

#include <string>

#include "app/render/frames.h"
#include "app/render/headless.h"
#include "core/document.h"

namespace pelage {

// The camera that frames the animal with its hair; angles in rad.
Camera framedCamera(const Document& document, float yaw, float pitch, ivec2 size);

// The camera at a share of its distance; a nearer one looks at the skin in the middle of the
// picture.
Camera zoomed(const Document& document, Camera camera, float share);

// The picture that was drawn last, into a PNG file.
void writePicture(const std::string& path, const Renderer& renderer, ivec2 size);

}  // namespace pelage
