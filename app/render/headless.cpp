// headless.cpp -- EGL without a surface, and PNG files.
#include "app/render/headless.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>
#include <span>
#include <stdexcept>

#include "core/files.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace pelage {

HeadlessContext::HeadlessContext() {
    display_ =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
        throw std::runtime_error("no EGL display without a surface");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint configWish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display_, configWish, &config, 1, &count);
    const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  4,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  5,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    context_ = eglCreateContext(display_, count ? config : nullptr, EGL_NO_CONTEXT, contextWish);
    if (!context_ || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        throw std::runtime_error("EGL offers no OpenGL 4.5 core context");
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::vector<std::byte> encodeJpeg(ivec2 size, const std::vector<unsigned char>& rgba) {
    constexpr int kQuality = 90;
    std::vector<std::byte> encoded;
    const auto append = [](void* to, void* data, int count) {
        const auto* bytes = static_cast<const std::byte*>(data);
        auto& all = *static_cast<std::vector<std::byte>*>(to);
        all.insert(all.end(), bytes, bytes + count);
    };
    if (!stbi_write_jpg_to_func(append, &encoded, size.x, size.y, 4, rgba.data(), kQuality))
        throw std::runtime_error("the picture could not be encoded");
    return encoded;
}

void writePng(const std::string& path, ivec2 size, const std::vector<unsigned char>& rgba) {
    int bytes = 0;
    unsigned char* png = stbi_write_png_to_mem(rgba.data(), size.x * 4, size.x, size.y, 4, &bytes);
    if (!png) throw std::runtime_error(path + ": the picture could not be encoded");
    const std::vector<unsigned char> encoded(png, png + bytes);
    std::free(png);
    writeFileAtomically(path, std::as_bytes(std::span(encoded)));
}

}  // namespace pelage
