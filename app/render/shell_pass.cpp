// shell_pass.cpp -- fur in shells: layers of the same hair that strands are, marched behind each pixel.
#include "app/render/shell_pass.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/render/surface.h"
#include "core/curvature.h"
#include "core/elastica.h"
#include "core/shell_map.h"

namespace pelage {
namespace {

// As in shaders/shell_hair.glsl.
constexpr uint kTileHairs = 1024, kTileSide = 256, kTileLevels = 9;
constexpr float kTileExcess = 1.27f;

uint packed(const RootMap& map, uint number) {
    const auto place = [](float x) { return std::min(static_cast<uint>(x * 2048.0f), 2047u); };
    return place(map.roots[number].x) | place(map.roots[number].y) << 11 | number << 22;
}

// m, side of the tile where so many hairs of a coat stand on a square metre.
float periodOf(float perArea) {
    return std::sqrt(static_cast<float>(kTileHairs) / std::max(kTileExcess * perArea, 1e-12f));
}

}  // namespace

ShellPass::ShellPass()
    : curves_(Program::compute("shell_curves.comp")),
      rodCurves_(Program::compute("shell_curves.comp", {"RODS"})),
      swept_(Program::draw("shell.vert", "shell.frag")),
      sweptTextured_(Program::draw("shell.vert", "shell.frag", {"TEXTURED"})),
      vertexArray_(cornerArray()) {
    rodTable_.upload(std::span(rodTable(), kRodNodes * kRodNodes * kRodTexels));
    makeTile();
}

// Each coarser level has the first half of the roots, which are as evenly spread.
void ShellPass::makeTile() {
    std::vector<uvec2> texels;
    for (uint level = 0; level < kTileLevels; ++level) {
        const int side = static_cast<int>(kTileSide >> (level / 2));
        const RootMap map = rootMap({.side = side, .hairs = kTileHairs >> level});
        for (const RootTexel& texel : map.texels)
            texels.emplace_back(packed(map, texel.nearest), packed(map, texel.next));
    }
    tile_.upload(std::span<const uvec2>(texels));
}

void ShellPass::updateSkin(const Mirror& mirror) {
    if (mirror.shown() == skin_) return;
    skin_ = mirror.shown();
    const std::vector<Curvature> curvatures = curvaturesOf(*skin_);
    curvatures_.upload(std::span<const Curvature>(curvatures));
    vertices_.resize(curvatures.size() * sizeof(ShellVertex));
}

void ShellPass::findCurves(const Mirror& mirror, const Fur& fur) {
    const bool rods = fur.over.droop == kDroopElastica || fur.under.droop == kDroopElastica;
    (rods ? rodCurves_ : curves_).use();
    rodTable_.bindStorage(binding::rodTable);
    vertices_.bindStorage(binding::shellVertices);
    curvatures_.bindStorage(binding::curvatures);
    const auto groups = static_cast<uint>((mirror.skin().vertices.size() + 63) / 64);
    if (groups > 0) glDispatchCompute(std::min(groups, 65535u), (groups + 65534u) / 65535u, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void ShellPass::draw(const Mirror& mirror, const Fur& fur, const View& view, const FrameData& frame,
                     const gl::Buffer& frameBlock) {
    ShellData data;
    data.over = {periodOf(fur.share * frame.hairsPerArea), frame.overWidth, fur.over.taper,
                 fur.over.endRandomness * fur.over.relativeLength};
    data.under = {periodOf((1.0f - fur.share) * frame.hairsPerArea), frame.underWidth,
                  fur.under.taper, fur.under.endRandomness * fur.under.relativeLength};
    data.coats = frame.coats & ((fur.share > 0.0f ? 1u : 0u) | (fur.share < 1.0f ? 2u : 0u));
    if (!(frame.hairsPerArea > 0.0f) || data.coats == 0) return;
    data.layers = view.layers;
    data.leastWidth = view.detail.rule == Detail::Rule::all ? 0.0f : 1.0f;
    block_.upload(std::span<const ShellData>(&data, 1));

    updateSkin(mirror);
    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    block_.bindUniform(binding::shells);
    findCurves(mirror, fur);

    tile_.bindStorage(binding::shellTile);
    drawSurface(vertexArray_, mirror, mirror.surface(), allOf(mirror.surface().patches),
                [&](const Mirror::Part& part) -> const Program& {
                    return part.layer >= 0.0f ? sweptTextured_ : swept_;
                });
}

std::size_t ShellPass::bytes() const {
    return textureBytes() + vertices_.bytes() + curvatures_.bytes() + rodTable_.bytes();
}

}  // namespace pelage
