// view_actions.h -- what the actions do to the view when it takes more than a line.
#pragma once

namespace pelage {

struct App;

void frameAnimal(App& app);
void nextOverlay(App& app);
// Text and widgets by this factor larger; 0 goes back to what the display asks for.
void scaleText(App& app, float factor);

}  // namespace pelage
