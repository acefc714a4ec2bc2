// reference_scene.h -- what the reference knows of a document: its hairs, colors and rays.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base_color.h"
#include "ray_scene.h"
#include "reference.h"
#include "scatter.h"
#include "strands_out.h"

namespace pelage {

struct TracedDocument {
    Document document;           // as it stands, both coats as polylines: the style of a line
                                 // makes hair straight
    uint overStyle, underStyle;  // by which they are lit
    Roots roots;
    Growth growth;
    BaseColor colors;
    uint segments;
    std::vector<uint> rootOf;  // of each hair of the rays
    std::unique_ptr<RayScene> rays;

    TracedDocument(const Document& original, const ReferenceOptions& options, Progress* progress);
    float hairsPerArea() const;  // 1/m^2 at density 1
};

// Which of the samples of a pixel this is: its number in a sequence that the seed names.
struct SampleId {
    uint index, seed;
};

// Adds to each sum what a place that a ray met sends to where the ray came from under the lighting
// of the same number, and 1 for that it is covered; toEye is unit. Returns how many rays it traced.
uint addSeen(std::span<vec4> sums, const TracedDocument& scene, const Light& light,
             std::span<const Lighting> lightings, const RayHit& hit, vec3 toEye, SampleId sample);

}  // namespace pelage
