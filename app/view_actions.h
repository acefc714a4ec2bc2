// view_actions.h -- what the actions do to the view when it takes more than a line.
#pragma once

namespace pelage {

struct App;

void frameAnimal(App& app);
void nextOverlay(App& app);
// Takes the Segment brush; its paint is seen in its overlay only, which is shown.
void paintSegments(App& app);
// Between the measured pictures of the reference and of the live view.
void flipAccuracy(App& app);
// Text and widgets by this factor larger; 0 goes back to what the display asks for.
void scaleText(App& app, float factor);

}  // namespace pelage
