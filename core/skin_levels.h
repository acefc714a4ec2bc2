// skin_levels.h -- coarser triangles over the same vertices, for skin that is seen from afar.
//
// Made as Rossignac and Borrel, "Multi-resolution 3D approximations for rendering complex scenes",
// 1993: in each cell of a grid one vertex stands for all whose normals are less than a right angle
// from its own, and triangles of which two corners become one are left out. Here a vertex that the
// triangles would then miss by more than the level may is kept after all.
#pragma once

#include <vector>

#include "patches.h"
#include "progress.h"

namespace pelage {

struct SkinLevel {
    // Every vertex of the skin is no farther than `error` from these triangles, in the rest pose,
    // and none is shown at another that is farther than `reach`: how far colors may slip.
    float error = 0.0f, reach = 0.0f;  // m
    std::vector<uvec3> triangles;      // source vertices, in the order of the patches
    Patches patches;                   // of these; their `order` tells what each one stands for
};

constexpr int kNoLevel = -1;  // the skin as it is
// The coarsest level whose error is at most `error` (m), kNoLevel where it would save nothing. The
// error doubles from level to level, from 0 on.
int levelWithin(const Skin& skin, float error);
// The same for the skin in a view in which edges may be off by `deviation` pixels: half of that at
// the place of the skin that is nearest to the eye.
int levelWithin(const Skin& skin, const Sight& sight, float deviation);

// Time grows with the number of triangles; the same on every machine. Throws Cancelled soon after
// that is asked for.
SkinLevel makeSkinLevel(const Skin& skin, int level, Progress* progress = nullptr);

}  // namespace pelage
