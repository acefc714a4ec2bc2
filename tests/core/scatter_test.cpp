// scatter_test.cpp -- the promises of core/scatter.h and core/strands_out.h.
#include "core/scatter.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/strand.h"
#include "core/strands_out.h"
#include "core/test_skins.h"
#include "tests/figures.h"

namespace pelage {
namespace {

// A sheet whose cells have very different areas: most triangles expect less than half a hair.
std::shared_ptr<const Skin> unevenSheet(uint cells) {
    Source source = test::sheet(cells);
    for (vec3& p : source.positions) p.x = std::copysign(p.x * p.x, p.x), p.z = p.z * p.z * p.z;
    return makeSkin(std::move(source));
}

std::vector<uint> perTriangle(const Skin& skin, const Roots& roots) {
    std::vector<uint> count(skin.triangles.size(), 0);
    for (const Root& root : roots.roots) ++count[root.triangle];
    return count;
}

std::vector<float> ranksOf(const Roots& roots) {
    std::vector<float> ranks;
    for (const Cluster& cluster : roots.clusters)
        for (uint i = 0; i < cluster.count; ++i) ranks.push_back(cluster.rank(i));
    return ranks;
}

bool sameRoots(const Roots& a, const Roots& b) {
    return std::equal(a.roots.begin(), a.roots.end(), b.roots.begin(), b.roots.end(),
                      [](const Root& x, const Root& y) {
                          return x.triangle == y.triangle && x.bary == y.bary && x.id == y.id &&
                                 x.guide == y.guide;
                      }) &&
           std::equal(a.clusters.begin(), a.clusters.end(), b.clusters.begin(), b.clusters.end(),
                      [](const Cluster& x, const Cluster& y) {
                          return x.first == y.first && x.count == y.count && x.phase == y.phase;
                      });
}

TEST(Scatter, CountsAreUnbiasedWithTheVarianceOfRandomRounding) {
    const auto skin = unevenSheet(256);
    const uint hairs = 60000;
    double expectedVariance = 0.0;
    std::size_t below = 0;
    for (const float area : skin->areas) {
        const double e = hairs * area / skin->area, f = e - std::floor(e);
        expectedVariance += f * (1 - f);
        below += e < 0.5;
    }
    ASSERT_GT(below, skin->areas.size() / 3) << "the case is not hard";
    const int seeds = 200;
    double sum = 0.0, squares = 0.0, farthest = 0.0;
    for (int s = 0; s < seeds; ++s) {
        const double total =
            static_cast<double>(scatterRoots(*skin, hairs, static_cast<uint>(s)).roots.size()) -
            hairs;
        farthest = std::max(farthest, std::abs(total));
        sum += total;
        squares += total * total;
    }
    test::reached("R1", "number of hairs off 60,000 on 131,072 faces, worst of 200 seeds", farthest,
                  4.0 * std::sqrt(expectedVariance));
    EXPECT_NEAR(sum / seeds, 0.0, 4.0 * std::sqrt(expectedVariance / seeds));
    EXPECT_NEAR(squares / seeds / expectedVariance, 1.0, 0.4);
}

TEST(Scatter, VarianceOfEachTriangleIsThatOfItsFraction) {
    const auto skin = unevenSheet(64);
    const uint hairs = 5000;
    const int seeds = 400;
    std::vector<double> sum(skin->areas.size(), 0.0), squares(skin->areas.size(), 0.0);
    for (int s = 0; s < seeds; ++s) {
        const auto count = perTriangle(*skin, scatterRoots(*skin, hairs, static_cast<uint>(s)));
        for (std::size_t t = 0; t < count.size(); ++t) {
            const double d = count[t] - hairs * skin->areas[t] / skin->area;
            sum[t] += d;
            squares[t] += d * d;
        }
    }
    double measured = 0.0, expected = 0.0, bias = 0.0;
    for (std::size_t t = 0; t < sum.size(); ++t) {
        const double e = hairs * skin->areas[t] / skin->area, f = e - std::floor(e);
        measured += squares[t] / seeds;
        expected += f * (1 - f);
        bias += sum[t] / seeds;
    }
    test::reached("R2", "variance of the hairs of a face over that of random rounding, off 1",
                  std::abs(measured / expected - 1.0), 0.02);
    EXPECT_NEAR(bias, 0.0, 4.0 * std::sqrt(expected / seeds));
}

TEST(Scatter, EvenExactIntegersAreRoundedRight) {
    // One triangle that expects exactly its hairs: floor(E + u) in float would sometimes add one.
    const auto skin = makeSkin(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 2, 1}}));
    for (const uint hairs : {1u, 1000u, 100000u, 1000000u})
        for (uint seed = 0; seed < 20; ++seed)
            ASSERT_EQ(scatterRoots(*skin, hairs, seed).roots.size(), hairs);
}

// Chi-square of points in 64 cells of equal area of the unit triangle.
double chiSquare(const std::vector<vec3>& weights) {
    std::vector<double> cells(64, 0.0);
    for (const vec3 w : weights) {
        // (1 - sqrt) maps the triangle onto the unit square with equal areas.
        const double u = (1.0 - w.x) * (1.0 - w.x), v = w.y / std::max(1.0f - w.x, 1e-9f);
        const auto cell = [](double x) { return std::min(7, static_cast<int>(x * 8)); };
        cells[static_cast<std::size_t>(8 * cell(u) + cell(v))] += 1.0;
    }
    const double expected = static_cast<double>(weights.size()) / 64.0;
    double sum = 0.0;
    for (const double c : cells) sum += (c - expected) * (c - expected) / expected;
    return sum;
}

TEST(Scatter, RootsAreUniformByAreaAndTheTestWouldSeeAPercentOfWarp) {
    // 63 degrees of freedom: [27.6, 116] holds all but 1e-4 on either side.
    const auto skin = makeSkin(test::sheet(32));
    double greatest = 0.0;
    for (const uint seed : {1u, 2u, 3u}) {
        const Roots roots = scatterRoots(*skin, 2000000, seed);
        std::vector<vec3> weights, warped;
        for (const Root& root : roots.roots) {
            const vec3 w = baryWeights(root.bary);
            weights.push_back(w);
            const double u0 = (1.0 - w.x) * (1.0 - w.x);
            const float x = static_cast<float>(1.0 - std::sqrt(std::pow(u0, 1.01)));
            warped.emplace_back(x, w.y / std::max(1.0f - w.x, 1e-9f) * (1.0f - x), 0.0f);
        }
        const double chi = chiSquare(weights);
        EXPECT_GT(chi, 27.6) << "seed " << seed;
        greatest = std::max(greatest, chi);
        EXPECT_GT(chiSquare(warped), 116.0) << "the control passes: the test sees nothing";
    }
    test::reached("R3", "chi-square of 2,000,000 places in 64 cells, worst of 3 seeds", greatest,
                  116.0);
}

TEST(Scatter, FirstHairsOfManyTrianglesAreUniformToo) {
    const auto skin = makeSkin(test::sheet(512));
    double greatest = 0.0;
    for (const uint seed : {5u, 6u, 7u}) {
        std::vector<vec3> weights;
        for (const Root& root : scatterRoots(*skin, 524288, seed).roots)
            weights.push_back(baryWeights(root.bary));
        const double chi = chiSquare(weights);
        EXPECT_GT(chi, 27.6) << "seed " << seed;
        greatest = std::max(greatest, chi);
    }
    test::reached("R3", "the same of the first hairs of 524,288 faces", greatest, 116.0);
}

TEST(Scatter, WeightsAreNeverNegative) {
    for (uint i = 0; i < 70000; ++i) {
        const vec3 w = baryWeights(pcg(i));
        EXPECT_GE(std::min({w.x, w.y, w.z}), 0.0f);
    }
}

TEST(Scatter, IsTheSameForAnyNumberOfThreads) {
    const auto skin = unevenSheet(128);
    const Roots many = scatterRoots(*skin, 100000, 9);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    test::reached("R5", "roots that differ between one thread and many: 1 if any does",
                  sameRoots(many, scatterRoots(*skin, 100000, 9)) ? 0.0 : 1.0, 0.0);
}

TEST(Scatter, AnotherTriangleMovesNoHair) {
    // The same sheet with one more triangle far away: hairs per area stay, those roots too.
    Source source = test::sheet(16);
    const auto alone = makeSkin(test::sheet(16));
    source.positions.insert(source.positions.end(), {{9, 0, 9}, {10, 0, 9}, {9, 0, 10}});
    const uint n = static_cast<uint>(source.positions.size());
    source.triangles.emplace_back(n - 3, n - 1, n - 2);
    source.parts[0].vertexCount += 3;
    source.parts[0].triangleCount += 1;
    const auto both = makeSkin(std::move(source));
    const uint hairs = 20000;
    const uint more = static_cast<uint>(std::lround(hairs * both->area / alone->area));
    std::set<std::pair<uint, uint>> before, after;
    for (const Root& r : scatterRoots(*alone, hairs, 3).roots) before.emplace(r.id, r.bary);
    for (const Root& r : scatterRoots(*both, more, 3).roots)
        if (r.triangle < alone->triangles.size()) after.emplace(r.id, r.bary);
    std::vector<std::pair<uint, uint>> moved;
    std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                  std::back_inserter(moved));
    test::reached("R5", "of 20,000 hairs, those that move where another face is added",
                  static_cast<double>(moved.size()), 0.0);
}

TEST(Scatter, MoreHairsKeepTheHairsThatWereThere) {
    const auto skin = unevenSheet(32);
    std::set<uint> many;
    for (const Root& r : scatterRoots(*skin, 40000, 3).roots) many.insert(r.id);
    for (const Root& r : scatterRoots(*skin, 10000, 3).roots) EXPECT_TRUE(many.count(r.id));
}

TEST(Scatter, IdsAreUniqueAmongHalfAMillion) {
    const Roots roots = scatterRoots(*makeSkin(test::sheet(64)), 500000, 1);
    std::set<uint> ids;
    for (const Root& r : roots.roots) ids.insert(r.id);
    // 32-bit ids of n hairs collide n^2 / 2^33 times: 29 pairs expected.
    EXPECT_GT(ids.size(), roots.roots.size() - 80);
}

TEST(Scatter, AnyPrefixByRankIsAFairSample) {
    const auto skin = unevenSheet(64);
    const Roots roots = scatterRoots(*skin, 50000, 2);
    for (const float share : {0.5f, 0.25f, 0.125f, 0.01f}) {
        std::size_t drawn = 0;
        for (const float rank : ranksOf(roots)) drawn += rank < share;
        const double expected = share * static_cast<double>(roots.roots.size());
        EXPECT_NEAR(static_cast<double>(drawn), expected,
                    4.0 * std::sqrt(static_cast<double>(roots.clusters.size())))
            << share;
    }
    for (const Cluster& cluster : roots.clusters)
        for (uint i = 1; i < cluster.count; ++i) ASSERT_LT(cluster.rank(i - 1), cluster.rank(i));
}

// Variance / mean of the number of hairs in discs that hold `mean` of them; 1 for white noise.
double clumpiness(const Skin& skin, const Roots& roots, float share, double mean) {
    const double radius =
        std::sqrt(mean / (share * static_cast<double>(roots.roots.size())) / 3.14159265);
    std::vector<vec2> places;
    const std::vector<float> ranks = ranksOf(roots);
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (!(ranks[i] < share)) continue;
        const Root& root = roots.roots[i];
        const uvec3 t = skin.triangles[root.triangle];
        const vec3 w = baryWeights(root.bary);
        const vec3 p = w.x * skin.vertices[t.x].position + w.y * skin.vertices[t.y].position +
                       w.z * skin.vertices[t.z].position;
        places.emplace_back(p.x, p.z);
    }
    double sum = 0.0, squares = 0.0;
    const int discs = 1500;
    for (uint k = 0; k < discs; ++k) {
        const float inner = static_cast<float>(1.0 - 2.0 * radius);
        const vec2 center((rand01(pcg(k)) - 0.5f) * inner, (rand01(pcg(k) + 1u) - 0.5f) * inner);
        double count = 0.0;
        for (const vec2 p : places) count += glm::dot(p - center, p - center) < radius * radius;
        sum += count;
        squares += count * count;
    }
    const double m = sum / discs;
    return (squares / discs - m * m) / m;
}

TEST(Scatter, PrefixesAreSpreadMoreEvenlyThanWhiteNoise) {
    // Half a hair a triangle, where random rounding alone gives .59 and its 25 % prefix .90.
    const auto skin = makeSkin(test::sheet(141));
    const float shares[] = {1.0f, 0.5f, 0.25f, 0.125f};
    double mean[4] = {0.0, 0.0, 0.0, 0.0};
    for (uint seed = 1; seed <= 3; ++seed) {
        const Roots roots = scatterRoots(*skin, 20000, seed);
        for (std::size_t i = 0; i < 4; ++i)
            mean[i] += clumpiness(*skin, roots, shares[i], 8.0) / 3.0;
    }
    using test::reached;
    reached("R6", "variance over mean of the hairs in discs of 8, half a hair a face: all", mean[0],
            0.65);
    reached("R6", "the same, half of the hairs (.35 was asked)", mean[1], 0.45);
    reached("R6", "the same, a quarter (.35 was asked)", mean[2], 0.42);
    reached("R6", "the same, an eighth (.35 was asked)", mean[3], 0.42);
}

TEST(Scatter, ClustersHoldTheirTrianglesAndEachRootOnce) {
    const auto skin = makeSkin(test::sheet(64));
    const Roots roots = scatterRoots(*skin, 30000, 2);
    uint next = 0;
    for (const Cluster& cluster : roots.clusters) {
        EXPECT_EQ(cluster.first, next);
        next += cluster.count;
        for (uint i = 0; i < cluster.count; ++i) {
            const uvec3 t = skin->triangles[roots.roots[cluster.first + i].triangle];
            for (int c = 0; c < 3; ++c) {
                const SkinVertex& v = skin->vertices[t[c]];
                EXPECT_LE(glm::distance(v.position, cluster.center), cluster.radius * 1.0001f);
            }
        }
    }
    EXPECT_EQ(next, roots.roots.size());
}

TEST(Scatter, NothingGrowsOnNoAreaOrFromNoHairs) {
    EXPECT_TRUE(scatterRoots(*makeSkin(Source{}), 1000, 1).roots.empty());
    EXPECT_TRUE(scatterRoots(*makeSkin(test::sheet(4)), 0, 1).roots.empty());
    const auto flat = makeSkin(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
    EXPECT_TRUE(scatterRoots(*flat, 1000, 1).roots.empty());
}

TEST(Scatter, AutoWidthMakesTheFirstCoatOpaque) {
    const auto skin = makeSkin(test::sheet(4));
    const double width = autoWidth(*skin, 100000, 1.0f);
    EXPECT_NEAR(100000 / skin->area * 0.04 * skin->size() * width * 0.5, 3.0, 1e-4);
}

TEST(Scatter, ARootTakesSixteenBytes) { EXPECT_EQ(sizeof(Root), 16u); }

TEST(GrowCurves, HairsAreRootedOnTheirTrianglesAndFollowDensityWithoutMoving) {
    Document document = test::evenDocument(test::sheet(16));
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.fur.edit(v).density = 1.0f;
    const Roots roots = scatterRoots(*document.skin, 20000, 1);
    const Curves full = growCurves(document, roots, 8);
    EXPECT_EQ(full.root.size(), roots.roots.size());
    for (std::size_t h = 0; h < full.root.size(); ++h)
        EXPECT_NEAR(full.points[h * 9].y, 0.0f, 1e-6f);

    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.fur.edit(v).density = 0.3f;
    const Curves thin = growCurves(document, roots, 8);
    EXPECT_NEAR(static_cast<double>(thin.root.size()) / static_cast<double>(full.root.size()), 0.3,
                0.01);
    double moved = 0.0;
    for (std::size_t h = 0; h < thin.root.size(); ++h)
        for (uint p = 0; p < 9; ++p)
            moved += thin.points[h * 9 + p] != full.points[thin.root[h] * 9 + p];
    test::reached("R10", "points of hair that move where its density is painted", moved, 0.0);
}

TEST(GrowCurves, TheShareOfTheOvercoatIsTheOneAsked) {
    std::size_t over = 0, count = 100000;
    for (uint i = 0; i < count; ++i) over += isOvercoat(hairId(i, 0, 1), 0.3f);
    EXPECT_NEAR(static_cast<double>(over) / static_cast<double>(count), 0.3, 0.006);
    EXPECT_FALSE(isOvercoat(hairId(1, 2, 3), 0.0f));
    EXPECT_TRUE(isOvercoat(hairId(1, 2, 3), 1.0f));
}

}  // namespace
}  // namespace pelage
