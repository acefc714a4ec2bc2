// strand_pass.cpp -- hairs over the skin, by a visibility raster in compute shaders.
#include "app/render/strand_pass.h"

#include <algorithm>

namespace pelage {
namespace {

constexpr uint kMostGroups = 65535;  // least value of GL_MAX_COMPUTE_WORK_GROUP_COUNT

void dispatch(uint groups) {
    const uint wide = std::min(groups, kMostGroups);
    if (groups > 0) glDispatchCompute(wide, (groups + wide - 1) / wide, 1);
}

}  // namespace

StrandPass::StrandPass()
    : keyProgram_(Program::compute("depth_keys.comp")),
      depthProgram_(Program::compute("strand_raster.comp", {"DEPTH_PASS"})),
      colorProgram_(Program::compute("strand_raster.comp")) {
    counters_.resize(16);
}

void StrandPass::draw(const Mirror& mirror, const FrameData& frame, const StrandPlan& plan,
                      const gl::Buffer& frameBlock, const gl::Texture& picture,
                      const gl::Texture& skinDepth) {
    const uint pixels = static_cast<uint>(frame.size.x) * static_cast<uint>(frame.size.y);
    if (keys_.bytes() != pixels * sizeof(uint)) keys_.resize(pixels * sizeof(uint));
    if (jobs_.bytes() < plan.jobs.size() * sizeof(StrandPlan::Job))
        jobs_.resize(plan.jobs.size() * sizeof(StrandPlan::Job) * 3 / 2);
    jobs_.write(0, std::span<const StrandPlan::Job>(plan.jobs));
    const uint zero = 0;
    counters_.write(0, std::span<const uint>(&zero, 1));

    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    keys_.bindStorage(binding::keys);
    jobs_.bindStorage(binding::jobs);
    counters_.bindStorage(binding::counters);
    glBindTextureUnit(binding::skinDepth, skinDepth.name());
    glBindImageTexture(0, picture.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);

    const uint groups = static_cast<uint>(plan.jobs.size());
    keyProgram_.use();
    dispatch((pixels + 63) / 64);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    depthProgram_.use();
    dispatch(groups);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    colorProgram_.use();
    dispatch(groups);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::size_t StrandPass::hairsDrawn() const {
    uint drawn = 0;
    glGetNamedBufferSubData(counters_.name(), 0, sizeof drawn, &drawn);
    return drawn;
}

}  // namespace pelage
