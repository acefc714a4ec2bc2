// capabilities.cpp -- the version of OpenGL, and limits.
#include "app/render/capabilities.h"

#include <stdexcept>
#include <string>

#include "app/render/gl.h"

namespace pelage {

void requireCapabilities() {
    if (epoxy_gl_version() < 45)
        throw std::runtime_error(
            "OpenGL 4.5 is needed, the driver offers " +
            std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION))));
    // OpenGL 4.5 promises fewer storage buffers than the shaders read; every desktop driver has
    // more.
    const struct {
        GLenum limit;
        int needed;
        const char* name;
    } limits[] = {
        {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 16, "storage buffers"},
        {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 15, "storage buffers in a compute shader"},
        {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 6, "storage buffers in a vertex shader"},
        {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, 1, "storage buffers in a fragment shader"},
        {GL_MAX_COMPUTE_IMAGE_UNIFORMS, 1, "images in a compute shader"},
        {GL_MAX_TEXTURE_BUFFER_SIZE, 1 << 25, "texels in a buffer"},
    };
    for (const auto& [limit, needed, name] : limits) {
        int offered = 0;
        glGetIntegerv(limit, &offered);
        if (offered < needed)
            throw std::runtime_error("the graphics driver offers " + std::to_string(offered) + " " +
                                     name + ", Pelage needs " + std::to_string(needed));
    }
}

}  // namespace pelage
