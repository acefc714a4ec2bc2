// subdivide.cpp -- a new skin from the subdivided glTF, and the groom on its vertices.
#include "subdivide.h"

#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

#include "gltf_in.h"
#include "gltf_subdivide.h"

namespace pelage {
namespace {

FurVertex halfway(const FurVertex& a, const FurVertex& b) {
    return {0.5f * (a.direction + b.direction), 0.5f * (a.furLength + b.furLength),
            0.5f * (a.tint + b.tint), 0.5f * (a.density + b.density)};
}

// A field of the skin before on the skin after. Of welded vertices the first in the file counts.
template <typename T, typename Mix>
Chunked<T> onNewSkin(const Chunked<T>& field, const Skin& before, const Skin& after,
                     std::span<const PartCuts> cuts, Mix mix) {
    Chunked<T> out(after.vertices.size(), T{});
    for (std::size_t p = cuts.size(); p-- > 0;) {
        const SourcePart& from = before.source->parts[p];
        std::vector<T> values;
        for (uint v = from.firstVertex; v < from.firstVertex + from.vertexCount; ++v)
            values.push_back(field[before.weld[v]]);
        carryOver(values, cuts[p], mix);
        const SourcePart& to = after.source->parts[p];
        assert(values.size() == to.vertexCount);
        for (std::size_t v = values.size(); v-- > 0;)
            out.edit(after.weld[to.firstVertex + v]) = values[v];
    }
    return out;
}

void checkSize(std::size_t triangles) {
    if (triangles <= kMostTriangles) return;
    throw std::runtime_error("the mesh would have " + std::to_string(triangles) +
                             " triangles; subdivision makes at most " +
                             std::to_string(kMostTriangles));
}

}  // namespace

Document subdivided(const Document& document, int levels, Progress* progress) {
    assert(levels >= 1 && levels <= kMostLevels);
    const Skin& before = *document.skin;
    std::size_t triangles = before.triangles.size();
    for (int level = 0; level < levels; ++level) triangles *= 4;
    checkSize(triangles);
    const std::vector<PartCuts> cuts = cutParts(*before.source, levels, progress);
    const std::vector<std::byte> glb = subdividedGlb(*before.source, cuts, progress);
    auto after = makeSkin(readGltf(glb, before.source->path, progress), progress);
    assert(after->source->parts.size() == cuts.size());
    Groom groom{onNewSkin(document.groom.fur, before, *after, cuts, halfway),
                onNewSkin(document.groom.mask, before, *after, cuts,
                          [](float a, float b) { return 0.5f * (a + b); })};
    return {std::move(after), std::move(groom), document.fur};
}

}  // namespace pelage
