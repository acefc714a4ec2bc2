// segment_text.h -- the body in lines of script: combing along it, and its list of segments.
//
//   segment NAME [axis x y z] [weight W]      combs the hair of a segment
//   comb head-to-tail [weight W]              combs along all of them
//   body add NAME root x y z tip x y z        one more segment, to which no skin belongs yet
//   body move NAME root x y z tip x y z       another axis
//   body rename NAME NEW
//   body remove NAME                          its skin belongs to none afterwards
// NAME is one word: the name, its blanks and % as %20 and %25, or "#N" for the one at place N,
// counted from 0. Numbers are in m, world, rest pose.
#pragma once

#include <string>

#include "editor.h"
#include "script_text.h"

namespace pelage {

// "tail", or "#3": the word by which lines name a segment.
std::string segmentWord(const Groom& groom, uint segment);

// "segment tail axis 0 0 -1 weight 0.5"; the axis in the world.
std::string segmentLine(const Groom& groom, uint segment, vec3 axis, float weight);
// "comb head-to-tail weight 0.5"
std::string headToTailLine(float weight);
std::string addSegmentLine(const Segment& segment);
std::string moveSegmentLine(const Groom& groom, uint segment, vec3 root, vec3 tip);
std::string renameSegmentLine(const Groom& groom, uint segment, const std::string& name);
std::string removeSegmentLine(const Groom& groom, uint segment);

// Run what follows the first word of such a line, as one step of history. Without an axis it is the
// segment's own, and the weight is 1 unless said. Throw std::runtime_error with what is wrong in
// the line; the document is then as before it.
void runSegment(Editor& editor, Words& words);
void runHeadToTail(Editor& editor, Words& words);
void runBody(Editor& editor, Words& words);

}  // namespace pelage
