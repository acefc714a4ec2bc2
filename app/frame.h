// frame.h -- one frame: panels, pointer and keys, picture.
#pragma once

#include <vector>

#include "app/actions.h"
#include "app/app.h"

namespace pelage {

struct PressedKey {
    Shortcut key;
    bool repeated = false;
};

struct FrameKeys {
    std::vector<PressedKey> pressed;  // since the last frame
    double changed = 0.0;             // s, when the picture last changed by hand
    bool moving = false;              // it changed so recently that frames must be quick
    Camera camera;                    // of the last frame
    bool ready = false;               // a finished picture was shown (traced once)
    double accuracyWaits = 1e9;       // s until the measure needs a frame
    bool typing = false;              // keys go to a text field
};

// Between ImGui::NewFrame and ImGui::Render. `events` is true when input came since the last frame.
void drawFrame(App& app, Renderer& renderer, FrameKeys& keys, double now, bool events);

}  // namespace pelage
