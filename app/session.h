// session.h -- how one person looks at the animal and holds the brush: plain data, never undone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/hand.h"
#include "app/render/renderer.h"
#include "core/brush.h"
#include "core/region.h"

namespace pelage {

struct ViewOptions {
    Overlay overlay = Overlay::none;
    bool showSkin = true, showOver = true, showUnder = true;
    DrawnAs over = DrawnAs::strands, under = DrawnAs::strands;
    int layers = 0;                        // of shells, [0, 256]; 0 = as many as they need
    bool shellShadows = false;             // of single hairs in shells
    int segments = 8;                      // of a hair, [1, 16]
    Detail detail{.milliseconds = 45.0f};  // the time holds while the hand moves
    int samples = 16;                      // that the resting picture averages
    bool playWind = false;
    float windSeconds = 0.0f;  // how long the wind has blown
};

// A unit in which lengths of one animal are comfortable to read.
struct LengthUnit {
    const char* name = "m";
    float perMetre = 1.0f;
};
LengthUnit unitFor(float size);
// For numbers in the unit: "%.2f cm".
std::string numberFormat(LengthUnit unit);
// "3.2 cm": a length with three significant digits.
std::string lengthText(float metres);

// The segment of the body in hand.
struct SegmentChoice {
    uint chosen = 0;                    // also what the Segment brush paints
    float weight = 1.0f;                // [0,1]
    bool shown = false;                 // in this frame: the axes are drawn and can be held
    std::string name;                   // as it is typed
    std::vector<std::size_t> vertices;  // of each segment
    Chunked<uint> counted;              // what they were counted in
};

// How the animation goes on; which clip and when is in the workspace.
struct Playback {
    bool playing = false;
    bool loop = true;
    float speed = 1.0f;
};

struct Session {
    Camera camera;
    Playback playback;
    Tool tool = Tool::comb;
    std::array<Brush, kToolCount>
        brushes;  // by Tool; radius, mirror, alongSurface and facingOnly are the same in all
    Hand hand;
    vec3 floodDirection{0.0f, 0.0f, -1.0f};  // world; of combing everything at once
    SegmentChoice segment;
    ViewOptions view;
    // Of the region panel; its lengths are in sizes of the skin.
    Region region{.where = Where::narrow, .curvature = 10.0f, .falloff = 0.02f, .sizes = true};
    RegionEdit regionEdit{.value = 0.5f};
    bool regionShown = false;  // in this frame: its outline is drawn

    Brush& brush() { return brushes[static_cast<std::size_t>(tool)]; }
    const Brush& brush() const { return brushes[static_cast<std::size_t>(tool)]; }
};

// Brushes and camera for an animal that was just opened; view options and brush habits stay.
void meetSkin(Session& session, const Skin& skin, float aspect);

// Radii of brushes, in sizes of the skin: of an animal that was just opened, and the limits.
inline constexpr float kFirstRadius = 0.05f, kSmallestRadius = 0.002f, kLargestRadius = 0.5f;

float clampedRadius(const Skin& skin, float radius);               // to the limits
void setRadius(Session& session, const Skin& skin, float radius);  // clamped to the limits
void setStrength(Session& session, float strength);
void setMirror(Session& session, int axis, bool on);
void setAlongSurface(Session& session, bool on);
void setFacingOnly(Session& session, bool on);

// The brush that a press with these held keys starts: Shift smooths, Ctrl turns add and subtract.
Brush heldBrush(const Session& session, bool shift, bool control);

// Looks from these angles at the whole animal or, for `turn`, keeps what is in the middle.
void frameAll(Session& session, const Skin& skin, float aspect);
void turnTo(Session& session, float yaw, float pitch);

}  // namespace pelage
