// surface.h -- draws the triangles of a mirror's surface, part by part.
#pragma once

#include <functional>
#include <span>

#include "app/render/mirror.h"
#include "app/render/program.h"

namespace pelage {

// The corners of a source as vertices: their Corner at locations 0 to 2, as skin.vert reads it.
gl::VertexArray cornerArray();

// These triangles of a surface into the bound framebuffer, depth-tested, each part by the program
// that `programOf` it gives: with its material at location 0 and, where the part has a base-color
// texture, the texture's layer at location 1. `culls` what faces away, of skins that are closed.
void drawSurface(const gl::VertexArray& corners, const Mirror& mirror,
                 const Mirror::Surface& surface, std::span<const Range> ranges, bool culls,
                 const std::function<const Program&(const Mirror::Part&)>& programOf);

}  // namespace pelage
