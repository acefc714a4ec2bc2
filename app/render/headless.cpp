// headless.cpp -- EGL without a surface.
#include "app/render/headless.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace pelage {
namespace {

bool offers(const char* extensions, std::string_view name) {
    return extensions && std::string_view(extensions).find(name) != std::string_view::npos;
}

// The GPUs, and after them whatever Mesa takes without a surface, which may be the processor.
std::vector<EGLDisplay> displays() {
    std::vector<EGLDisplay> found;
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (offers(client, "EGL_EXT_platform_device") && offers(client, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i)
            if (!offers(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS),
                        "EGL_MESA_device_software"))
                found.push_back(
                    eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
    if (offers(client, "EGL_MESA_platform_surfaceless"))
        found.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    return found;
}

// Current on this thread, or null.
EGLContext contextOf(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return nullptr;
    eglBindAPI(EGL_OPENGL_API);
    const EGLint configWish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, configWish, &config, 1, &count);
    const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  4,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  5,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    const EGLContext context =
        eglCreateContext(display, count ? config : nullptr, EGL_NO_CONTEXT, contextWish);
    if (context && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return context;
    if (context) eglDestroyContext(display, context);
    eglTerminate(display);
    return nullptr;
}

}  // namespace

HeadlessContext::HeadlessContext() {
    for (EGLDisplay display : displays()) {
        context_ = contextOf(display);
        if (!context_) continue;
        display_ = display;
        return;
    }
    throw std::runtime_error("EGL offers no OpenGL 4.5 core context without a surface");
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

}  // namespace pelage
