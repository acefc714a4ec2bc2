// shell_pass.cpp -- fur in shells: layers of the same hair that strands are, marched behind each
// pixel.
#include "app/render/shell_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/render/surface.h"
#include "core/curvature.h"
#include "core/elastica.h"
#include "core/shell_map.h"
#include "core/strand.h"

namespace pelage {
namespace {

// As in shaders/shell_hair.glsl.
constexpr uint kTileHairs = 1024, kTileSide = 256, kTileLevels = 9;
constexpr float kTileExcess = 1.28f;

// The uniform block of shaders/shell_data.glsl, as C++.
struct ShellCoat {
    float period = 1.0f, width = 0.0f, taper = 0.0f, stray = 0.0f;
};
struct ShellData {
    ShellCoat over, under;
    uint layers = 0;
    float leastWidth = 1.0f;
    uint coats = 3;
    uint pad0 = 0;
};
static_assert(sizeof(ShellData) == 48);

// As in shaders/shell.vert, and the bytes of a ShellVertex of shaders/shell_data.glsl.
struct RestVertex {
    vec3 position{0.0f};
    uint pad0 = 0;
    vec4 turn{0.0f, 0.0f, 0.0f, 1.0f};
};
static_assert(sizeof(RestVertex) == 32 && sizeof(Curvature) == 32);
constexpr std::size_t kShellVertexBytes = 96;

// The uniform block of shaders/shell_map.glsl, as C++.
struct ShellMapData {
    vec4 tones{0.0f};
    float side = 1.0f, gap = 1.0f;
    uint layers = 1, coat = 0, photo = 0, pad0 = 0;
    float coverage = 1.0f, taper = 1.0f;
};
static_assert(sizeof(ShellMapData) == 48);

constexpr uint kFirstLayers = 32;  // where the skin is drawn once for each and none are asked for

uint packed(const RootMap& map, uint number) {
    const auto place = [](float x) { return std::min(static_cast<uint>(x * 2048.0f), 2047u); };
    return place(map.roots[number].x) | place(map.roots[number].y) << 11 | number << 22;
}

// m, side of the tile where so many hairs of a coat stand on a square metre.
float periodOf(float perArea) {
    return std::sqrt(static_cast<float>(kTileHairs) / std::max(kTileExcess * perArea, 1e-12f));
}

// Tangent, normal and binormal of a vertex, the tangent towards the first of its ring.
mat3 axesAt(const Skin& skin, uint v) {
    const vec3 n = safeUnit(skin.vertices[v].normal, vec3(0.0f, 1.0f, 0.0f));
    vec3 along = anyTangent(n);
    if (!skin.ring(v).empty())
        along = skin.vertices[skin.ring(v)[0]].position - skin.vertices[v].position;
    const vec3 t = safeUnit(along - glm::dot(along, n) * n, anyTangent(n));
    return {t, n, glm::cross(t, n)};
}

RestVertex restOf(const Skin& shown, const Skin& atRest, uint v) {
    RestVertex rest;
    rest.position = atRest.vertices[v].position;
    if (&shown == &atRest) return rest;
    const glm::quat turn = glm::quat_cast(axesAt(atRest, v) * glm::transpose(axesAt(shown, v)));
    rest.turn = vec4(turn.x, turn.y, turn.z, turn.w);
    return rest;
}

}  // namespace

ShellPass::ShellPass()
    : curves_(Program::compute("shell_curves.comp")),
      rodCurves_(Program::compute("shell_curves.comp", {"RODS"})),
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

void ShellPass::updateSkin(const Mirror& mirror, const Skin& atRest) {
    if (mirror.shown() == skin_) return;
    skin_ = mirror.shown();
    const std::vector<Curvature> curvatures = curvaturesOf(*skin_);
    curvatures_.upload(std::span<const Curvature>(curvatures));
    vertices_.resize(curvatures.size() * kShellVertexBytes);
    std::vector<RestVertex> rest(curvatures.size());
    for (uint v = 0; v < rest.size(); ++v) rest[v] = restOf(*skin_, atRest, v);
    rest_.upload(std::span<const RestVertex>(rest));
}

void ShellPass::findCurves(const Mirror& mirror, const Fur& fur) {
    const bool rods = fur.over.droop == kDroopElastica || fur.under.droop == kDroopElastica;
    (rods ? rodCurves_ : curves_).use();
    rodTable_.bindStorage(binding::rodTable);
    vertices_.bindStorage(binding::shellVertices);
    const auto groups = static_cast<uint>((mirror.skin().vertices.size() + 63) / 64);
    if (groups > 0) glDispatchCompute(std::min(groups, 65535u), (groups + 65534u) / 65535u, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

const ShellPass::Pair& ShellPass::programsOf(const char* fragment,
                                             const std::vector<std::string>& defines) {
    std::string key = fragment;
    for (const std::string& define : defines) key += " " + define;
    const auto known = programs_.find(key);
    if (known != programs_.end()) return known->second;
    std::vector<std::string> textured = defines;
    textured.emplace_back("TEXTURED");
    Pair pair{Program::draw("shell.vert", fragment, defines),
              Program::draw("shell.vert", fragment, textured)};
    return programs_.emplace(key, std::move(pair)).first->second;
}

// Not culled: where the skin is hollow the surface folds over itself.
void ShellPass::drawWith(const Mirror& mirror, const Pair& programs) const {
    drawSurface(vertexArray_, mirror, mirror.surface(), allOf(mirror.surface().patches), false,
                [&](const Mirror::Part& part) -> const Program& {
                    return part.layer >= 0.0f ? programs.textured : programs.plain;
                });
}

// From the surface over the fur, then from the skin where that did not see its fur: where the eye
// is in the fur, and in hollows, whose outer surface lies in other parts of the body.
void ShellPass::drawMarched(const Mirror& mirror, const char* fragment,
                            std::vector<std::string> defines) {
    drawWith(mirror, programsOf(fragment, defines));
    defines.emplace_back("SKIN");
    glDepthFunc(GL_LEQUAL);
    drawWith(mirror, programsOf(fragment, defines));
    glDepthFunc(GL_LESS);
}

void ShellPass::drawLayer(const Mirror& mirror, const Pair& programs, const Layer& layer) const {
    for (const Program* program : {&programs.plain, &programs.textured}) {
        glProgramUniform1f(program->name(), 2, layer.t);
        glProgramUniform1ui(program->name(), 3, layer.coat);
        glProgramUniform1ui(program->name(), 4, layer.k);
    }
    drawWith(mirror, programs);
}

// The hairs of the tile.
void ShellPass::drawRoots(const Mirror& mirror, const View& view, uint coats) {
    textureBytes_ += tile_.bytes();
    layers_ = view.layers;
    if (view.shells != Shells::instanced) {
        std::vector<std::string> defines;
        if (view.shells == Shells::plain) defines.emplace_back("PLAIN");
        return drawMarched(mirror, "shell.frag", std::move(defines));
    }
    if (layers_ == 0) layers_ = kFirstLayers;
    const Pair& programs = programsOf("shell_layer.frag", {"LAYER"});
    for (uint coat = 0; coat < 2; ++coat)
        for (uint k = 0; (coats >> coat & 1u) && k < layers_; ++k)
            drawLayer(mirror, programs,
                      {coat, k, (static_cast<float>(k) + 0.5f) / static_cast<float>(layers_)});
}

// The last layer lies on the skin, and is to be seen there.
void ShellPass::drawMap(const Mirror& mirror, const ShellSource& source, uint coat, Shells shells) {
    ShellMapData data;
    data.tones = vec4(source.tones[0], source.tones[1]);
    data.side = source.side;
    data.gap = source.gap;
    data.layers = source.layers;
    data.coat = coat;
    data.photo = source.texture->photo ? 1 : 0;
    data.coverage = source.cut.coverage;
    data.taper = source.cut.taper;
    mapBlock_.upload(std::span<const ShellMapData>(&data, 1));
    mapBlock_.bindUniform(binding::shellMap);
    glBindTextureUnit(binding::shellPicture, pictures_.textureOf(source.texture).name());
    layers_ = std::max(layers_, source.layers);
    // The single pass knows the fur at the place where the ray enters it, not at each root: dots do
    // not show that, but the hairs of a photograph bend with it.
    if (shells == Shells::plain) return drawMarched(mirror, "shell_map.frag", {"MAP"});
    const Pair& programs = programsOf("shell_map.frag", {"MAP", "LAYER"});
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -1.0f);
    for (uint k = 1; k <= source.layers; ++k)
        drawLayer(mirror, programs, {coat, k, source.layerAt(k)});
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShellPass::draw(const Mirror& mirror, const Document& document, const View& view,
                     const FrameData& frame, const gl::Buffer& frameBlock) {
    const Fur& fur = document.fur;
    ShellData data;
    data.over = {periodOf(fur.share * frame.hairsPerArea), frame.overWidth, fur.over.taper,
                 fur.over.endRandomness * fur.over.relativeLength};
    data.under = {periodOf((1.0f - fur.share) * frame.hairsPerArea), frame.underWidth,
                  fur.under.taper, fur.under.endRandomness * fur.under.relativeLength};
    data.coats = frame.coats & ((fur.share > 0.0f ? 1u : 0u) | (fur.share < 1.0f ? 2u : 0u));
    data.layers = view.layers;
    data.leastWidth = view.detail.rule == Detail::Rule::all ? 0.0f : 1.0f;
    layers_ = 0;
    textureBytes_ = 0;
    if (!(frame.hairsPerArea > 0.0f) || data.coats == 0) return;
    block_.upload(std::span<const ShellData>(&data, 1));

    updateSkin(mirror, *document.skin);
    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    block_.bindUniform(binding::shells);
    curvatures_.bindStorage(binding::curvatures);
    rest_.bindStorage(binding::restVertices);
    tile_.bindStorage(binding::shellTile);
    findCurves(mirror, fur);
    uint mapped = 0;
    for (uint coat = 0; coat < 2; ++coat)
        if (view.maps[coat].texture) mapped |= data.coats & 1u << coat;
    data.coats &= ~mapped;
    // A photograph shows all of a fur.
    if (mapped == 3u && view.maps[0] == view.maps[1] && view.maps[0].texture->photo) mapped = 1u;
    block_.write(0, std::span<const ShellData>(&data, 1));
    if (data.coats != 0) drawRoots(mirror, view, data.coats);
    for (uint coat = 0; coat < 2; ++coat)
        if (mapped >> coat & 1u) drawMap(mirror, view.maps[coat], coat, view.shells);
    textureBytes_ += pictures_.keep(view.maps);
}

std::size_t ShellPass::bytes() const {
    return tile_.bytes() + pictures_.bytes() + vertices_.bytes() + rest_.bytes() +
           curvatures_.bytes() + rodTable_.bytes();
}

}  // namespace pelage
