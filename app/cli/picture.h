// picture.h -- one picture of a document, drawn without a window.
#pragma once

#include <string>

#include "app/render/frames.h"
#include "app/render/headless.h"
#include "core/document.h"

namespace pelage {

// The picture that was drawn last, into a PNG file.
void writePicture(const std::string& path, const Renderer& renderer, ivec2 size);

}  // namespace pelage
