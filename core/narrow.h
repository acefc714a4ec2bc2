// narrow.h -- how thick and how curved the skin is at a vertex.
#pragma once

#include "skin_query.h"

namespace pelage {

// Metres from vertex v inwards, against its normal, to where the body ends; infinite when that is
// farther than `farthest` or the ray leaves no body: over an open sheet, and without a normal.
// Parts that stick in one another count as one body, faces on top of the vertex not at all.
float thicknessAt(const SkinQuery& query, uint v, float farthest);

// Magnitude of the mean curvature at vertex v, 1/m: half the trace of the shape operator that fits
// the change of the normals over the one-ring best (least squares after Rusinkiewicz, Estimating
// Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004). Long edges count most, so that
// needles do no harm; what is smaller than 1/10000 of the skin's size counts as flat. Zero on a
// plane up to its border, and without a normal or a ring.
float curvatureAt(const Skin& skin, uint v);

}  // namespace pelage
