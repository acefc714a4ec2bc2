// canvas.h -- what one sample of a picture is drawn into.
#pragma once

#include "app/render/gl.h"

namespace pelage {

struct Canvas {
    ivec2 size{0};
    gl::Texture color, depth;
    gl::Texture skinDepth;  // a copy from before fur was drawn into `depth`
    bool furry = false;     // there is such fur
    gl::Framebuffer target;

    void resize(ivec2 wanted) {
        if (wanted == size) return;
        size = wanted;
        color = gl::makeTexture(size, GL_RGBA16F);
        glTextureParameteri(color.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        depth = gl::makeTexture(size, GL_DEPTH_COMPONENT32F);
        skinDepth = {};
        target = gl::makeFramebuffer(color, &depth);
    }

    void keepSkinDepth() {
        if (skinDepth.name() == 0) skinDepth = gl::makeTexture(size, GL_DEPTH_COMPONENT32F);
        glCopyImageSubData(depth.name(), GL_TEXTURE_2D, 0, 0, 0, 0, skinDepth.name(), GL_TEXTURE_2D,
                           0, 0, 0, 0, size.x, size.y, 1);
        furry = true;
    }

    const gl::Texture& depthOfSkin() const { return furry ? skinDepth : depth; }
};

}  // namespace pelage
