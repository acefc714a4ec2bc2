// loop.h -- Loop's rule: where the vertices of a mesh go when every edge is cut.
#pragma once

#include <span>
#include <vector>

#include "edge_cuts.h"

namespace pelage {

// Moves the points of a welded mesh and appends one for each of `edges`, which are those of
// cutEdges(points.size(), triangles), by the uniform subdivision of OpenMesh (Loop, Smooth
// Subdivision Surfaces Based on Triangles, 1987); open borders become smooth curves of their own.
// What a half-edge mesh cannot hold stays as it is: corners of a third triangle at an edge, or of
// one that is flipped against its neighbours, keep their place, and edges between such corners are
// halved. Points of no triangle stay, too. Since the rule is linear, it holds for any quantity.
std::vector<std::vector<glm::dvec3>> loopStep(std::vector<std::vector<glm::dvec3>> quantities,
                                              std::span<const uvec3> triangles,
                                              std::span<const EdgeEnds> edges);

}  // namespace pelage
