// body.h -- the segments of the body as part of a groom: found by name, added, moved, renamed,
// removed, and painted onto the skin.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "groom.h"

namespace pelage {

struct Brush;

// The segment called "#N", N from 0, or of that name, or at the place of that number when none has
// the name. Throws std::runtime_error that lists the names.
uint segmentNamed(std::span<const Segment> body, std::string_view name);
// What segmentNamed finds it by: its name, or "#N" where that is empty, begins with # or belongs to
// an earlier segment.
std::string nameOfSegment(std::span<const Segment> body, uint segment);

// Each replaces the list of the groom. A new name must not be empty or taken, and an axis goes from
// one finite point to another; else std::runtime_error, and the groom is as before.
void addSegment(Groom& groom, const Segment& segment);
void moveSegment(Groom& groom, uint segment, vec3 root, vec3 tip);
void renameSegment(Groom& groom, uint segment, const std::string& name);
// Its vertices belong to no segment afterwards; those behind it in the list move up.
void removeSegment(Groom& groom, uint segment);

// What the Segment brush does. It gives its segment (none where it names none), or with subtract the
// one that the vertex has in the source (none where that was removed), to vertices whose coverage is
// at least 1 - strength: by half strength to where the falloff is a half. There is nothing between
// one segment and another, so a mask below a half does not hold back.
class SegmentPaint {
public:
    // Throws std::runtime_error when the groom has no segment of the brush's name.
    SegmentPaint(const Skin& skin, const Groom& before, const Brush& brush);
    // Gives back the segments of the source, whatever the coverage.
    SegmentPaint(const Skin& skin, const Groom& before);

    void paint(Groom& groom, uint v, float coverage) const;

private:
    void giveBack(const Skin& skin, const Groom& before);

    float least_ = 0.0f;  // coverage
    uint segment_ = kNoSegment;
    Chunked<uint> source_;   // of each vertex, in its numbers; empty unless they are given back
    std::vector<uint> now_;  // the number that each of those has in the groom
};

}  // namespace pelage
