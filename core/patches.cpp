// patches.cpp -- the triangles of a skin in patches of near ones, to leave out those not in view.
#include "patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

template <typename Shown>
std::vector<Range> rangesOf(const Patches& patches, const Shown& shown) {
    std::vector<Range> ranges;
    for (const Patch& patch : patches.patches) {
        if (!shown(patch)) continue;
        const Range& next = patch.triangles;
        if (!ranges.empty() && ranges.back().part == next.part &&
            ranges.back().first + ranges.back().count == next.first)
            ranges.back().count += next.count;
        else
            ranges.push_back(next);
    }
    return ranges;
}

}  // namespace

Patches makePatches(const Skin& skin) {
    const auto& parts = skin.source->parts;
    std::vector<uint> next, partOf(skin.triangles.size());  // where a part's next triangle goes
    for (const SourcePart& part : parts) {
        std::fill_n(partOf.begin() + part.firstTriangle, part.triangleCount,
                    static_cast<uint>(next.size()));
        next.push_back(part.firstTriangle);
    }
    Patches patches;
    patches.order.resize(skin.triangles.size());
    for (const uint t : skin.spatialOrder) patches.order[next[partOf[t]]++] = t;
    for (uint p = 0; p < parts.size(); ++p)
        for (uint done = 0; done < parts[p].triangleCount; done += Patches::kMost)
            patches.patches.push_back(
                {.triangles = {parts[p].firstTriangle + done,
                               std::min(parts[p].triangleCount - done, Patches::kMost), p}});
    boundPatches(patches, skin);
    return patches;
}

void boundPatches(Patches& patches, const Skin& skin) {
    tbb::parallel_for(std::size_t{0}, patches.patches.size(), [&](std::size_t i) {
        Patch& patch = patches.patches[i];
        patch.lower = vec3(INFINITY);
        patch.upper = vec3(-INFINITY);
        for (uint k = 0; k < patch.triangles.count; ++k) {
            const uvec3 t = skin.triangles[patches.order[patch.triangles.first + k]];
            for (const uint v : {t.x, t.y, t.z}) {
                patch.lower = glm::min(patch.lower, skin.vertices[v].position);
                patch.upper = glm::max(patch.upper, skin.vertices[v].position);
            }
        }
    });
}

std::vector<Range> allOf(const Patches& patches) {
    return rangesOf(patches, [](const Patch&) { return true; });
}

std::vector<Range> inView(const Patches& patches, const Sight& sight) {
    const vec2 size(sight.size);
    return rangesOf(patches, [&](const Patch& patch) {
        const Outline outline = outlineOf(sight, patch.lower, patch.upper, 0.0f);
        if (!outline.known) return true;
        return outline.upper.x > -1.0f && outline.upper.y > -1.0f &&
               outline.lower.x < size.x + 1.0f && outline.lower.y < size.y + 1.0f;
    });
}

}  // namespace pelage
