// pen.cpp -- XInput2: which devices have a pressure, and what their raw events say.
#include "app/pen.h"

#include "app/pressure.h"

#ifdef PELAGE_XINPUT
#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <bit>
#include <span>
#include <vector>
#endif

namespace pelage {

#ifdef PELAGE_XINPUT

struct Pen::Listener {
    Display* display = nullptr;
    int opcode = 0;  // of the extension
    bool on = false;
    std::vector<PressureAxis> axes;
    float pressure = 1.0f;

    Listener(Display* opened, int extension) : display(opened), opcode(extension) {}
    ~Listener() { XCloseDisplay(display); }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    void findAxes();
    void select();
    void hear(const XIRawEvent& event);
};

void Pen::Listener::findAxes() {
    axes.clear();
    const Atom label = XInternAtom(display, "Abs Pressure", False);
    int count = 0;
    XIDeviceInfo* devices = XIQueryDevice(display, XIAllDevices, &count);
    if (!devices) return;
    for (const XIDeviceInfo& device : std::span(devices, static_cast<std::size_t>(count))) {
        if (device.use != XISlavePointer) continue;
        for (int c = 0; c < device.num_classes; ++c) {
            if (device.classes[c]->type != XIValuatorClass) continue;
            const auto& axis = *reinterpret_cast<const XIValuatorClassInfo*>(device.classes[c]);
            if (axis.label == label)
                axes.push_back({device.deviceid, axis.number, axis.min, axis.max});
        }
    }
    XIFreeDeviceInfo(devices);
}

void Pen::Listener::select() {
    unsigned char raw[XIMaskLen(XI_LASTEVENT)] = {}, changes[XIMaskLen(XI_LASTEVENT)] = {};
    if (on) {
        XISetMask(raw, XI_RawMotion);
        XISetMask(raw, XI_RawButtonPress);
        XISetMask(changes, XI_HierarchyChanged);
    }
    XIEventMask masks[] = {{XIAllMasterDevices, sizeof raw, raw},
                           {XIAllDevices, sizeof changes, changes}};
    XISelectEvents(display, DefaultRootWindow(display), masks, 2);
    XFlush(display);
}

void Pen::Listener::hear(const XIRawEvent& event) {
    const XIValuatorState& state = event.valuators;
    const std::span<const unsigned char> mask(state.mask, static_cast<std::size_t>(state.mask_len));
    std::size_t count = 0;
    for (const unsigned char byte : mask) count += static_cast<std::size_t>(std::popcount(byte));
    bool pen = false;
    for (const PressureAxis& axis : axes) {
        if (axis.device != event.sourceid) continue;
        pen = true;
        if (const auto told = pressureIn(axis, mask, {event.raw_values, count})) pressure = *told;
    }
    if (!pen) pressure = 1.0f;
}

Pen::Pen() {
    Display* display = XOpenDisplay(nullptr);
    if (!display) return;
    int opcode = 0, event = 0, error = 0, major = 2, minor = 2;
    if (!XQueryExtension(display, "XInputExtension", &opcode, &event, &error) ||
        XIQueryVersion(display, &major, &minor) != Success) {
        XCloseDisplay(display);
        return;
    }
    listener_ = std::make_unique<Listener>(display, opcode);
}

Pen::~Pen() = default;

void Pen::listen(bool on) {
    if (!listener_ || listener_->on == on) return;
    listener_->on = on;
    listener_->pressure = 1.0f;
    listener_->select();
    if (on) listener_->findAxes();
}

float Pen::pressure() {
    if (!listener_) return 1.0f;
    while (XPending(listener_->display) > 0) {
        XEvent event;
        XNextEvent(listener_->display, &event);
        if (event.xcookie.extension != listener_->opcode ||
            !XGetEventData(listener_->display, &event.xcookie))
            continue;
        if (event.xcookie.evtype == XI_HierarchyChanged)
            listener_->findAxes();
        else
            listener_->hear(*static_cast<const XIRawEvent*>(event.xcookie.data));
        XFreeEventData(listener_->display, &event.xcookie);
    }
    return listener_->pressure;
}

#else

struct Pen::Listener {};
Pen::Pen() = default;
Pen::~Pen() = default;
void Pen::listen(bool) {}
float Pen::pressure() { return 1.0f; }

#endif

}  // namespace pelage
