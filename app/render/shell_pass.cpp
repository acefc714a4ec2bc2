// shell_pass.cpp -- fur in shells: layers of the same hair that strands are, marched behind each
// pixel.
#include "app/render/shell_pass.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/render/shell_data.h"
#include "app/render/shell_tile.h"
#include "app/render/surface.h"

namespace pelage {
namespace {

constexpr uint kFirstLayers = 32;  // where the skin is drawn once for each and none are asked for

std::vector<std::string> definesFor(const View& view) {
    std::vector<std::string> defines;
    if (view.shells == Shells::plain) defines.emplace_back("PLAIN");
    if (view.shellShadows) defines.emplace_back("SHADOWS");
    return defines;
}

// Coats that have fins, as bits of FrameData::coats.
uint finnedOf(const View& view) {
    return (view.over == DrawnAs::fins ? 1u : 0u) | (view.under == DrawnAs::fins ? 2u : 0u);
}

}  // namespace

ShellPass::ShellPass()
    : over_(Program::draw("shell_over.vert", "shell_over.frag")),
      skin_(Program::draw("shell_over.vert", "shell_over.frag", {"SKIN"})),
      show_(Program::draw("screen.vert", "shell_show.frag")),
      seenOut_(Program::draw("screen.vert", "shell_seen.frag")),
      cornerArray_(cornerArray()) {
    tile_.upload(std::span<const uvec2>(tileTexels()));
    tileRows_ = gl::makeTexture(tile_, GL_RG32UI);
}

void ShellPass::resize(ivec2 size) {
    if (size == size_) return;
    size_ = size;
    hairColor_ = gl::makeTexture(size, GL_RGBA16F);
    hairDepth_ = gl::makeTexture(size, GL_R32F);
    seen_ = gl::makeTexture(size, GL_R8UI);
    for (Peel* each : {&peels_[0], &peels_[1], &visible_}) {
        Peel& peel = *each;
        peel.found = gl::makeTexture(size, GL_RG32UI);
        peel.depth = gl::makeTexture(size, GL_DEPTH_COMPONENT32F);
        peel.target = gl::makeFramebuffer(peel.found, &peel.depth);
        peel.march = gl::makeFramebuffer(hairColor_, &peel.depth);
        glNamedFramebufferTexture(peel.march.name(), GL_COLOR_ATTACHMENT1, hairDepth_.name(), 0);
        const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        glNamedFramebufferDrawBuffers(peel.march.name(), 2, both);
    }
}

// Which triangle of a surface comes next behind each pixel, behind those of the other peel.
void ShellPass::find(const Mirror& mirror, const Program& program, const Mirror::Surface& surface,
                     const Peel& peel, const Peel& before) const {
    const uint none[4] = {};
    const float farthest = 1.0f;
    glClearNamedFramebufferuiv(peel.target.name(), GL_COLOR, 0, none);
    glClearNamedFramebufferfv(peel.target.name(), GL_DEPTH, 0, &farthest);
    glBindFramebuffer(GL_FRAMEBUFFER, peel.target.name());
    glBindTextureUnit(binding::peeled, before.depth.name());
    glBindTextureUnit(binding::shellRows, ground_.drawn().name());
    for (const Range& range : allOf(surface.patches)) {
        glProgramUniform1ui(program.name(), 2, range.first);
        drawSurface(cornerArray_, mirror, surface, std::span(&range, 1), true,
                    [&](const Mirror::Part&) -> const Program& { return program; });
    }
    glBindTextureUnit(binding::shellRows, ground_.vertices().name());
}

// Only the pixels behind which something was found.
void ShellPass::march(const Program& program, const Peel& peel, const Mirror::Surface& surface,
                      const Canvas& canvas) const {
    const vec4 none(0.0f);
    glBindFramebuffer(GL_FRAMEBUFFER, peel.march.name());
    glClearBufferfv(GL_COLOR, 0, &none.x);
    glBindTextureUnit(binding::found, peel.found.name());
    glBindTextureUnit(binding::skinFound, visible_.found.name());
    glBindTextureUnit(binding::foundIndices, surface.rows.name());
    program.use();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NOTEQUAL);
    glDepthRangef(1.0f, 1.0f);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
    glDepthRangef(0.0f, 1.0f);
    glDepthFunc(GL_LESS);

    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.name());
    glBindTextureUnit(binding::hairColor, hairColor_.name());
    glBindTextureUnit(binding::hairDepth, hairDepth_.name());
    show_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_DEPTH_TEST);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

// By shell.frag with these defined.
const ShellPass::March& ShellPass::marchFor(std::vector<std::string> defines) {
    const auto [made, isNew] = marches_.try_emplace(defines);
    if (isNew) {
        made->second.fromOver = Program::draw("screen.vert", "shell.frag", defines);
        defines.emplace_back("SKIN");
        made->second.fromSkin = Program::draw("screen.vert", "shell.frag", defines);
    }
    return made->second;
}

// What is found is marched at once, a pixel at a time and however small its triangle: first below
// the surface over the fur that is nearest, then below what comes next behind it, as long as
// anything does. Then from the skin where that did not look for its fur: where the eye is in the
// fur, and in hollows, whose outer surface lies in other parts of the body.
void ShellPass::drawMarched(const Mirror& mirror, const Mirror::Surface& skin, const Canvas& canvas,
                            const std::vector<std::string>& defines) {
    constexpr std::size_t kMostPeels = 4;
    resize(canvas.size);
    const March& programs = marchFor(defines);
    const uint none = 0;
    const float nearest = 0.0f;
    glClearTexImage(seen_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    glBindImageTexture(0, seen_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R8UI);
    glBindTextureUnit(binding::skinDepth, canvas.depth.name());
    glBindTextureUnit(binding::shellSkinDepth, canvas.skinDepth.name());
    glBindTextureUnit(binding::skinIndices, skin.rows.name());
    glClearNamedFramebufferfv(peels_[1].target.name(), GL_DEPTH, 0, &nearest);
    find(mirror, skin_, skin, visible_, peels_[1]);
    // The driver looks whether anything was found, so that nothing waits for the answer.
    while (anyFound_.size() < kMostPeels) anyFound_.push_back(gl::makeQuery(GL_ANY_SAMPLES_PASSED));
    for (std::size_t i = 0; i < kMostPeels; ++i) {
        const Peel& peel = peels_[i % 2];
        const GLuint query = anyFound_[i].name();
        if (i > 0) glBeginConditionalRender(anyFound_[i - 1].name(), GL_QUERY_WAIT);
        glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
        find(mirror, over_, ground_.furSurface(), peel, peels_[(i + 1) % 2]);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        if (i > 0) glEndConditionalRender();
        glBeginConditionalRender(query, GL_QUERY_WAIT);
        march(programs.fromOver, peel, ground_.furSurface(), canvas);
        glEndConditionalRender();
    }
    leaveOutSeen();
    march(programs.fromSkin, visible_, skin, canvas);
}

void ShellPass::leaveOutSeen() const {
    glBindFramebuffer(GL_FRAMEBUFFER, visible_.target.name());
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    seenOut_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Of the skin as it is: what is there to compare with shares no surface with what it is compared
// to.
void ShellPass::drawLayer(const Mirror& mirror, const Program& program, float t) const {
    glProgramUniform1f(program.name(), 2, t);
    const Mirror::Surface& surface = mirror.surface();
    drawSurface(cornerArray_, mirror, surface, allOf(surface.patches), false,
                [&](const Mirror::Part&) -> const Program& { return program; });
}

void ShellPass::usePicture(const ShellSource& source) {
    const ShellMapData data = mapData(source);
    mapBlock_.upload(std::span<const ShellMapData>(&data, 1));
    mapBlock_.bindUniform(binding::shellMap);
    glBindTextureUnit(binding::shellPicture, pictures_.textureOf(source.texture).name());
    layers_ = std::max(layers_, source.layers);
}

// The last layer lies on the skin, and is to be seen there.
void ShellPass::drawMap(const Mirror& mirror, const ShellSource& source, uint coat) {
    if (!map_) map_ = Program::draw("shell_layer.vert", "shell_map.frag");
    glProgramUniform1ui(map_->name(), 3, coat);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -1.0f);
    for (uint k = 1; k <= source.layers; ++k) {
        glProgramUniform1ui(map_->name(), 4, k);
        drawLayer(mirror, *map_, source.layerAt(k));
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShellPass::drawLayers(const Mirror& mirror, uint coats, const View& view) {
    if (layers_ == 0) layers_ = kFirstLayers;
    std::optional<Program>& program = layer_[view.shellShadows];
    if (!program) program = Program::draw("shell_layer.vert", "shell_layer.frag", definesFor(view));
    for (uint coat = 0; coat < 2; ++coat) {
        if (!(coats >> coat & 1u)) continue;
        glProgramUniform1ui(program->name(), 3, coat);
        for (uint k = 0; k < layers_; ++k)
            drawLayer(mirror, *program,
                      (static_cast<float>(k) + 0.5f) / static_cast<float>(layers_));
    }
}

void ShellPass::drawFins(const std::shared_ptr<const Skin>& atRest, uint coats,
                         const Canvas& canvas) {
    if (!fins_) fins_.emplace();
    fins_->draw(atRest, coats, canvas);
    finned_ = true;
}

void ShellPass::draw(Mirror& mirror, const Mirror::Surface& skin, const Document& document,
                     const View& view, const FrameData& frame, const gl::Buffer& frameBlock,
                     const Canvas& canvas) {
    const Fur& fur = document.fur;
    ShellData data;
    data.over = {tilePeriod(fur.share * frame.hairsPerArea), frame.overWidth, fur.over.taper,
                 fur.over.endRandomness * fur.over.relativeLength};
    data.under = {tilePeriod((1.0f - fur.share) * frame.hairsPerArea), frame.underWidth,
                  fur.under.taper, fur.under.endRandomness * fur.under.relativeLength};
    // Layers move as a whole.
    if (view.shells == Shells::instanced) data.over.stray = data.under.stray = 0.0f;
    data.coats = frame.coats & ((fur.share > 0.0f ? 1u : 0u) | (fur.share < 1.0f ? 2u : 0u));
    data.layers = view.layers;
    data.leastWidth = view.detail.rule == Detail::Rule::all ? 0.0f : 1.0f;
    layers_ = 0;
    textureBytes_ = 0;
    finned_ = false;
    if (!(frame.hairsPerArea > 0.0f) || data.coats == 0) return;
    block_.upload(std::span<const ShellData>(&data, 1));

    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    block_.bindUniform(binding::shells);
    ground_.update(mirror, document, data.coats, frame.seconds, view.waits);
    glBindTextureUnit(binding::shellRows, ground_.vertices().name());
    glBindTextureUnit(binding::cornerRows, ground_.corners().name());
    glBindTextureUnit(binding::shellTile, tileRows_.name());
    uint mapped = 0;
    for (uint coat = 0; coat < 2; ++coat)
        if (view.maps[coat].texture) mapped |= data.coats & 1u << coat;
    data.coats &= ~mapped;
    if (data.coats != 0) {
        textureBytes_ = tile_.bytes();
        layers_ = view.layers;
        block_.write(0, std::span<const ShellData>(&data, 1));
        if (view.shells == Shells::instanced)
            drawLayers(mirror, data.coats, view);
        else
            drawMarched(mirror, skin, canvas, definesFor(view));
        const uint finned = data.coats & finnedOf(view);
        if (finned != 0) drawFins(document.skin, finned, canvas);
    }
    // A photograph shows all of a fur.
    if (mapped == 3u && view.maps[0] == view.maps[1] && view.maps[0].texture->photo) mapped = 1u;
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.name());
    for (uint coat = 0; coat < 2; ++coat) {
        if (!(mapped >> coat & 1u)) continue;
        usePicture(view.maps[coat]);
        data.coats = 1u << coat;
        block_.write(0, std::span<const ShellData>(&data, 1));
        if (view.shells == Shells::instanced)
            drawMap(mirror, view.maps[coat], coat);
        else
            drawMarched(mirror, skin, canvas, {"MAP"});
    }
    textureBytes_ += pictures_.keep(view.maps);
}

std::size_t ShellPass::bytes() const {
    return (fins_ ? fins_->bytes() : 0) + tile_.bytes() + pictures_.bytes() + ground_.bytes();
}

}  // namespace pelage
