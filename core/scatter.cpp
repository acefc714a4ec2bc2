// scatter.cpp -- hair roots, cluster by cluster.
#include "scatter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "morton.h"
#include "strand.h"

namespace pelage {
namespace {

// Streams of random numbers that do not belong to a hair.
constexpr uint kCountStream = 0x9e3779b9u;
constexpr uint kRankStream = 0x85ebca6bu;

// Roots that one cluster should hold: large enough that its prefix is a fair sample, small enough
// that culling by cluster pays.
constexpr double kRootsPerCluster = 256.0;

// Expected count, rounded up with a probability equal to its fractional part. floor(E + u) in float
// would be wrong for large E; see the test EvenExactIntegersAreRoundedRight.
uint randomRound(double expected, float u) {
    const double whole = std::floor(expected);
    return static_cast<uint>(whole) + (u < expected - whole ? 1u : 0u);
}

uint packBary(uint id) {
    const float b1 = 1.0f - std::sqrt(rand01(id));
    const float b2 = (1.0f - b1) * rand01(id + 1u);
    const auto floored = [](float b) { return static_cast<uint>(b * 65535.0f); };
    return floored(b1) | floored(b2) << 16u;
}

uint reversedBits(uint x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
    return x << 16 | x >> 16;
}

// A stretch of Skin::spatialOrder that holds about so many hairs as others.
struct Run {
    std::size_t first, end;  // into the order
};

// A run must not jump across a gap of the curve, nor to the other side of an ear: a cluster is
// culled by its ball and shares one level of detail.
std::vector<Run> cutRuns(const Skin& skin, const std::vector<uint>& order, double hairsPerArea) {
    std::vector<Run> runs;
    const float reach = 4.0f * static_cast<float>(std::sqrt(kRootsPerCluster / hairsPerArea));
    std::size_t begin = 0;
    double expected = 0.0;
    vec3 start(0.0f), axis(0.0f);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const uvec3 t = skin.triangles[order[i]];
        const SkinVertex& corner = skin.vertices[t.x];
        const vec3 away = corner.position - start;
        const bool far = glm::dot(away, away) > reach * reach;
        const bool turned = glm::dot(corner.normal, axis) < 0.0f;
        if (i > begin && (expected >= kRootsPerCluster || far || turned)) {
            runs.push_back({begin, i});
            begin = i;
        }
        if (i == begin) {
            expected = 0.0;
            start = corner.position;
            axis = corner.normal;
        }
        expected += hairsPerArea * skin.areas[order[i]];
    }
    if (begin < order.size()) runs.push_back({begin, order.size()});
    return runs;
}

void bound(Cluster& cluster, const Skin& skin) {
    const auto triangles =
        std::span(skin.spatialOrder).subspan(cluster.firstTriangle, cluster.triangleCount);
    vec3 lower(INFINITY), upper(-INFINITY);
    for (const uint t : triangles)
        for (int c = 0; c < 3; ++c) {
            const vec3 place = skin.vertices[skin.triangles[t][c]].position;
            lower = glm::min(lower, place);
            upper = glm::max(upper, place);
        }
    cluster.center = 0.5f * (lower + upper);
    cluster.radius = 0.0f;
    for (const uint t : triangles)
        for (int c = 0; c < 3; ++c) {
            const vec3 place = skin.vertices[skin.triangles[t][c]].position;
            cluster.radius = std::max(cluster.radius, glm::distance(place, cluster.center));
        }
}

// Numbers of the roots in the order of their places on the Morton curve through the cluster.
std::vector<uint> alongCurve(std::span<const Root> roots, const Cluster& cluster,
                             const Skin& skin) {
    const vec3 lower = cluster.center - cluster.radius;
    const float cells = 1023.0f / std::max(2.0f * cluster.radius, 1e-30f);
    std::vector<std::uint64_t> keys(roots.size());  // place above, number below
    for (uint i = 0; i < roots.size(); ++i) {
        const uvec3 t = skin.triangles[roots[i].triangle];
        const vec3 w = baryWeights(roots[i].bary);
        const vec3 place = w.x * skin.vertices[t.x].position + w.y * skin.vertices[t.y].position +
                           w.z * skin.vertices[t.z].position;
        keys[i] = mortonCode(place, lower, cells) << 32 | i;
    }
    std::sort(keys.begin(), keys.end());
    std::vector<uint> order(keys.size());
    std::transform(keys.begin(), keys.end(), order.begin(),
                   [](std::uint64_t key) { return static_cast<uint>(key); });
    return order;
}

// Puts the hairs of a cluster into an order of which any prefix is spread evenly: they are numbered
// along a curve through their places, and taken in the order of the numbers' reversed bits (van der
// Corput, 1935). Ranks are evenly spaced, so that sums over ranks are exact within a cluster, and
// start at a random phase, so that they are unbiased over clusters however few hairs each holds.
void orderByRank(std::span<Root> roots, Cluster& cluster, const Skin& skin, uint seed) {
    if (roots.empty()) return;
    const std::vector<uint> curve = alongCurve(roots, cluster, skin);
    const std::vector<Root> before(roots.begin(), roots.end());
    const uint stream = pcg(roots.front().triangle ^ pcg(seed ^ kRankStream));
    cluster.phase = rand01(stream);
    const uint bits = static_cast<uint>(std::bit_width(roots.size()));
    const uint start = pcg(stream + 1u) >> (32u - bits);
    uint rank = 0;
    for (uint j = 0; rank < roots.size(); ++j) {
        const uint i = reversedBits(j ^ start) >> (32u - bits);
        if (i >= roots.size()) continue;
        roots[rank] = before[curve[i]];
        roots[rank].guide = cluster.first + rank;
        ++rank;
    }
}

}  // namespace

float Cluster::rank(uint i) const { return rankOf(i, phase, 1.0f / static_cast<float>(count)); }

Roots scatterRoots(const Skin& skin, uint hairs, uint seed) {
    Roots result;
    if (!(skin.area > 0.0) || hairs == 0) return result;
    const double hairsPerArea = hairs / skin.area;
    const std::vector<uint>& order = skin.spatialOrder;
    const std::vector<Run> runs = cutRuns(skin, order, hairsPerArea);

    std::vector<uint> counts(skin.triangles.size());
    tbb::parallel_for(tbb::blocked_range<uint>(0, static_cast<uint>(counts.size()), 8192),
                      [&](const auto& range) {
                          for (uint t = range.begin(); t < range.end(); ++t) {
                              const float u = rand01(pcg(t ^ pcg(seed ^ kCountStream)));
                              counts[t] = randomRound(hairsPerArea * skin.areas[t], u);
                          }
                      });
    result.clusters.resize(runs.size());
    uint total = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        result.clusters[r].first = total;
        for (std::size_t i = runs[r].first; i < runs[r].end; ++i) total += counts[order[i]];
        result.clusters[r].count = total - result.clusters[r].first;
    }
    result.roots.resize(total);
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t r) {
        Cluster& cluster = result.clusters[r];
        Root* next = result.roots.data() + cluster.first;
        for (std::size_t i = runs[r].first; i < runs[r].end; ++i) {
            const uint t = order[i];
            for (uint k = 0; k < counts[t]; ++k) {
                const uint id = hairId(t, k, seed);
                *next++ = Root{t, packBary(id), id, 0u};
            }
        }
        cluster.firstTriangle = static_cast<uint>(runs[r].first);
        cluster.triangleCount = static_cast<uint>(runs[r].end - runs[r].first);
        bound(cluster, skin);
        orderByRank({result.roots.data() + cluster.first, cluster.count}, cluster, skin, seed);
    });
    std::erase_if(result.clusters, [](const Cluster& c) { return c.count == 0; });
    return result;
}

void boundClusters(Roots& roots, const Skin& posed) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, roots.clusters.size(), 64),
                      [&](const auto& range) {
                          for (std::size_t c = range.begin(); c < range.end(); ++c)
                              bound(roots.clusters[c], posed);
                      });
}

float autoWidth(const Skin& skin, uint hairs, float taper) {
    if (!(skin.area > 0.0) || hairs == 0) return 0.0f;
    const double density = hairs / skin.area;
    return static_cast<float>(3.0 / (density * firstLength(skin) * (1.0 - 0.5 * taper)));
}

float coatWidth(const Skin& skin, uint hairs, const Coat& coat) {
    return coat.width > 0.0f ? coat.width : autoWidth(skin, hairs, coat.taper);
}

}  // namespace pelage
