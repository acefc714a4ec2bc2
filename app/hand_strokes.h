// hand_strokes.h -- from the moves of the left button to strokes.
#pragma once

namespace pelage {

struct App;
struct PointerEvent;

// Without Shift a press begins a stroke. With Shift it smooths once the pointer moves; a click that
// does not move paints a line instead.
void pressStroke(App& app, const PointerEvent& event);
void moveStroke(App& app, const PointerEvent& event);
void releaseStroke(App& app);

// One stroke straight across the picture, from the end of the last one to here, over whatever skin
// is in sight between them.
void paintLine(App& app, const PointerEvent& event);

}  // namespace pelage
