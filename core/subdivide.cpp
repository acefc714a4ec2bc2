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

// There is nothing between one segment and another.
uint first(uint a, uint) { return a; }

void checkSize(std::size_t triangles) {
    if (triangles <= kMostTriangles) return;
    throw std::runtime_error("the mesh would have " + std::to_string(triangles) +
                             " triangles; subdivision makes at most " +
                             std::to_string(kMostTriangles));
}

// Fields that the file held, which reset brings back, on the vertices of the parts.
template <typename T, typename Mix>
std::vector<T> onNewParts(const std::vector<T>& field, const Source& before,
                          std::span<const PartCuts> cuts, Mix mix) {
    std::vector<T> out;
    for (std::size_t p = 0; p < cuts.size() && !field.empty(); ++p) {
        const auto first = field.begin() + before.parts[p].firstVertex;
        std::vector<T> values(first, first + before.parts[p].vertexCount);
        carryOver(values, cuts[p], mix);
        out.insert(out.end(), values.begin(), values.end());
    }
    return out;
}

std::unique_ptr<SourceFur> furOnNewParts(const Source& before, std::span<const PartCuts> cuts) {
    if (!before.fur) return nullptr;
    const auto mean = [](const auto& a, const auto& b) { return 0.5f * (a + b); };
    const SourceFur& fur = *before.fur;
    return std::make_unique<SourceFur>(SourceFur{onNewParts(fur.length, before, cuts, mean),
                                                 onNewParts(fur.density, before, cuts, mean),
                                                 onNewParts(fur.direction, before, cuts, mean),
                                                 onNewParts(fur.tint, before, cuts, mean)});
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
    Source source = readGltf(glb, before.source->path, progress);
    source.fur = furOnNewParts(*before.source, cuts);
    if (before.source->segmentsKept || !before.source->carried) {
        source.segments = before.source->segments;
        source.segmentOf = onNewParts(before.source->segmentOf, *before.source, cuts, first);
        source.segmentsKept = !source.segments.empty();
    }
    auto after = makeSkin(std::move(source), progress);
    assert(after->source->parts.size() == cuts.size());
    Groom groom{onNewSkin(document.groom.fur, before, *after, cuts, halfway),
                onNewSkin(document.groom.mask, before, *after, cuts,
                          [](float a, float b) { return 0.5f * (a + b); }),
                onNewSkin(document.groom.segmentOf, before, *after, cuts, first),
                document.groom.segments};
    return {std::move(after), std::move(groom), document.fur};
}

}  // namespace pelage
