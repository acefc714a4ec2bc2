// headless.h -- an OpenGL context without a window: of a GPU where EGL lists one, else Mesa's.
#pragma once

namespace pelage {

// Current on this thread while it lives. Throws std::runtime_error without an EGL 4.5 context.
class HeadlessContext {
public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace pelage
