// loop_places.cpp -- welds, smooths level by level, and puts the values back on the parts.
#include "loop_places.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "morton.h"

namespace pelage {
namespace {

// All parts as one run of vertices.
std::vector<vec3> together(std::span<const LoopPart> parts, std::size_t quantity) {
    std::vector<vec3> all;
    for (const LoopPart& part : parts)
        all.insert(all.end(), part.values[quantity].begin(), part.values[quantity].end());
    return all;
}

// Separates places whose values differ. Returns how many there are.
std::size_t refine(std::vector<uint>& place, const std::vector<vec3>& values) {
    std::vector<uint> order(place.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto before = [&](uint a, uint b) {
        if (place[a] != place[b]) return place[a] < place[b];
        const uvec3 p = positionBits(values[a]), q = positionBits(values[b]);
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<uint> refined(place.size());
    uint number = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && before(order[i - 1], order[i])) ++number;
        refined[order[i]] = number;
    }
    place = std::move(refined);
    return place.empty() ? 0 : std::size_t{number} + 1;
}

// The new vertices of a part lie where those of the welded triangles do.
void placeNew(LoopPart& part, const Cuts& cuts, std::span<const uvec3> welded) {
    assert(cuts.triangles.size() == welded.size());
    part.place.resize(part.place.size() + cuts.edges.size());
    for (std::size_t t = 3; t < welded.size(); t += 4)  // of four the one inside has only new ones
        for (int k = 0; k < 3; ++k) part.place[cuts.triangles[t][k]] = welded[t][k];
}

}  // namespace

void loopParts(std::span<LoopPart> parts, Progress* progress) {
    if (parts.empty()) return;
    const std::size_t kinds = parts.front().values.size();
    std::vector<uint> place(together(parts, 0).size(), 0);
    std::size_t count = 0;
    for (std::size_t q = 0; q < kinds; ++q) count = refine(place, together(parts, q));

    std::vector<std::vector<glm::dvec3>> quantities(kinds, std::vector<glm::dvec3>(count));
    for (std::size_t q = 0; q < kinds; ++q) {
        const std::vector<vec3> all = together(parts, q);
        for (std::size_t v = 0; v < all.size(); ++v) quantities[q][place[v]] = all[v];
    }
    std::vector<uvec3> welded;
    std::size_t first = 0;
    for (LoopPart& part : parts) {
        const auto from = place.begin() + static_cast<std::ptrdiff_t>(first);
        part.place.assign(from, from + static_cast<std::ptrdiff_t>(part.values[0].size()));
        first += part.place.size();
        for (const uvec3 t : part.triangles)
            welded.emplace_back(part.place[t.x], part.place[t.y], part.place[t.z]);
    }

    for (std::size_t level = 0; level < parts.front().cuts->size(); ++level) {
        const Cuts cuts = cutEdges(quantities[0].size(), welded);
        quantities = loopStep(std::move(quantities), welded, cuts.edges);
        welded = cuts.triangles;
        std::size_t at = 0;
        for (LoopPart& part : parts) {
            const Cuts& own = (*part.cuts)[level];
            placeNew(part, own, std::span(welded).subspan(at, own.triangles.size()));
            at += own.triangles.size();
        }
        if (progress) progress->report(progress->done);
    }
    for (LoopPart& part : parts) {
        for (std::size_t q = 0; q < kinds; ++q) {
            part.values[q].clear();
            for (const uint at : part.place) part.values[q].emplace_back(quantities[q][at]);
        }
    }
}

}  // namespace pelage
