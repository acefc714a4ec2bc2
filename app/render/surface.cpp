// surface.cpp -- draws the triangles of a mirror's surface, part by part.
#include "app/render/surface.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pelage {

gl::VertexArray cornerArray() {
    gl::VertexArray array = gl::makeVertexArray();
    const GLuint name = array.name();
    for (const GLuint attribute : {0u, 1u, 2u}) {
        glEnableVertexArrayAttrib(name, attribute);
        glVertexArrayAttribBinding(name, attribute, 0);
    }
    glVertexArrayAttribFormat(name, 0, 2, GL_FLOAT, GL_FALSE, offsetof(CornerData, uv));
    glVertexArrayAttribFormat(name, 1, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(CornerData, color));
    glVertexArrayAttribIFormat(name, 2, 1, GL_UNSIGNED_INT, offsetof(CornerData, skinVertex));
    return array;
}

void drawSurface(const gl::VertexArray& corners, const Mirror& mirror,
                 const Mirror::Surface& surface, std::span<const Range> ranges, bool culls,
                 const std::function<const Program&(const Mirror::Part&)>& programOf) {
    glBindVertexArray(corners.name());
    glVertexArrayElementBuffer(corners.name(), surface.indices.name());
    glVertexArrayVertexBuffer(corners.name(), 0, mirror.corners().name(), 0, sizeof(CornerData));
    glEnable(GL_DEPTH_TEST);
    if (culls && mirror.skin().outward) {
        glEnable(GL_CULL_FACE);
    } else {
        glDisable(GL_CULL_FACE);
    }
    glDisable(GL_BLEND);
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (auto first = ranges.begin(); first != ranges.end();) {
        const auto last = std::find_if(first, ranges.end(),
                                       [&](const Range& r) { return r.part != first->part; });
        const Mirror::Part& part = mirror.parts()[first->part];
        counts.clear();
        offsets.clear();
        for (; first != last; ++first) {
            counts.push_back(static_cast<GLsizei>(3 * first->count));
            offsets.push_back(reinterpret_cast<const void*>(first->first * 3 * sizeof(uint)));
        }
        programOf(part).use();
        glUniform1ui(0, part.material);
        if (part.layer >= 0.0f) glUniform1f(1, part.layer);
        glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                            static_cast<GLsizei>(counts.size()));
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace pelage
