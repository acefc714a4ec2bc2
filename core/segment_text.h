// segment_text.h -- combing along the body as lines of script: written, read and run.
#pragma once

#include <string>

#include "editor.h"
#include "script_text.h"

namespace pelage {

// "segment tail axis 0 0 -1 weight 0.5"; the axis in the world.
std::string segmentLine(const Skin& skin, uint segment, vec3 axis, float weight);
// "comb head-to-tail weight 0.5"
std::string headToTailLine(float weight);

// Run what follows the first word of such a line, as one step of history. A name may contain
// blanks; without an axis it is the segment's own, and the weight is 1 unless said. Throw
// std::runtime_error with what is wrong in the line; the document is then as before it.
void runSegment(Editor& editor, Words& words);
void runHeadToTail(Editor& editor, Words& words);

}  // namespace pelage
