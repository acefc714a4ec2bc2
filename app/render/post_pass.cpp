// post_pass.cpp -- from samples in linear light to the picture on screen, and the lines over it.
#include "app/render/post_pass.h"

#include <algorithm>
#include <cstddef>
#include <glm/gtc/packing.hpp>
#include <vector>

#include "app/render/frame_data.h"
#include "core/srgb.h"

namespace pelage {

PostPass::PostPass()
    : accumulate_(Program::draw("screen.vert", "accumulate.frag")),
      display_(Program::draw("screen.vert", "display.frag")),
      lines_(Program::draw("lines.vert", "lines.frag")),
      vertexArray_(gl::makeVertexArray()) {}

void PostPass::resize(ivec2 size) {
    if (size == size_) return;
    size_ = size;
    sum_ = gl::makeTexture(size, GL_RGBA32F);
    picture_ = gl::makeTexture(size, GL_RGBA8);
    glTextureParameteri(picture_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    sumTarget_ = gl::makeFramebuffer(sum_);
    pictureTarget_ = gl::makeFramebuffer(picture_);
}

void PostPass::begin(vec4 background, vec2 lower, vec2 upper) {
    background_.a = background.a;
    for (int i = 0; i < 3; ++i)
        background_[i] = srgbFromLinear(glm::clamp(
            glm::unpackHalf1x16(glm::packHalf1x16(background[i])), 0.0f, 1.0f));  // as samples are
    constexpr int kEdge = 2;  // pixels, of a sample with fewer pixels than the picture
    lower_ = glm::max(ivec2(lower * vec2(size_)) - kEdge, ivec2(0));
    upper_ = glm::min(ivec2(glm::ceil(upper * vec2(size_))) + kEdge, size_);
}

void PostPass::drawBox() const {
    glEnable(GL_SCISSOR_TEST);
    glScissor(lower_.x, lower_.y, upper_.x - lower_.x, upper_.y - lower_.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
}

void PostPass::accumulate(const gl::Texture& sample, bool first) {
    glBindFramebuffer(GL_FRAMEBUFFER, sumTarget_.name());
    glViewport(0, 0, size_.x, size_.y);
    glBindVertexArray(vertexArray_.name());
    glBindTextureUnit(0, sample.name());
    if (!first) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    accumulate_.use();
    glProgramUniform2f(accumulate_.name(), 0, pixel().x, pixel().y);
    drawBox();
    glDisable(GL_BLEND);
}

void PostPass::display(int samples, const gl::Texture& only, std::span<const OverlayLine> lines,
                       const mat4& viewProjection, const gl::Texture& skinDepth) {
    glBindFramebuffer(GL_FRAMEBUFFER, pictureTarget_.name());
    glViewport(0, 0, size_.x, size_.y);
    glClearBufferfv(GL_COLOR, 0, &background_.x);
    glBindVertexArray(vertexArray_.name());
    glBindTextureUnit(0, samples == 1 ? only.name() : sum_.name());
    display_.use();
    glProgramUniform1f(display_.name(), 0, 1.0f / static_cast<float>(samples));
    glProgramUniform2f(display_.name(), 1, pixel().x, pixel().y);
    drawBox();
    if (lines.empty()) return;

    std::vector<vec4> rows;
    rows.reserve(lines.size() * 4);
    for (const OverlayLine& line : lines) {
        rows.insert(rows.end(), {vec4(line.a, 1.0f), line.color, vec4(line.b, 1.0f), line.color});
    }
    lineBuffer_.upload(std::span<const vec4>(rows));
    lineBuffer_.bindStorage(binding::lines);
    glBindTextureUnit(binding::skinDepth, skinDepth.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    lines_.use();
    glProgramUniformMatrix4fv(lines_.name(), 0, 1, GL_FALSE, &viewProjection[0].x);
    glProgramUniform2f(lines_.name(), 1, pixel().x, pixel().y);
    // Near and far are those of the fur; rings and arrows may stick out of it.
    glEnable(GL_DEPTH_CLAMP);
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(2 * lines.size()));
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_BLEND);
}

std::vector<unsigned char> PostPass::pixels() const {
    const std::size_t row = static_cast<std::size_t>(size_.x) * 4;
    std::vector<unsigned char> upward(row * static_cast<std::size_t>(size_.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(picture_.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(upward.size()), upward.data());
    std::vector<unsigned char> downward(upward.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size_.y); ++y)
        std::copy_n(upward.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    downward.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    return downward;
}

}  // namespace pelage
