// region_text.h -- how edits of regions are written in a line of script, and read back bit for bit.
//
//   region WHERE [sizes] [falloff F] : CHANNEL ACT
// WHERE:  all | sphere x y z radius R | box x y z half x y z [turn x y z] | segment NAME | mask
//         | narrow WIDTH | curved CURVATURE
//         | lasso [eye x y z] view M (16 numbers, column by column) points x y x y x y ...
// CHANNEL: length | density | direction
// ACT:    scale FACTOR | set VALUE (direction: set x y z) | smooth [SHARE]
//         | randomise SHARE [seed N]
// NAME is the word of a segment (segment_text.h).
#pragma once

#include <string>

#include "region.h"
#include "script_text.h"

namespace pelage {

// WHERE and what follows it, up to a colon or the end of the line, written and read. Throws
// std::runtime_error naming the offending word.
std::string regionText(const Region& region);
Region regionNamed(std::string_view where, Words& words);

struct RegionWords {
    Region region;
    RegionEdit change;
};
// What the words after "region" say. Throws std::runtime_error naming the offending word.
RegionWords regionFromWords(Words& words);

// The entire line. Fields that do not count for its kinds are left out.
std::string regionLine(const Region& region, const RegionEdit& change);

// "Region narrow: length scale"
std::string regionLabel(const Region& region, const RegionEdit& change);

}  // namespace pelage
