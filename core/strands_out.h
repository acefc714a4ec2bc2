// strands_out.h -- the hairs of a document as curves, computed on the CPU.
#pragma once

#include <vector>

#include "document.h"
#include "scatter.h"
#include "unset.h"

namespace pelage {

// A document on its way to hairs, with references to it and to its roots.
struct Growth {
    const Skin& skin;
    const Fur& fur;
    const Roots& roots;
    std::vector<FurVertex> painted;  // in the world
    float overWidth, underWidth;     // m, at the root
    float seconds;                   // how long the wind has blown
};
Growth growthOf(const Document& document, const Roots& roots, float seconds = 0.0f);

// The hair of a root, gathered to its guide.
Strand grownStrand(const Growth& growth, uint root);

struct Curves {
    uint pointsPerHair = 0;        // segments + 1
    UnsetVector<vec3> points;      // world; pointsPerHair for each hair, root first
    std::vector<float> rootWidth;  // m, one per hair
    std::vector<uint> root;        // index into Roots::roots, one per hair
};

// Every hair that grows at level of detail 1, as a polyline, whatever the style of its coat; on all
// cores. segments in [1, 64].
Curves growCurves(const Growth& growth, uint segments);
Curves growCurves(const Document& document, const Roots& roots, uint segments,
                  float seconds = 0.0f);

}  // namespace pelage
