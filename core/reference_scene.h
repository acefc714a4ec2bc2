// reference_scene.h -- what the reference knows of a document: its hairs, colors and rays.
#pragma once

#include <memory>
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

struct Seen {
    vec3 radiance{0.0f};
    uint rays = 0;  // traced for it
};

// What a place that a ray met sends to where the ray came from; toEye is unit.
Seen seenAt(const TracedDocument& scene, const ReferenceView& view, const RayHit& hit, vec3 toEye,
            SampleId sample);

}  // namespace pelage
