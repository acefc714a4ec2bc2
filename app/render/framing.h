// framing.h -- where the camera stands to see a document.
#pragma once

#include "app/render/camera.h"
#include "core/document.h"

namespace pelage {

// Radius of the ball around skin.center() to frame, m: the skin and a coat of usual length.
float modelRadius(const Skin& skin);

// The camera that frames the model with its hair; angles in rad.
Camera framedCamera(const Document& document, float yaw, float pitch, ivec2 size);

// The camera at a share of its distance; a nearer one looks at the skin in the middle of the
// picture.
Camera zoomed(const Document& document, Camera camera, float share);

}  // namespace pelage
