// plan_gltest.cpp -- which hairs a frame draws, and that thinning keeps the sum of their widths.
#include <gtest/gtest.h>

#include <vector>

#include "app/render/camera.h"
#include "app/render/strand_pass.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

constexpr uint kRoots = 100000;
constexpr float kWidth = 1e-3f;  // m

// One small cluster at the origin.
Roots oneCluster(vec3 center = vec3(0.0f)) {
    Roots roots;
    roots.roots.resize(kRoots);
    Cluster cluster;
    cluster.count = kRoots;
    cluster.center = center;
    cluster.radius = 0.01f;
    roots.clusters.push_back(cluster);
    return roots;
}

FrameData frameAt(float distance) {
    Camera camera;
    camera.distance = distance;
    FrameData frame;
    frame.viewProjection = camera.projection(1.0f, vec3(0.0f), 0.1f) * camera.view();
    frame.eye = camera.eye();
    frame.forward = camera.forward();
    frame.size = ivec2(500);
    frame.pixelsPerMetre = 250.0f / std::tan(0.5f * camera.fieldOfView);
    return frame;
}

// m; where hairs are one pixel wide.
float pixelDistance() { return kWidth * frameAt(1.0f).pixelsPerMetre; }

std::size_t hairsAt(float distance, float share = 1.0f, bool byDistance = true) {
    return planStrands(oneCluster(), frameAt(distance), kWidth, 0.0f, share, byDistance).hairs;
}

TEST(Plan, AllHairsAreKeptWhereTheyAreWiderThanAPixel) {
    for (const float closer : {0.1f, 0.5f, 0.99f})
        EXPECT_EQ(hairsAt(closer * pixelDistance()), kRoots) << closer;
}

TEST(Plan, CountsFallAsOneOverDistance) {
    const double atTwo = static_cast<double>(hairsAt(2.0f * pixelDistance()));
    EXPECT_LT(atTwo, kRoots);
    for (const float farther : {3.0f, 4.0f, 8.0f, 16.0f, 32.0f}) {
        const double hairs = static_cast<double>(hairsAt(farther * pixelDistance()));
        EXPECT_NEAR(hairs * static_cast<double>(farther) / (2.0 * atTwo), 1.0, 1e-3) << farther;
    }
    EXPECT_EQ(hairsAt(4.0f * pixelDistance(), 1.0f, false), kRoots);
}

TEST(Plan, TheDistanceAlongTheViewCountsAndNotTheAngle) {
    FrameData frame = frameAt(4.0f * pixelDistance());
    const vec3 beside = oneCluster().clusters[0].center + vec3(0.8f, 0.5f, 0.0f);
    EXPECT_EQ(planStrands(oneCluster(beside), frame, kWidth, 0.0f, 1.0f, true).hairs,
              hairsAt(4.0f * pixelDistance()));
}

TEST(Plan, ShareScalesTheCounts) {
    const double tenth = static_cast<double>(hairsAt(0.5f * pixelDistance(), 0.1f));
    for (const float share : {0.2f, 0.4f, 0.8f})
        EXPECT_NEAR(static_cast<double>(hairsAt(0.5f * pixelDistance(), share)) / tenth,
                    10.0 * static_cast<double>(share), 1e-2)
            << share;
    EXPECT_EQ(hairsAt(0.5f * pixelDistance(), 1.0f), kRoots);
    // It multiplies what the distance leaves.
    EXPECT_EQ(hairsAt(2.0f * pixelDistance(), 0.2f), hairsAt(0.5f * pixelDistance(), 0.1f));
}

TEST(Plan, ClustersOutsideTheViewAreLeftOut) {
    const FrameData frame = frameAt(1.0f);
    const float half = std::tan(0.3f);  // m seen to each side of the origin
    const auto hairs = [&](vec3 center, float reach) {
        return planStrands(oneCluster(center), frame, kWidth, reach, 1.0f, false).hairs;
    };
    for (const vec3 side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0)}) {
        EXPECT_EQ(hairs(0.99f * half * side, 0.0f), kRoots);
        EXPECT_EQ(hairs(half * side + 0.005f * side, 0.0f), kRoots);  // its ball reaches in
        EXPECT_EQ(hairs(half * side + 0.02f * side, 0.0f), 0u);
        EXPECT_EQ(hairs(half * side + 0.02f * side, 0.1f), kRoots);  // its hair reaches in
    }
}

TEST(Plan, RunsCoverThePrefixOfEveryClusterOnce) {
    Roots roots = oneCluster();
    Cluster second = roots.clusters[0];
    roots.clusters[0].count = 60000;
    second.first = 60000;
    second.count = 40000;
    second.center = vec3(0.1f, 0.0f, 0.0f);
    roots.clusters.push_back(second);
    const StrandPlan plan = planStrands(roots, frameAt(1.0f), kWidth, 0.0f, 0.3f, false);
    ASSERT_EQ(plan.runs.size(), 2u);
    uint next = 0;
    for (std::size_t r = 0; r < 2; ++r) {
        const StrandPlan::Run& run = plan.runs[r];
        const Cluster& cluster = roots.clusters[r];
        EXPECT_EQ(run.first, cluster.first);
        EXPECT_EQ(run.begin, next);
        EXPECT_FLOAT_EQ(run.lod, 0.3f);
        EXPECT_GE(run.fade, run.lod);
        EXPECT_EQ(run.phase, cluster.phase);
        // Up to the rank at which a hair has faded out, and not much more.
        const float wanted = run.fade * static_cast<float>(cluster.count);
        EXPECT_EQ(run.end - run.begin, static_cast<uint>(std::ceil(wanted)));
        next = run.end;
    }
    EXPECT_EQ(next, plan.hairs);
}

TEST(Plan, GroupsAreFullHoweverFewHairsAClusterGives) {
    Roots roots;
    for (uint c = 0; c < 1000; ++c) roots.clusters.push_back({.first = 40 * c, .count = 40});
    const StrandPlan plan = planStrands(roots, frameAt(1.0f), kWidth, 0.0f, 0.05f, false);
    ASSERT_EQ(plan.runs.size(), 1000u);
    EXPECT_EQ(plan.groups.size(), (plan.hairs + 31) / 32);
    for (uint g = 0; g < plan.groups.size(); ++g) {
        const StrandPlan::Run& run = plan.runs[plan.groups[g].run];
        EXPECT_TRUE(run.begin <= 32 * g && 32 * g < run.end) << g;
    }
}

// The text of a function of a shipped shader.
std::string functionOf(const std::string& file, const std::string& head) {
    const std::string text = expandShader(file).text;
    const std::size_t from = text.find(head);
    if (from == std::string::npos) throw std::runtime_error(file + " has no " + head);
    return text.substr(from, text.find("\n}\n", from) + 3 - from);
}

TEST(Plan, ThinningKeepsTheSumOfTheWidths) {
    const gl::ProgramName program = test::computeProgram(
        "#version 450 core\n" + functionOf("strand_raster.comp", "float fadedWidth(") + R"(
        layout(local_size_x = 1) in;
        layout(std430, binding = 0) readonly buffer Levels { vec2 levels[]; };  // lod, fade
        layout(std430, binding = 1) writeonly buffer Sums { vec2 sums[]; };     // sum, least step
        void main() {
            const int kRanks = 8192;
            uint i = gl_GlobalInvocationID.x;
            float sum = 0.0;
            float rise = 0.0;
            float last = 1e9;
            for (int k = 0; k < kRanks; ++k) {
                float rank = (float(k) + 0.5) / float(kRanks);
                float width = rank < levels[i].y ? fadedWidth(rank, levels[i].x, levels[i].y) : 0.0;
                sum += width;
                rise = max(rise, width - last);
                last = width;
            }
            sums[i] = vec2(sum / float(kRanks), rise);
        })");
    std::vector<vec2> levels;
    for (const float share : {0.01f, 0.02f, 0.1f, 0.3f, 0.5f, 0.7f, 0.83f, 0.9f, 0.99f, 1.0f}) {
        const StrandPlan plan =
            planStrands(oneCluster(), frameAt(1.0f), kWidth, 0.0f, share, false);
        levels.emplace_back(plan.runs.front().lod, plan.runs.front().fade);
    }
    const gl::Buffer from = test::bufferOf(levels);
    gl::Buffer into;
    into.resize(levels.size() * sizeof(vec2));
    from.bindStorage(0);
    into.bindStorage(1);
    glUseProgram(program.name());
    glDispatchCompute(static_cast<GLuint>(levels.size()), 1, 1);
    const auto sums = test::valuesOf<vec2>(into.name(), levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        EXPECT_NEAR(sums[i].x, 1.0f, 5e-3f) << levels[i].x;
        EXPECT_LE(sums[i].y, 0.0f) << levels[i].x;  // no hair is wider than one of lower rank
    }
}

}  // namespace
}  // namespace pelage
