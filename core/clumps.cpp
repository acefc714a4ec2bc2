// clumps.cpp -- guides on a grid of cubes, each as wide as clumps are apart.
#include "clumps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "strand.h"

namespace pelage {
namespace {

constexpr uint kGuideStream = 0x27d4eb2fu;

struct Place {
    vec3 position, normal;  // world
};

Place placeOf(const Root& root, const Skin& skin) {
    const uvec3 t = skin.triangles[root.triangle];
    const vec3 w = baryWeights(root.bary);
    const SkinVertex &a = skin.vertices[t.x], &b = skin.vertices[t.y], &c = skin.vertices[t.z];
    return {w.x * a.position + w.y * b.position + w.z * c.position,
            w.x * a.normal + w.y * b.normal + w.z * c.normal};
}

struct Guide {
    std::uint64_t cell = 0;
    uint root = 0;
    Place place;
};

// The guides of one coat, sorted by the cell of the grid they lie in.
class Guides {
public:
    Guides(const Roots& roots, const Skin& skin, const Fur& fur, bool over)
        : lower_(skin.lower) {
        const Coat& coat = over ? fur.over : fur.under;
        const float share = over ? fur.share : 1.0f - fur.share;
        const double perArea = static_cast<double>(roots.roots.size()) * share / skin.area;
        cell_ = static_cast<float>(std::sqrt(std::max(coat.clumpSize, 1.0f) / perArea));
        // Cells are numbered by 20 bits an axis.
        cell_ = std::max(cell_, skin.size() / 1e6f);
        for (const Cluster& cluster : roots.clusters) add(cluster, roots, skin, fur, over);
        std::sort(guides_.begin(), guides_.end(), [](const Guide& a, const Guide& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.root < b.root;
        });
    }

    // The nearest guide, or `fallback`.
    uint nearest(const Place& place, uint fallback) const {
        uint best = fallback;
        float least = std::numeric_limits<float>::infinity();
        const glm::ivec3 middle = cellOf(place.position);
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y) {
                // The three cells of a row are one run.
                const std::uint64_t from = keyOf(middle + glm::ivec3(-1, y, z));
                auto guide = std::lower_bound(
                    guides_.begin(), guides_.end(), from,
                    [](const Guide& g, std::uint64_t key) { return g.cell < key; });
                for (; guide != guides_.end() && guide->cell <= from + 2; ++guide) {
                    const vec3 away = guide->place.position - place.position;
                    const float distance = glm::dot(away, away);
                    if (distance >= least) continue;
                    if (!(glm::dot(guide->place.normal, place.normal) > 0.0f)) continue;
                    least = distance;
                    best = guide->root;
                }
            }
        return best;
    }

private:
    glm::ivec3 cellOf(vec3 position) const {
        return glm::ivec3(glm::floor((position - lower_) / cell_));
    }
    static std::uint64_t keyOf(glm::ivec3 cell) {
        const glm::uvec3 c(cell + 1);  // neighbours of cell 0 have numbers too
        return static_cast<std::uint64_t>(c.z) << 42 | static_cast<std::uint64_t>(c.y) << 21 | c.x;
    }

    void add(const Cluster& cluster, const Roots& roots, const Skin& skin, const Fur& fur,
             bool over) {
        const auto first = roots.roots.begin() + cluster.first;
        const auto isOne = [&](const Root& root) { return isOvercoat(root.id, fur.share) == over; };
        const auto hairs = std::count_if(first, first + cluster.count, isOne);
        const Coat& coat = over ? fur.over : fur.under;
        const float expected = static_cast<float>(hairs) / std::max(coat.clumpSize, 1.0f);
        const float whole = std::floor(expected);
        const uint stream = kGuideStream ^ (over ? 1u : 0u);
        const float u = rand01(pcg(first->triangle ^ pcg(fur.seed ^ stream)));
        uint wanted = static_cast<uint>(whole) + (u < expected - whole ? 1u : 0u);
        for (uint k = 0; k < cluster.count && wanted > 0; ++k) {
            const Root& root = *(first + k);
            if (!isOne(root)) continue;
            const Place place = placeOf(root, skin);
            guides_.push_back({keyOf(cellOf(place.position)), cluster.first + k, place});
            --wanted;
        }
    }

    vec3 lower_;
    float cell_ = 1.0f;  // m
    std::vector<Guide> guides_;
};

}  // namespace

void assignGuides(Roots& roots, const Skin& skin, const Fur& fur) {
    const std::array<bool, 2> clumps{fur.under.clump > 0.0f, fur.over.clump > 0.0f};
    for (uint i = 0; i < roots.roots.size(); ++i) roots.roots[i].guide = i;
    if (roots.roots.empty() || !(skin.area > 0.0)) return;
    for (const bool over : {false, true}) {
        if (!clumps[over]) continue;
        const Guides guides(roots, skin, fur, over);
        tbb::parallel_for(std::size_t{0}, roots.roots.size(), [&](std::size_t i) {
            Root& root = roots.roots[i];
            if (isOvercoat(root.id, fur.share) == over)
                root.guide = guides.nearest(placeOf(root, skin), static_cast<uint>(i));
        });
    }
}

bool guidesDiffer(const Fur& a, const Fur& b) {
    const auto differs = [](const Coat& x, const Coat& y) {
        const bool was = x.clump > 0.0f, is = y.clump > 0.0f;
        return was != is || (is && x.clumpSize != y.clumpSize);
    };
    const bool any = a.over.clump > 0.0f || a.under.clump > 0.0f;
    return differs(a.over, b.over) || differs(a.under, b.under) || (any && a.share != b.share);
}

}  // namespace pelage
