// skin_pass.h -- the skin under the fur: color and depth that hairs are drawn over.
#pragma once

#include "app/render/mirror.h"
#include "app/render/program.h"

namespace pelage {

class SkinPass {
public:
    SkinPass();
    // These triangles of a surface into the bound framebuffer, with the frame block and the mirror
    // bound. `shows` where there is an overlay.
    void draw(const Mirror& mirror, const Mirror::Surface& surface, std::span<const Range> ranges,
              bool shows) const;

private:
    Program plain_, textured_, overlay_;
    gl::VertexArray vertexArray_;
};

}  // namespace pelage
