// tool_icons.h -- the pictures of the brushes, drawn as strokes so that they are sharp at any
// scale.
#pragma once

#include <imgui.h>

#include "core/brush.h"

namespace pelage {

// Draws the picture of a tool into the square with this corner and side.
void drawToolIcon(ImDrawList& draw, Tool tool, ImVec2 corner, float side, ImU32 color);

}  // namespace pelage
