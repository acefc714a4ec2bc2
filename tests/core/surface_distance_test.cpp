// surface_distance_test.cpp -- distances along the skin against exact ones.
#include "core/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;

// A sheet of side 1 m in the plane y = 0 whose vertices are moved about in it, those at x = 0 along
// that line, and whose cells are cut along either diagonal.
Source irregularSheet(uint cells, uint seed) {
    Source source = test::sheet(cells);
    Draws draws(seed);
    const float move = 0.24f / static_cast<float>(cells);  // less than folds a cell
    for (vec3& p : source.positions)
        if (std::abs(p.x) < 0.499f && std::abs(p.z) < 0.499f)
            p += vec3(p.x == 0.0f ? 0.0f : draws.in(-move, move), 0.0f, draws.in(-move, move));
    for (std::size_t t = 0; t + 1 < source.triangles.size(); t += 2) {
        if (draws.below(2)) continue;
        const uvec3 first = source.triangles[t], second = source.triangles[t + 1];  // a c b, b c d
        source.triangles[t] = {first.x, first.y, second.z};
        source.triangles[t + 1] = {first.x, second.z, first.z};
    }
    return source;
}

struct Measured {
    std::shared_ptr<const Skin> skin;
    SkinQuery query;
    SurfaceDistance distance;
    vec3 from{0.0f};

    Measured(Source source, vec3 near, float reach, vec3 facing = vec3(0.0f))
        : skin(makeSkin(std::move(source))), query(skin) {
        const auto foot = query.nearest(near, facing);
        from = foot->position;
        distance.measure(query, *foot, reach);
    }

    // The largest error, as a share of the reach, where exact(position) is within it; and that
    // those and only those are reached, but for a thin rim.
    template <class Exact>
    double worst(float reach, Exact exact) const {
        double most = 0.0;
        std::size_t count = 0;
        for (uint v = 0; v < skin->vertices.size(); ++v) {
            const double right = exact(skin->vertices[v].position);
            const double found = distance.to(v);
            if (right > 1.02 * static_cast<double>(reach)) {
                EXPECT_EQ(found, INFINITY);
            }
            if (right > 0.98 * static_cast<double>(reach)) continue;
            EXPECT_LT(found, INFINITY);
            most = std::max(most, std::abs(found - right) / static_cast<double>(reach));
            ++count;
        }
        EXPECT_GT(count, 20u);
        return most;
    }
};

TEST(SurfaceDistance, IsExactOnAPlaneOfIrregularTriangles) {
    Draws draws(1);
    for (uint seed = 0; seed < 8; ++seed) {
        const float reach = draws.in(0.1f, 0.4f);
        const Measured measured(irregularSheet(40, seed), 0.3f * draws.inBox(1.0f) * vec3(1, 0, 1),
                                reach);
        EXPECT_LT(measured.worst(reach, [&](vec3 p) { return glm::distance(p, measured.from); }),
                  1e-6);
    }
}

TEST(SurfaceDistance, IsWithinATenthOfAPercentOnABallOfIrregularTriangles) {
    Draws draws(2);
    Source ball = test::ball(5);
    for (vec3& p : ball.positions) p = glm::normalize(p + 0.01f * draws.inBox(1.0f));
    for (const vec3 near : {vec3(1, 0, 0), vec3(0.3f, 0.8f, -0.5f), vec3(-0.1f, -0.2f, 1)}) {
        Source copy;
        copy.positions = ball.positions;
        copy.triangles = ball.triangles;
        copy.fileVertices = ball.fileVertices;
        copy.parts = ball.parts;
        const Measured measured(std::move(copy), near, 0.5f);
        const glm::dvec3 from = glm::normalize(glm::dvec3(measured.from));
        const double worst = measured.worst(0.5f, [&](vec3 p) {
            return std::acos(std::min(1.0, glm::dot(from, glm::normalize(glm::dvec3(p)))));
        });
        EXPECT_LT(worst, 0.001);
        RecordProperty("worst", std::to_string(worst));
    }
}

TEST(SurfaceDistance, GoesRoundAnEdgeAsIfTheSkinWereUnfolded) {
    Source source = irregularSheet(40, 3);
    for (vec3& p : source.positions)
        if (p.x > 0.0f) p = {0.0f, -p.x, p.z};
    const Measured measured(std::move(source), {-0.1f, 0.0f, 0.05f}, 0.3f);
    for (uint v = 0; v < measured.skin->vertices.size(); ++v) {
        const vec3 p = measured.skin->vertices[v].position;
        const double right = glm::distance(vec3(p.x - p.y, 0.0f, p.z), measured.from);
        if (right > 0.29) continue;
        EXPECT_NEAR(measured.distance.to(v), right, 1e-6);
    }
}

TEST(SurfaceDistance, LongestDetourIsNoneOnAPlaneAndThatOfTheFarthestPairOverAnEdge) {
    const Measured flat(irregularSheet(40, 3), {-0.1f, 0.0f, 0.05f}, 0.3f);
    EXPECT_NEAR(flat.distance.longestDetour(), 0.0, 1e-6);
    Source source = irregularSheet(40, 3);
    for (vec3& p : source.positions)
        if (p.x > 0.0f) p = {0.0f, -p.x, p.z};
    const Measured folded(std::move(source), {-0.1f, 0.0f, 0.05f}, 0.3f);
    double longest = 0.0;
    for (const SkinVertex& vertex : folded.skin->vertices) {
        const vec3 p = vertex.position;
        const double along = glm::distance(vec3(p.x - p.y, 0.0f, p.z), folded.from);
        if (along < 0.3)
            longest = std::max(longest, along - double{glm::distance(p, folded.from)});
    }
    EXPECT_GT(longest, 0.05);
    EXPECT_NEAR(folded.distance.longestDetour(), longest, 1e-6);
}

TEST(SurfaceDistance, LeavesTheOtherSheetAndWhatIsBeyondTheReachAlone) {
    const Measured measured(test::twoSheets(30, 0.004f), {0, 0.002f, 0}, 0.2f, {0, 1, 0});
    std::size_t reached = 0;
    for (uint v = 0; v < measured.skin->vertices.size(); ++v) {
        const vec3 p = measured.skin->vertices[v].position;
        const bool within = p.y > 0.0f && glm::distance(p, measured.from) <= 0.2f;
        EXPECT_EQ(measured.distance.to(v) < INFINITY, within);
        reached += within;
    }
    EXPECT_GT(reached, 50u);
}

TEST(SurfaceDistance, IsExactOverNeedlesAndTrianglesWithoutArea) {
    // Columns of very different widths, the narrow ones 1:1000, and between two columns a seam of
    // triangles without area: the same place twice.
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    Draws draws(4);
    constexpr uint kColumns = 24, kRows = 24;
    float x = -0.5f;
    for (uint i = 0; i <= kColumns; ++i) {
        for (uint k = 0; k <= kRows; ++k)
            positions.emplace_back(x, 0.0f, static_cast<float>(k) / kRows - 0.5f);
        if (i != 11) x += i % 3 == 1 ? 4e-5f : draws.in(0.03f, 0.09f);
    }
    for (uint i = 0; i < kColumns; ++i)
        for (uint k = 0; k < kRows; ++k) {
            const uint a = i * (kRows + 1) + k, b = a + kRows + 1;
            triangles.push_back({a, a + 1, b});
            triangles.push_back({b, a + 1, b + 1});
        }
    // The two columns at the same place must not be welded into one.
    Source source = test::oneMesh(positions, triangles);
    for (uint k = 0; k <= kRows; ++k) source.positions[12 * (kRows + 1) + k].y = 1e-44f;
    const Measured measured(std::move(source), {-0.2f, 0.0f, 0.03f}, 0.4f);
    EXPECT_GT(measured.skin->report.degenerateFaces, 20u);
    EXPECT_LT(measured.worst(0.4f, [&](vec3 p) { return glm::distance(p, measured.from); }), 1e-5);
}

TEST(SurfaceDistance, TakesTheShortestWayWhereThreeSheetsMeet) {
    // Three half sheets that share the line x = 0, one of them with its winding turned.
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    const vec3 spokes[] = {{1, 0, 0}, {-0.5f, 0.8660254f, 0}, {-0.5f, -0.8660254f, 0}};
    constexpr uint kCells = 20;
    for (uint s = 0; s < 3; ++s) {
        const uint first = static_cast<uint>(positions.size());
        for (uint i = 0; i <= kCells; ++i)
            for (uint k = 0; k <= kCells; ++k)
                positions.push_back(0.5f * static_cast<float>(i) / kCells * spokes[s] +
                                    vec3(0, 0, static_cast<float>(k) / kCells - 0.5f));
        for (uint i = 0; i < kCells; ++i)
            for (uint k = 0; k < kCells; ++k) {
                const uint a = first + i * (kCells + 1) + k, b = a + kCells + 1;
                triangles.push_back(s == 1 ? uvec3(a, b, a + 1) : uvec3(a, a + 1, b));
                triangles.push_back({b, a + 1, b + 1});
            }
    }
    const Measured measured(test::oneMesh(positions, triangles), {0.1f, 0.0f, 0.02f}, 0.3f);
    EXPECT_GT(measured.skin->report.nonManifoldEdges, 10u);
    EXPECT_LT(measured.worst(0.3f,
                             [&](vec3 p) {
                                 const float x = p.x > 0.0f ? p.x : -glm::length(vec2(p));
                                 return glm::distance(vec3(x, 0, p.z), measured.from);
                             }),
              1e-6);
}

TEST(SurfaceDistance, ReachesNearVerticesAcrossLargeTriangles) {
    // The corners of the triangle under the point are far outside the reach.
    const Measured measured(test::oneMesh({{-100, 0, 0}, {100, 0, 0}, {0, 0, 100}, {0, 0, -0.05f}},
                                          {{0, 2, 1}, {0, 1, 3}}),
                            {0.0f, 0.0f, 0.03f}, 0.1f);
    std::size_t reached = 0;
    for (uint v = 0; v < 4; ++v) {
        if (measured.skin->vertices[v].position.z > -0.01f) {
            EXPECT_EQ(measured.distance.to(v), INFINITY);
        } else {
            EXPECT_NEAR(measured.distance.to(v), 0.08, 1e-5);
            ++reached;
        }
    }
    EXPECT_EQ(reached, 1u);
}

TEST(SurfaceDistance, NothingIsNearBeforeItIsMeasuredOrAfterItIsCleared) {
    SurfaceDistance distance;
    EXPECT_EQ(distance.to(0), INFINITY);
    Measured measured(test::sheet(4), vec3(0.0f), 1.0f);
    EXPECT_LT(measured.distance.to(3), INFINITY);
    measured.distance.clear();
    EXPECT_EQ(measured.distance.to(3), INFINITY);
}

}  // namespace
}  // namespace pelage
