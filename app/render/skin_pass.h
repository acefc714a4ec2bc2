// skin_pass.h -- the skin under the fur: color and depth that hairs are drawn over.
#pragma once

#include "app/render/mirror.h"
#include "app/render/program.h"

namespace pelage {

class SkinPass {
public:
    SkinPass();
    // Into the bound framebuffer, with the frame block and the mirror bound.
    void draw(const Mirror& mirror) const;

private:
    Program program_;
    gl::VertexArray vertexArray_;
};

}  // namespace pelage
