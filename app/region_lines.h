// region_lines.h -- the outline of the region in hand, on the picture.
#pragma once

#include <vector>

#include "app/render/renderer.h"

namespace pelage {

struct App;

// Of a sphere three great circles and the border of its falloff, of a box its edges.
void addRegionOutline(const App& app, std::vector<OverlayLine>& lines);

// The corners of the lasso in the world, as far from the eye as the middle of the skin; empty when
// the region is no lasso.
std::vector<vec3> lassoInWorld(const App& app);

}  // namespace pelage
