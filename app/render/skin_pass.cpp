// skin_pass.cpp -- the skin under the fur.
#include "app/render/skin_pass.h"

namespace pelage {

SkinPass::SkinPass()
    : program_(Program::draw("skin.vert", "skin.frag")), vertexArray_(gl::makeVertexArray()) {}

void SkinPass::draw(const Mirror& mirror) const {
    program_.use();
    glBindVertexArray(vertexArray_.name());
    glVertexArrayElementBuffer(vertexArray_.name(), mirror.indices().name());
    glEnable(GL_DEPTH_TEST);
    if (mirror.skin().outward) {
        glEnable(GL_CULL_FACE);
    } else {
        glDisable(GL_CULL_FACE);
    }
    glDisable(GL_BLEND);
    for (const Mirror::Part& part : mirror.parts()) {
        glProgramUniform1ui(program_.name(), 0, part.material);
        const std::size_t offset = part.firstTriangle * 3 * sizeof(uint);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * part.triangleCount), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(offset));
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace pelage
