// skin_levels.cpp -- coarser triangles over the same vertices, for skin that is seen from afar.
#include "skin_levels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "morton.h"
#include "nearest_in_triangle.h"

namespace pelage {
namespace {

constexpr float kCellsPerError = 8.0f;  // side of a cell; flat skin is coarse, bent skin is kept
constexpr float kShare = 0.5f;          // of the deviation; the hair's edges have the other half

// Side of the cells, m: cells of the Morton curve along which the vertices are sorted.
float sideOf(const Skin& skin, int level) {
    const vec3 extent = skin.upper - skin.lower;
    const float cell = std::max({extent.x, extent.y, extent.z, 1e-30f}) / kLastCell;
    const float wanted = std::max(1.5f * skin.spacing / cell, 1.0f);
    return std::ldexp(cell, level + static_cast<int>(std::ceil(std::log2(wanted))));
}

float errorOf(const Skin& skin, int level) { return sideOf(skin, level) / kCellsPerError; }

// Lists by number: those of i are items[first[i]] up to items[first[i + 1]].
struct Lists {
    std::vector<uint> first, items;
    std::span<const uint> of(uint i) const {
        return {items.data() + first[i], items.data() + first[i + 1]};
    }
};

// each(add) calls add(list, item) for all items, the same ones when it is called again.
template <typename Each>
Lists listsOf(std::size_t count, const Each& each) {
    Lists lists;
    lists.first.assign(count + 1, 0);
    each([&](uint list, uint) { ++lists.first[list + 1]; });
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.items.resize(lists.first.back());
    std::vector<uint> next(lists.first.begin(), lists.first.end() - 1);
    each([&](uint list, uint item) { lists.items[next[list]++] = item; });
    return lists;
}

Lists sourcesOf(const Skin& skin) {
    return listsOf(skin.vertices.size(), [&](const auto& add) {
        for (uint s = 0; s < skin.weld.size(); ++s)
            if (skin.weld[s] < skin.vertices.size()) add(skin.weld[s], s);
    });
}

float distanceTo(vec3 a, vec3 b, vec3 c, vec3 p) {
    const glm::dvec3 from(a - p), ab(b - a), ac(c - a);
    const auto [u, v] = nearestInTriangle(from, glm::dvec3(b - p), glm::dvec3(c - p));
    return static_cast<float>(glm::length(from + u * ab + v * ac));
}

// The vertices that stand for those of their clusters, one to a cell and side of the skin.
class Grid {
public:
    Grid(const Skin& skin, const Lists& sources, std::span<const uint> part, float side)
        : skin_(skin), sources_(sources), part_(part) {
        standsFor_.resize(skin.vertices.size());
        vec3 lower(INFINITY);
        for (const SkinVertex& v : skin.vertices) lower = glm::min(lower, v.position);
        const auto cellOf = [&](uint v) {
            return mortonCode(skin.vertices[v].position, lower, 1.0f / side);
        };
        // In Morton order the vertices of a cell follow each other; where meshes are in each
        // other's cells a cell has more than one cluster.
        const auto count = static_cast<uint>(skin.vertices.size());
        for (uint begin = 0, end = 0; begin < count; begin = end) {
            for (end = begin; end < count && cellOf(end) == cellOf(begin);) ++end;
            cluster(begin, end);
        }
    }

    uint operator[](uint v) const { return standsFor_[v]; }

private:
    // The vertices of one cell.
    void cluster(uint begin, uint end) {
        std::vector<char> taken(end - begin);
        std::vector<uint> members;
        for (uint v = begin; v < end; ++v) {
            if (taken[v - begin]) continue;
            members.clear();
            for (uint w = v; w < end; ++w)
                if (w == v || (!taken[w - begin] && alike(v, w))) {
                    taken[w - begin] = 1;
                    members.push_back(w);
                }
            const uint chosen = middleOf(members);
            for (const uint w : members) standsFor_[w] = chosen;
        }
    }

    bool alike(uint v, uint w) const {
        return glm::dot(skin_.vertices[v].normal, skin_.vertices[w].normal) > 0.0f &&
               part_[skin_.sourceOf[v]] == part_[skin_.sourceOf[w]];
    }

    // The one nearest to the middle of those with the most corners: seams of textures stay seams.
    uint middleOf(const std::vector<uint>& members) const {
        vec3 middle(0.0f);
        for (const uint v : members)
            middle += skin_.vertices[v].position / static_cast<float>(members.size());
        const auto rank = [&](uint v) {
            return std::pair(-static_cast<std::ptrdiff_t>(sources_.of(v).size()),
                             glm::distance(skin_.vertices[v].position, middle));
        };
        return *std::ranges::min_element(members, {}, rank);
    }

    const Skin& skin_;
    const Lists& sources_;
    std::span<const uint> part_;  // by source vertex
    std::vector<uint> standsFor_;
};

// Of work that ends after some more of them.
class Rounds {
public:
    explicit Rounds(Progress* progress) : progress_(progress) {}
    void next() {
        if (progress_) progress_->report(1.0f - 1.0f / static_cast<float>(++number_));
    }

private:
    Progress* progress_;
    int number_ = 0;
};

// Each vertex in its cell of the coarsest grid that is good enough, or on its own.
class Clusters {
public:
    Clusters(const Skin& skin, const Lists& sources, float side, Rounds& rounds) {
        const std::vector<uint> part = partOfVertex(*skin.source);
        for (; side > 0.5f * skin.spacing; side *= 0.5f, rounds.next())
            grids_.emplace_back(skin, sources, part, side);
        gridOf_.assign(skin.vertices.size(), 0);
        for (uint v = 0; v < gridOf_.size(); ++v) standsFor_.push_back(standsFor(v));
    }

    uint operator[](uint v) const { return standsFor_[v]; }
    uvec3 operator()(uvec3 t) const { return {standsFor_[t.x], standsFor_[t.y], standsFor_[t.z]}; }

    // To the next finer grid with the clusters that `fails` names by the vertices that stand for
    // them. True if there were any.
    bool refine(const std::vector<char>& fails) {
        bool refined = false;
        for (uint v = 0; v < gridOf_.size(); ++v) {
            if (!fails[standsFor_[v]] || gridOf_[v] == grids_.size()) continue;
            ++gridOf_[v];
            refined = true;
        }
        for (uint v = 0; v < gridOf_.size(); ++v) standsFor_[v] = standsFor(v);
        return refined;
    }

private:
    uint standsFor(uint v) const { return gridOf_[v] < grids_.size() ? grids_[gridOf_[v]][v] : v; }

    std::vector<Grid> grids_;
    std::vector<std::size_t> gridOf_;
    std::vector<uint> standsFor_;
};

bool isTriangle(uvec3 t) { return t.x != t.y && t.y != t.z && t.z != t.x; }

// Which clusters have a vertex that the triangles miss.
std::vector<char> failing(const Skin& skin, const Clusters& clusters, float error) {
    const std::vector<uvec3>& triangles = skin.triangles;
    std::vector<char> fails(skin.vertices.size());
    const Lists around = listsOf(skin.vertices.size(), [&](const auto& add) {
        for (uint i = 0; i < triangles.size(); ++i) {
            const uvec3 t = clusters(triangles[i]);
            if (!isTriangle(t)) continue;
            for (const uint v : {t.x, t.y, t.z}) add(v, i);
        }
    });
    std::vector<char> missed(skin.vertices.size());
    tbb::parallel_for(uint{0}, static_cast<uint>(missed.size()), [&](uint v) {
        if (clusters[v] == v || skin.ring(v).empty()) return;
        const vec3 p = skin.vertices[v].position;
        const auto within = [&](uint i) {
            const uvec3 t = clusters(triangles[i]);
            return distanceTo(skin.vertices[t.x].position, skin.vertices[t.y].position,
                              skin.vertices[t.z].position, p) <= error;
        };
        missed[v] = !std::ranges::any_of(around.of(clusters[v]), within);
    });
    for (uint v = 0; v < missed.size(); ++v)
        // A vertex that stands for itself is missed where nothing is left around it.
        if (missed[v] || (clusters[v] == v && around.of(v).empty())) fails[clusters[v]] = 1;
    return fails;
}

// The corner of another vertex that has the most similar place in the texture.
uint cornerAt(const Source& source, std::span<const uint> corners, uint corner) {
    if (source.uvs.empty()) return corners.front();
    return *std::ranges::min_element(
        corners, {}, [&](uint c) { return glm::distance(source.uvs[c], source.uvs[corner]); });
}

void appendPatch(SkinLevel& level, const Skin& skin, const Lists& sources, const Clusters& clusters,
                 const Patches& fine, const Range& range) {
    Patch patch{.triangles = {static_cast<uint>(level.triangles.size()), 0, range.part},
                .lower = vec3(INFINITY),
                .upper = vec3(-INFINITY)};
    for (uint k = 0; k < range.count; ++k) {
        const uint i = fine.order[range.first + k];
        const uvec3 t = skin.triangles[i], coarse = clusters(t);
        if (!isTriangle(coarse)) continue;
        uvec3 corners = skin.source->triangles[i];
        for (int c = 0; c < 3; ++c) {
            if (coarse[c] != t[c])
                corners[c] = cornerAt(*skin.source, sources.of(coarse[c]), corners[c]);
            patch.lower = glm::min(patch.lower, skin.vertices[coarse[c]].position);
            patch.upper = glm::max(patch.upper, skin.vertices[coarse[c]].position);
        }
        level.triangles.push_back(corners);
        level.patches.order.push_back(i);
        ++patch.triangles.count;
    }
    if (patch.triangles.count > 0) level.patches.patches.push_back(patch);
}

}  // namespace

int levelWithin(const Skin& skin, float error) {
    if (!(skin.spacing > 0.0f) || !(error >= errorOf(skin, 0))) return kNoLevel;
    constexpr int kMost = 20;
    int level = 0;
    while (level < kMost && errorOf(skin, level + 1) <= error) ++level;
    return level;
}

int levelWithin(const Skin& skin, const Sight& sight, float deviation) {
    const vec3 half = 0.5f * (skin.upper - skin.lower);
    float nearest = 1.0f;
    if (sight.perspective)
        nearest = glm::dot(skin.center() - sight.eye, sight.forward) -
                  glm::dot(half, glm::abs(sight.forward));
    return levelWithin(skin, kShare * deviation * nearest / sight.pixelsPerMetre);
}

SkinLevel makeSkinLevel(const Skin& skin, int level, Progress* progress) {
    Rounds rounds(progress);
    rounds.next();
    SkinLevel made;
    made.error = errorOf(skin, level);
    const float side = sideOf(skin, level);
    made.reach = std::sqrt(3.0f) * side;
    const Lists sources = sourcesOf(skin);
    Clusters clusters(skin, sources, side, rounds);
    // Each round refines, so there is a last one.
    while (clusters.refine(failing(skin, clusters, made.error))) rounds.next();
    const Patches fine = makePatches(skin);
    for (const Patch& patch : fine.patches)
        appendPatch(made, skin, sources, clusters, fine, patch.triangles);
    return made;
}

}  // namespace pelage
