// segment_parts.h -- body segments of meshes without a skeleton: their named pieces, each with the
// axis along which it lies.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "source.h"

namespace pelage {

// The line along the principal direction of the points, through their middle and from one end of
// them to the other; `root` is the end nearer to `head`. Both ends are the middle where all points
// are one.
Segment segmentAlong(std::string name, std::span<const vec3> points, vec3 head);

// Whether a name is that of a head.
bool saysHead(std::string name);

// What the vertices of a source are pieces of: materials, nodes, groups.
struct Pieces {
    std::vector<std::string> names;  // some may be empty
    std::vector<uint> of;            // per source vertex, into names, or kNoSegment
};

// Makes a segment of each piece that holds a vertex, and says true, if at least two of them have a
// name and there are at most 64; else changes nothing. Axes run from the head to the tail (van
// Gelder and Wilhelms 1997, section 3.4): the root is the end nearer to the piece called a head, or
// else to the upper front of all, of an animal that looks along +z; of a head itself the end
// farther from the middle of all. `kind` names the pieces that have no name.
bool segmentsFromPieces(Source& source, const Pieces& pieces, const char* kind);

// The same by the materials of the parts, or else by their meshes, of which `names` has one each.
void segmentsFromParts(Source& source, const std::vector<std::string>& names);

}  // namespace pelage
