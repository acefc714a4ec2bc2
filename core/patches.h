// patches.h -- the triangles of a skin in patches of near ones, to leave out those not in view.
#pragma once

#include <vector>

#include "lod.h"
#include "skin.h"

namespace pelage {

struct Range {                  // of triangles of one part
    uint first = 0, count = 0;  // into Patches::order
    uint part = 0;              // of the source
    bool operator==(const Range&) const = default;
};

struct Patch {
    Range triangles;
    vec3 lower{0.0f}, upper{0.0f};  // bounds of their vertices, world
};

struct Patches {
    std::vector<uint> order;  // all triangles: parts as in the source, near ones of each together
    std::vector<Patch> patches;  // of at most kMost triangles
    static constexpr uint kMost = 256;
};

Patches makePatches(const Skin& skin);
// Bounds of the patches on the skin as it stands.
void boundPatches(Patches& patches, const Skin& skin);

// In as few ranges as there can be: every triangle, and those of patches of which something may lie
// in the window. No triangle that covers a pixel is left out.
std::vector<Range> allOf(const Patches& patches);
std::vector<Range> inView(const Patches& patches, const Sight& sight);

}  // namespace pelage
