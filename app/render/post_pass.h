// post_pass.h -- from samples in linear light to the picture on screen, and the lines over it.
#pragma once

#include <span>
#include <vector>

#include "app/render/gl.h"
#include "app/render/program.h"
#include "app/render/renderer.h"

namespace pelage {

class PostPass {
public:
    PostPass();
    void resize(ivec2 size);
    // Begins a picture that is `background` (linear RGB, alpha) outside of a box, whose corners are
    // given in sizes of the picture.
    void begin(vec4 background, vec2 lower, vec2 upper);
    // Adds one sample; the first one of a picture replaces what was there.
    void accumulate(const gl::Texture& sample, bool first);
    // The mean of the accumulated samples, or `only` where there was a single one; sRGB-encoded,
    // then the lines, into picture().
    void display(int samples, const gl::Texture& only, std::span<const OverlayLine> lines,
                 const mat4& viewProjection, const gl::Texture& skinDepth);

    std::vector<unsigned char> pixels() const;  // of picture(), RGBA8, first row at the top
    const gl::Texture& picture() const { return picture_; }

private:
    vec2 pixel() const { return 1.0f / vec2(size_); }
    void drawBox() const;

    ivec2 size_{0};
    vec4 background_{0.0f, 0.0f, 0.0f, 1.0f};  // sRGB-encoded
    ivec2 lower_{0}, upper_{0};                // pixels
    Program accumulate_, display_, lines_;
    gl::VertexArray vertexArray_;
    gl::Texture sum_, picture_;
    gl::Framebuffer sumTarget_, pictureTarget_;
    gl::Buffer lineBuffer_;
};

}  // namespace pelage
