// fin_pass.cpp -- fins: fur on the edges of the skin near the silhouette, of the hair of shells.
#include "app/render/fin_pass.h"

#include <span>
#include <vector>

#include "app/render/frame_data.h"
#include "core/half_edges.h"

namespace pelage {
namespace {

// As in shaders/fin.glsl.
constexpr uint kFinQuads = 3;
struct Fin {
    uint edge;
    float weight, reach, wide;
};
struct FinDraw {
    uint stripVertices = 2 * (kFinQuads + 1), finCount = 0, firstVertex = 0, firstFin = 0;
};

}  // namespace

FinPass::FinPass()
    : choose_(Program::compute("fins.comp")),
      draw_(Program::draw("fin.vert", "fin.frag")),
      array_(gl::makeVertexArray()) {}

void FinPass::updateEdges(const std::shared_ptr<const Skin>& atRest) {
    if (atRest == edgesOf_) return;
    edgesOf_ = atRest;
    const std::vector<MeshEdge> edges = edgesOf(atRest->vertices.size(), atRest->triangles);
    edges_.upload(std::span<const MeshEdge>(edges));
    edgeCount_ = static_cast<uint>(edges.size());
    fins_.resize(sizeof(FinDraw) + 2 * edges.size() * sizeof(Fin));
}

void FinPass::draw(const std::shared_ptr<const Skin>& atRest, uint coats, const Canvas& canvas) {
    updateEdges(atRest);
    const FinDraw none;
    fins_.write(0, std::span<const FinDraw>(&none, 1));
    if (edgeCount_ == 0) return;
    edges_.bindStorage(binding::edges);
    fins_.bindStorage(binding::fins);
    glBindTextureUnit(binding::skinDepth, canvas.skinDepth.name());
    choose_.use();
    glUniform1ui(0, coats);
    glUniform1ui(1, edgeCount_);
    gl::dispatch((edgeCount_ + 63) / 64);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);

    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.name());
    glBindTextureUnit(binding::finDepth, keptDepth(canvas).name());
    glBindVertexArray(array_.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, fins_.name());
    draw_.use();
    glEnable(GL_DEPTH_TEST);
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr);
    glDisable(GL_DEPTH_TEST);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

// A copy: what is drawn into cannot be read.
const gl::Texture& FinPass::keptDepth(const Canvas& canvas) {
    if (canvas.size != size_) {
        size_ = canvas.size;
        depth_ = gl::makeTexture(size_, GL_DEPTH_COMPONENT32F);
    }
    glCopyImageSubData(canvas.depth.name(), GL_TEXTURE_2D, 0, 0, 0, 0, depth_.name(), GL_TEXTURE_2D,
                       0, 0, 0, 0, size_.x, size_.y, 1);
    return depth_;
}

uint FinPass::count() const {
    FinDraw drawn;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(fins_.name(), 0, sizeof drawn, &drawn);
    return drawn.finCount;
}

}  // namespace pelage
