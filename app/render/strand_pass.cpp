// strand_pass.cpp -- hairs over the skin, by a visibility raster in compute shaders.
#include "app/render/strand_pass.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <string>

#include "core/elastica.h"
#include "core/strand.h"

namespace pelage {
namespace {

// Keeps some room, so that the buffer is not made anew in every frame of a moving view.
void reserve(gl::Buffer& buffer, std::size_t bytes) {
    if (buffer.bytes() < bytes || buffer.bytes() == 0) buffer.resize(bytes * 3 / 2);
}

template <typename T>
void replace(gl::Buffer& buffer, const std::vector<T>& values) {
    reserve(buffer, values.size() * sizeof(T));
    buffer.write(0, std::span<const T>(values));
}

constexpr std::size_t kLists = 4;  // at most two coats, wide and narrow

}  // namespace

StrandPass::StrandPass() : keyProgram_(Program::compute("depth_keys.comp")) {
    counters_.resize(kLists * sizeof(SeenList));
}

// Made when a coat first needs them.
const StrandPass::Pair& StrandPass::programsOf(uint style, const Coat& coat, bool thin) {
    const bool shaped = isShapedCoat(coat), rods = coat.droop == kDroopElastica;
    const bool round = coat.style == kStyleRibbon || coat.style == kStyleTube;
    const Kind kind(style, shaped, rods, round, thin);
    const auto known = programs_.find(kind);
    if (known != programs_.end()) return known->second;
    std::vector<std::string> defines{"STYLE " + std::to_string(style)};
    if (shaped) defines.push_back("SHAPED");
    if (round) defines.push_back("ROUND");
    if (thin) defines.push_back("THIN");
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
void StrandPass::addParts(std::vector<Part>& parts, const Fur& fur, uint coats,
                          const StrandPlan& plan, bool thin) {
    const uint begin = thin ? plan.narrowBegin : 0, end = thin ? plan.end : plan.wideEnd;
    if (begin == end) return;
    const std::size_t before = parts.size();
    for (const uint bit : {1u, 2u}) {
        if (!(coats & bit)) continue;
        const Coat& coat = bit == 1 ? fur.over : fur.under;
        const bool line = thin && plan.thinRibbonsAreLines && coat.style == kStyleRibbon;
        const Pair* programs = &programsOf(line ? kStylePolyline : coat.style, coat, thin);
        if (parts.size() > before && parts.back().programs == programs)
            parts.back().coats |= bit;
        else
            parts.push_back({programs, bit, begin, end});
    }
}

SkinDepth StrandPass::begin(const gl::Texture& skinDepth, const gl::Buffer& frameBlock, ivec2 size,
                            ivec2 lower, ivec2 upper) {
    lower = glm::max(lower, ivec2(0)) / SkinDepth::kTile * SkinDepth::kTile;
    const ivec2 window = glm::min(upper, size) - lower;
    if (window.x < 1 || window.y < 1) return {};
    const int rows = (window.y + SkinDepth::kTile - 1) / SkinDepth::kTile;
    const std::size_t strips = static_cast<std::size_t>(window.x) * static_cast<std::size_t>(rows);
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    if (keys_.bytes() != pixels * sizeof(uint)) keys_.resize(pixels * sizeof(uint));
    const std::size_t most = pixels / SkinDepth::kTile + static_cast<std::size_t>(size.x);
    if (strips_.bytes() != most * sizeof(float)) strips_.resize(most * sizeof(float));
    frameBlock.bindUniform(binding::frame);
    keys_.bindStorage(binding::keys);
    strips_.bindStorage(binding::strips);
    glBindTextureUnit(binding::skinDepth, skinDepth.name());
    keyProgram_.use();
    glUniform4i(0, lower.x, lower.y, window.x, window.y);
    gl::dispatch(static_cast<uint>((strips + 63) / 64));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<float> farthest(strips);
    glGetNamedBufferSubData(strips_.name(), 0, static_cast<GLsizeiptr>(strips * sizeof(float)),
                            farthest.data());
    return SkinDepth(lower, window.x, farthest);
}

void StrandPass::draw(const Mirror& mirror, const Fur& fur, uint coats, const StrandPlan& plan,
                      const gl::Buffer& frameBlock, const gl::Texture& picture,
                      const gl::Texture& skinDepth) {
    std::vector<Part> parts;  // makes what is bound below, when it is first needed
    addParts(parts, fur, coats, plan, false);
    addParts(parts, fur, coats, plan, true);
    replace(runs_, plan.runs);
    replace(groups_, plan.groups);
    counters_.upload(std::span<const SeenList>(std::array<SeenList, kLists>{}));
    tried_ = 0;
    assert(parts.size() <= kLists);
    for (Part& part : parts) {
        part.seen = static_cast<uint>(tried_);
        tried_ += part.end - part.begin;
    }
    reserve(seen_, tried_ * sizeof(uint));

    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    keys_.bindStorage(binding::keys);
    runs_.bindStorage(binding::runs);
    groups_.bindStorage(binding::groups);
    counters_.bindStorage(binding::counters);
    seen_.bindStorage(binding::seen);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, counters_.name());
    if (rodTable_.bytes() > 0) rodTable_.bindStorage(binding::rodTable);
    glBindTextureUnit(binding::skinDepth, skinDepth.name());
    glBindImageTexture(0, picture.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);

    for (uint i = 0; i < parts.size(); ++i) {
        parts[i].programs->depth.use();
        glUniform1ui(0, parts[i].coats);
        glUniform2ui(1, parts[i].begin, parts[i].end);
        glUniform2ui(2, i, parts[i].seen);
        gl::dispatch((parts[i].end - parts[i].begin + 31) / 32);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    for (uint i = 0; i < parts.size(); ++i) {
        parts[i].programs->color.use();
        glUniform1ui(0, parts[i].coats);
        glUniform2ui(2, i, parts[i].seen);
        glDispatchComputeIndirect(static_cast<GLintptr>(i * sizeof(SeenList)));
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

StrandPass::Counts StrandPass::counts() const {
    std::array<SeenList, kLists> lists;
    glGetNamedBufferSubData(counters_.name(), 0, sizeof lists, lists.data());
    Counts counts;
    counts.tried = tried_;
    for (const SeenList& list : lists) {
        counts.hairs += list.count;
        counts.segments += list.segments;
    }
    return counts;
}

}  // namespace pelage
