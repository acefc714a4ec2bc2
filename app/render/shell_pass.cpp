// shell_pass.cpp -- fur in shells: layers of the same hair that strands are, marched behind each
// pixel.
#include "app/render/shell_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/render/shell_data.h"
#include "app/render/surface.h"
#include "core/curvature.h"
#include "core/elastica.h"
#include "core/shell_map.h"
#include "core/strand.h"

namespace pelage {
namespace {

// As in shaders/shell_hair.glsl.
constexpr uint kTileHairs = 1024, kTileSide = 256, kTileLevels = 9;
constexpr float kTileExcess = 1.45f;

constexpr uint kFirstLayers = 32;  // where the skin is drawn once for each and none are asked for

uint packed(const RootMap& map, uint number) {
    const auto place = [](float x) { return std::min(static_cast<uint>(x * 2048.0f), 2047u); };
    return place(map.roots[number].x) | place(map.roots[number].y) << 11 | number << 22;
}

// m, side of the tile where so many hairs of a coat stand on a square metre.
float periodOf(float perArea) {
    return std::sqrt(static_cast<float>(kTileHairs) / std::max(kTileExcess * perArea, 1e-12f));
}

// Coats that have fins, as bits of FrameData::coats.
uint finnedOf(const View& view) {
    return (view.over == DrawnAs::fins ? 1u : 0u) | (view.under == DrawnAs::fins ? 2u : 0u);
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
      over_(Program::draw("shell_over.vert", "shell_over.frag")),
      skin_(Program::draw("shell_over.vert", "shell_over.frag", {"SKIN"})),
      show_(Program::draw("screen.vert", "shell_show.frag")),
      seenOut_(Program::draw("screen.vert", "shell_seen.frag")),
      layerArray_(cornerArray()),
      surfaceArray_(gl::makeVertexArray()) {
    const GLuint name = surfaceArray_.name();
    for (const GLuint attribute : {0u, 1u, 2u}) {
        glEnableVertexArrayAttrib(name, attribute);
        // The place is that of one surface or the other.
        glVertexArrayAttribBinding(name, attribute, attribute == 0 ? 0 : 1);
    }
    glVertexArrayAttribFormat(name, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribFormat(name, 1, 1, GL_FLOAT, GL_FALSE, offsetof(ShellCorner, top));
    glVertexArrayAttribFormat(name, 2, 3, GL_FLOAT, GL_FALSE, offsetof(ShellCorner, normal));
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
    tileRows_ = gl::makeTexture(tile_, GL_RG32UI);
}

// What is the same in every pose.
void ShellPass::updateTriangles(const Mirror& mirror, const std::shared_ptr<const Skin>& atRest) {
    if (atRest == atRest_) return;
    atRest_ = atRest;
    const std::size_t count = atRest->vertices.size();
    vertices_.resize(count * sizeof(ShellVertex));
    corners_.resize(count * sizeof(ShellCorner));
    vertexRows_ = gl::makeTexture(vertices_, GL_RGBA32F);
    cornerRows_ = gl::makeTexture(mirror.corners(), GL_RGBA32UI);
    indexRows_ = gl::makeTexture(mirror.surface().indices, GL_R32UI);
    std::vector<uvec3> triangles;
    for (const uint t : mirror.surface().patches.order) triangles.push_back(atRest->triangles[t]);
    indices_.upload(std::span<const uvec3>(triangles));
}

void ShellPass::updateSkin(const Mirror& mirror) {
    if (mirror.shown() == shown_) return;
    shown_ = mirror.shown();
    const std::vector<Curvature> curvatures = curvaturesOf(*shown_);
    curvatures_.upload(std::span<const Curvature>(curvatures));
    std::vector<RestVertex> rest(curvatures.size());
    for (uint v = 0; v < rest.size(); ++v) rest[v] = restOf(*shown_, *atRest_, v);
    rest_.upload(std::span<const RestVertex>(rest));
}

void ShellPass::findCurves(const Mirror& mirror, const Document& document, uint coats,
                           float seconds) {
    const Fur& fur = document.fur;
    CurveKey key{mirror.shown(), document.groom, fur, coats, fur.wind > 0.0f ? seconds : 0.0f};
    if (curvesOf_ == key) return;
    curvesOf_ = std::move(key);
    const bool rods = fur.over.droop == kDroopElastica || fur.under.droop == kDroopElastica;
    (rods ? rodCurves_ : curves_).use();
    rodTable_.bindStorage(binding::rodTable);
    corners_.bindStorage(binding::shellCorners);
    const auto groups = static_cast<uint>((mirror.skin().vertices.size() + 63) / 64);
    if (groups > 0) glDispatchCompute(std::min(groups, 65535u), (groups + 65534u) / 65535u, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
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
void ShellPass::find(const Mirror& mirror, const Program& program, std::size_t offset,
                     const Peel& peel, const Peel& before) const {
    const uint none[4] = {};
    const float farthest = 1.0f;
    glClearNamedFramebufferuiv(peel.target.name(), GL_COLOR, 0, none);
    glClearNamedFramebufferfv(peel.target.name(), GL_DEPTH, 0, &farthest);
    glBindFramebuffer(GL_FRAMEBUFFER, peel.target.name());
    glBindTextureUnit(2, before.depth.name());
    const GLuint array = surfaceArray_.name();
    glBindVertexArray(array);
    glVertexArrayElementBuffer(array, indices_.name());
    glVertexArrayVertexBuffer(array, 0, corners_.name(), static_cast<GLintptr>(offset),
                              sizeof(ShellCorner));
    glVertexArrayVertexBuffer(array, 1, corners_.name(), 0, sizeof(ShellCorner));
    program.use();
    glEnable(GL_DEPTH_TEST);
    if (mirror.skin().outward) glEnable(GL_CULL_FACE);
    for (const Mirror::Part& part : mirror.parts()) {
        glUniform1ui(0, part.material);
        glUniform1ui(2, part.firstTriangle);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * part.triangleCount), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(3 * sizeof(uint) * part.firstTriangle));
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

// Only the pixels behind which something was found.
void ShellPass::march(const Program& program, const Peel& peel, const Canvas& canvas) const {
    const vec4 none(0.0f);
    glBindFramebuffer(GL_FRAMEBUFFER, peel.march.name());
    glClearBufferfv(GL_COLOR, 0, &none.x);
    glBindTextureUnit(2, peel.found.name());
    glBindTextureUnit(7, visible_.found.name());
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
    glBindTextureUnit(2, hairColor_.name());
    glBindTextureUnit(8, hairDepth_.name());
    show_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_DEPTH_TEST);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

// What is found is marched at once, a pixel at a time and however small its triangle: first below
// the surface over the fur that is nearest, then below what comes next behind it, as long as
// anything does. Then from the skin where that did not look for its fur: where the eye is in the
// fur, and in hollows, whose outer surface lies in other parts of the body.
void ShellPass::drawMarched(const Mirror& mirror, const Canvas& canvas, bool plain) {
    constexpr std::size_t kMostPeels = 4;
    resize(canvas.size);
    std::optional<March>& made = plain ? plain_ : swept_;
    if (!made) {
        std::vector<std::string> defines;
        if (plain) defines.emplace_back("PLAIN");
        Program fromOver = Program::draw("screen.vert", "shell.frag", defines);
        defines.emplace_back("SKIN");
        made = March{std::move(fromOver), Program::draw("screen.vert", "shell.frag", defines)};
    }
    const uint none = 0;
    const float nearest = 0.0f;
    glClearTexImage(seen_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    glBindImageTexture(0, seen_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R8UI);
    glBindTextureUnit(1, canvas.depth.name());
    glClearNamedFramebufferfv(peels_[1].target.name(), GL_DEPTH, 0, &nearest);
    find(mirror, skin_, offsetof(ShellCorner, position), visible_, peels_[1]);
    // The driver looks whether anything was found, so that nothing waits for the answer.
    while (anyFound_.size() < kMostPeels) anyFound_.push_back(gl::makeQuery(GL_ANY_SAMPLES_PASSED));
    for (std::size_t i = 0; i < kMostPeels; ++i) {
        const Peel& peel = peels_[i % 2];
        const GLuint query = anyFound_[i].name();
        if (i > 0) glBeginConditionalRender(anyFound_[i - 1].name(), GL_QUERY_WAIT);
        glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
        find(mirror, over_, offsetof(ShellCorner, outer), peel, peels_[(i + 1) % 2]);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        if (i > 0) glEndConditionalRender();
        glBeginConditionalRender(query, GL_QUERY_WAIT);
        march(made->fromOver, peel, canvas);
        glEndConditionalRender();
    }
    leaveOutSeen();
    march(made->fromSkin, visible_, canvas);
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

void ShellPass::drawLayer(const Mirror& mirror, const Program& program, float t) const {
    glProgramUniform1f(program.name(), 2, t);
    drawSurface(layerArray_, mirror, mirror.surface(), allOf(mirror.surface().patches), false,
                [&](const Mirror::Part&) -> const Program& { return program; });
}

// The last layer lies on the skin, and is to be seen there.
void ShellPass::drawMap(const Mirror& mirror, const ShellSource& source, uint coat) {
    const ShellMapData data = mapData(source);
    mapBlock_.upload(std::span<const ShellMapData>(&data, 1));
    mapBlock_.bindUniform(binding::shellMap);
    glBindTextureUnit(binding::shellPicture, pictures_.textureOf(source.texture).name());
    layers_ = std::max(layers_, source.layers);
    if (!map_) map_ = Program::draw("shell_layer.vert", "shell_map.frag", {"MAP"});
    glProgramUniform1ui(map_->name(), 3, coat);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -1.0f);
    for (uint k = 1; k <= source.layers; ++k) {
        glProgramUniform1ui(map_->name(), 4, k);
        drawLayer(mirror, *map_, source.layerAt(k));
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShellPass::drawLayers(const Mirror& mirror, uint coats) {
    if (layers_ == 0) layers_ = kFirstLayers;
    if (!layer_) layer_ = Program::draw("shell_layer.vert", "shell_layer.frag");
    for (uint coat = 0; coat < 2; ++coat) {
        if (!(coats >> coat & 1u)) continue;
        glProgramUniform1ui(layer_->name(), 3, coat);
        for (uint k = 0; k < layers_; ++k)
            drawLayer(mirror, *layer_,
                      (static_cast<float>(k) + 0.5f) / static_cast<float>(layers_));
    }
}

void ShellPass::drawFins(const Mirror& mirror, const std::shared_ptr<const Skin>& atRest,
                         uint coats, const Canvas& canvas) {
    if (!fins_) fins_.emplace();
    fins_->draw(mirror, atRest, coats, canvas);
    finned_ = true;
}

void ShellPass::draw(const Mirror& mirror, const Document& document, const View& view,
                     const FrameData& frame, const gl::Buffer& frameBlock, const Canvas& canvas) {
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
    finned_ = false;
    if (!(frame.hairsPerArea > 0.0f) || data.coats == 0) return;
    block_.upload(std::span<const ShellData>(&data, 1));

    updateTriangles(mirror, document.skin);
    updateSkin(mirror);
    mirror.bind();
    frameBlock.bindUniform(binding::frame);
    block_.bindUniform(binding::shells);
    curvatures_.bindStorage(binding::curvatures);
    rest_.bindStorage(binding::restVertices);
    vertices_.bindStorage(binding::shellVertices);
    glBindTextureUnit(3, vertexRows_.name());
    glBindTextureUnit(4, cornerRows_.name());
    glBindTextureUnit(5, indexRows_.name());
    glBindTextureUnit(6, tileRows_.name());
    findCurves(mirror, document, data.coats, frame.seconds);
    uint mapped = 0;
    for (uint coat = 0; coat < 2; ++coat)
        if (view.maps[coat].texture) mapped |= data.coats & 1u << coat;
    data.coats &= ~mapped;
    if (data.coats != 0) {
        textureBytes_ = tile_.bytes();
        layers_ = view.layers;
        block_.write(0, std::span<const ShellData>(&data, 1));
        if (view.shells == Shells::instanced)
            drawLayers(mirror, data.coats);
        else
            drawMarched(mirror, canvas, view.shells == Shells::plain);
        const uint finned = data.coats & finnedOf(view);
        if (finned != 0) drawFins(mirror, document.skin, finned, canvas);
    }
    // A photograph shows all of a fur.
    if (mapped == 3u && view.maps[0] == view.maps[1] && view.maps[0].texture->photo) mapped = 1u;
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.name());
    for (uint coat = 0; coat < 2; ++coat)
        if (mapped >> coat & 1u) drawMap(mirror, view.maps[coat], coat);
    textureBytes_ += pictures_.keep(view.maps);
}

std::size_t ShellPass::bytes() const {
    return (fins_ ? fins_->bytes() : 0) + tile_.bytes() + pictures_.bytes() + vertices_.bytes() +
           rest_.bytes() + curvatures_.bytes() + rodTable_.bytes();
}

}  // namespace pelage
