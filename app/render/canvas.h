// canvas.h -- what one sample of a picture is drawn into.
#pragma once

#include "app/render/gl.h"

namespace pelage {

struct Canvas {
    ivec2 size{0};
    gl::Texture color, depth;
    gl::Framebuffer target;

    void resize(ivec2 wanted) {
        if (wanted == size) return;
        size = wanted;
        color = gl::makeTexture(size, GL_RGBA16F);
        glTextureParameteri(color.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        depth = gl::makeTexture(size, GL_DEPTH_COMPONENT32F);
        target = gl::makeFramebuffer(color, &depth);
    }
};

}  // namespace pelage
