// reference_view.h -- a view of the renderer as the reference takes it, and its picture as bytes.
#pragma once

#include <span>
#include <vector>

#include "app/render/renderer.h"
#include "core/reference.h"

namespace pelage {

// The same camera, size and light; the same skin, coats and moment.
ReferenceView referenceView(const View& view);
ReferenceOptions referenceOptions(const View& view);

// As Renderer::pixels() gives its picture: over the background, display-encoded (sRGB), 4 bytes
// a pixel, first row at the top.
std::vector<unsigned char> displayed(const ReferencePicture& picture, vec3 background);
std::vector<unsigned char> displayed(std::span<const vec4> pixels, vec3 background);

}  // namespace pelage
