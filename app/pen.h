// pen.h -- the pressure of a pen, which GLFW does not deliver: read beside it on X11.
#pragma once

#include <memory>

namespace pelage {

// Has an X connection of its own, so that nothing is taken from GLFW, and hears raw events, which
// come even while a button is held. Where there is no X11 the pressure is always 1.
class Pen {
public:
    Pen();
    ~Pen();
    Pen(const Pen&) = delete;
    Pen& operator=(const Pen&) = delete;

    // Hears while this is on: as long as the pointer is in the window, so that nothing piles up.
    void listen(bool on);
    // [0,1] of the device that moved last; 1 when it has no pressure.
    float pressure();

private:
    struct Listener;
    std::unique_ptr<Listener> listener_;  // null where there is no X11
};

}  // namespace pelage
