// scatter.h -- where hairs are rooted: unbiased counts, uniform by area, stable under painting.
#pragma once

#include <vector>

#include "document.h"
#include "types.h"

namespace pelage {

// Triangles that are near each other, and their roots: a unit of culling and level of detail.
struct Cluster {
    uint first = 0, count = 0;                  // into Roots::roots
    uint firstTriangle = 0, triangleCount = 0;  // into Skin::spatialOrder
    vec3 center{0.0f};    // of those triangles, world; at rest unless boundClusters moved it
    float radius = 0.0f;  // m, without the hair
    float phase = 0.0f;   // [0,1) of the ranks, see rankOf

    // Rank of the i-th root of the cluster.
    float rank(uint i) const;
};

// Roots in clusters; inside a cluster in the order of their rank, so that any prefix is a fair
// sample of the whole and rank < x holds for a share x of them.
struct Roots {
    std::vector<Root> roots;
    std::vector<Cluster> clusters;
};

// The roots of fur.hairs hairs at density 1. Depends on the skin, fur.hairs and fur.seed only, and
// is the same on every machine and for any number of threads. A triangle of area A gets
// floor(E + u) hairs, E = hairs * A / area (random rounding: van Gelder and Wilhelms 1997, 3.2), at
// uniform places, whatever happens to other triangles.
Roots scatterRoots(const Skin& skin, uint hairs, uint seed);

// Moves the bounds of the clusters to where the skin stands in a pose. Roots, ranks and guides
// stay.
void boundClusters(Roots& roots, const Skin& posed);

// The width at the root that makes a coat of the first groom's length opaque (optical depth 3 seen
// from 45 degrees): 3 / (hairs/area * length * (1 - taper/2)). It depends on the skin and the
// number of hairs only, so that painting never changes the width of hairs elsewhere.
float autoWidth(const Skin& skin, uint hairs, float taper);

// The width of a coat's hairs at the root, m: its own, or autoWidth where it leaves that open.
float coatWidth(const Skin& skin, uint hairs, const Coat& coat);

}  // namespace pelage
