// strands_out.h -- the hairs of a document as curves, computed on the CPU.
#pragma once

#include <vector>

#include "document.h"
#include "scatter.h"

namespace pelage {

struct Curves {
    uint pointsPerHair = 0;        // segments + 1
    std::vector<vec3> points;      // world; pointsPerHair for each hair, root first
    std::vector<float> rootWidth;  // m, one per hair
    std::vector<uint> root;        // index into Roots::roots, one per hair
};

// Every hair that grows at level of detail 1, as a polyline, whatever the style of its coat; on all
// cores. segments in [1, 64]. The wind blows as it does after so many seconds.
Curves growCurves(const Document& document, const Roots& roots, uint segments,
                  float seconds = 0.0f);

}  // namespace pelage
