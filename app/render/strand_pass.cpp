// strand_pass.cpp -- hairs over the skin, by a visibility raster in compute shaders.
#include "app/render/strand_pass.h"

#include <algorithm>
#include <string>

#include "core/elastica.h"
#include "core/strand.h"

namespace pelage {
namespace {

constexpr uint kMostGroups = 65535;  // least value of GL_MAX_COMPUTE_WORK_GROUP_COUNT

void dispatch(uint groups) {
    const uint wide = std::min(groups, kMostGroups);
    if (groups > 0) glDispatchCompute(wide, (groups + wide - 1) / wide, 1);
}

// Keeps some room, so that the buffer is not made anew in every frame of a moving view.
template <typename T>
void replace(gl::Buffer& buffer, const std::vector<T>& values) {
    const std::size_t bytes = values.size() * sizeof(T);
    if (buffer.bytes() < bytes || buffer.bytes() == 0)
        buffer.resize(std::max<std::size_t>(bytes * 3 / 2, sizeof(T)));
    buffer.write(0, std::span<const T>(values));
}

}  // namespace

StrandPass::StrandPass() : keyProgram_(Program::compute("depth_keys.comp")) {
    counters_.resize(16);
}

// Made when a coat first needs them.
const StrandPass::Pair& StrandPass::programsOf(const Coat& coat) {
    const bool shaped = isShapedCoat(coat), rods = coat.droop == kDroopElastica;
    const Kind kind(coat.style, shaped, rods);
    const auto known = programs_.find(kind);
    if (known != programs_.end()) return known->second;
    std::vector<std::string> defines{"STYLE " + std::to_string(coat.style)};
    if (shaped) defines.push_back("SHAPED");
    if (rods) {
        defines.push_back("RODS");
        if (rodTable_.bytes() == 0)
            rodTable_.upload(std::span(rodTable(), kRodNodes * kRodNodes * kRodTexels));
    }
    Program color = Program::compute("strand_raster.comp", defines);
    defines.push_back("DEPTH_PASS");
    Program depth = Program::compute("strand_raster.comp", defines);
    return programs_.emplace(kind, Pair{std::move(depth), std::move(color)}).first->second;
}

// Both coats at once where they are drawn alike.
std::vector<StrandPass::Part> StrandPass::partsOf(const Fur& fur, uint coats) {
    std::vector<Part> parts;
    if (coats & 1u) parts.push_back({&programsOf(fur.over), 1u});
    if (coats & 2u) {
        const Pair* under = &programsOf(fur.under);
        if (!parts.empty() && parts[0].programs == under)
            parts[0].coats |= 2u;
        else
            parts.push_back({under, 2u});
    }
    return parts;
}

void StrandPass::draw(const Mirror& mirror, const Fur& fur, const FrameData& frame,
                      const StrandPlan& plan, const gl::Buffer& frameBlock,
                      const gl::Texture& picture, const gl::Texture& skinDepth) {
    const uint pixels = static_cast<uint>(frame.size.x) * static_cast<uint>(frame.size.y);
    if (keys_.bytes() != pixels * sizeof(uint)) keys_.resize(pixels * sizeof(uint));
    replace(runs_, plan.runs);
    replace(groups_, plan.groups);
    const uint zero = 0;
    counters_.write(0, std::span<const uint>(&zero, 1));

    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    keys_.bindStorage(binding::keys);
    runs_.bindStorage(binding::runs);
    groups_.bindStorage(binding::groups);
    counters_.bindStorage(binding::counters);
    if (rodTable_.bytes() > 0) rodTable_.bindStorage(binding::rodTable);
    glBindTextureUnit(binding::skinDepth, skinDepth.name());
    glBindImageTexture(0, picture.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);

    const uint groups = static_cast<uint>(plan.groups.size());
    keyProgram_.use();
    dispatch((pixels + 63) / 64);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    const std::vector<Part> parts = partsOf(fur, frame.coats);
    for (const Part& part : parts) {
        part.programs->depth.use();
        glUniform1ui(0, part.coats);
        dispatch(groups);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    for (const Part& part : parts) {
        part.programs->color.use();
        glUniform1ui(0, part.coats);
        dispatch(groups);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::size_t StrandPass::hairsDrawn() const {
    uint drawn = 0;
    glGetNamedBufferSubData(counters_.name(), 0, sizeof drawn, &drawn);
    return drawn;
}

}  // namespace pelage
