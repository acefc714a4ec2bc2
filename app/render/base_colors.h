// base_colors.h -- the base-color pictures of a source as one array texture.
#pragma once

#include <vector>

#include "app/render/gl.h"
#include "core/source.h"

namespace pelage {

struct MaterialData {  // as Material in shaders/frame.glsl
    vec3 color{1.0f};
    float layer = -1.0f;
};

struct BaseColors {
    gl::Texture texture;                  // RGBA8 sRGB, one layer a picture, repeating; never empty
    std::vector<MaterialData> materials;  // those of the source, then a white one for "none"
};

// Pictures are decoded and scaled to a common size: the largest, at most 2048, and less where there
// are so many that the array would take over 256 MB. One that cannot be decoded, whose header
// promises more pixels than its bytes can hold, or that is past the 2048th counts as white.
BaseColors makeBaseColors(const Source& source);

}  // namespace pelage
