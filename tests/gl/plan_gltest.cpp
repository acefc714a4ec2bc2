// plan_gltest.cpp -- what is chosen of the hair, as the strand pass reads it.
#include <gtest/gtest.h>

#include <cmath>

#include "app/render/strand_pass.h"
#include "tests/core/sights.h"

namespace pelage {
namespace {

Detail share(float limit) { return {.rule = Detail::Rule::share, .limit = limit}; }

StrandPlan planOf(const Roots& roots, const Detail& detail) {
    const Sight sight = test::sightFrom(vec3(0, 0, 1));
    return planStrands(roots, test::choiceOf(roots, sight, detail), false);
}

TEST(Plan, RunsCoverThePrefixOfEveryClusterOnce) {
    Roots roots = test::oneCluster();
    Cluster second = roots.clusters[0];
    roots.clusters[0].count = 60000;
    second.first = 60000;
    second.count = 40000;
    second.center = vec3(0.1f, 0.0f, 0.0f);
    roots.clusters.push_back(second);
    const StrandPlan plan = planOf(roots, share(0.3f));
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
    EXPECT_EQ(next, plan.wideEnd);
}

// Clusters of 40 roots, every second one near enough to be wide.
Roots manyClusters() {
    Roots roots;
    for (uint c = 0; c < 1000; ++c)
        roots.clusters.push_back(
            {.first = 40 * c, .count = 40, .center = vec3(0.0f, 0.0f, c % 2 ? 0.6f : -0.2f)});
    return roots;
}

void expectGroups(const StrandPlan& plan) {
    EXPECT_EQ(plan.groups.size(), (plan.end + 31) / 32);
    for (uint g = 0; g < plan.groups.size(); ++g) {
        const StrandPlan::Run& run = plan.runs[plan.groups[g]];
        EXPECT_TRUE(run.begin <= 32 * g && 32 * g < run.end) << g;
    }
}

TEST(Plan, GroupsAreFullHoweverFewHairsAClusterGives) {
    const StrandPlan plan = planOf(manyClusters(), share(0.05f));
    ASSERT_EQ(plan.runs.size(), 1000u);
    expectGroups(plan);
    EXPECT_EQ(plan.narrowBegin, (plan.wideEnd + 31) / 32 * 32);
}

TEST(Plan, NarrowHairsComeAfterTheOthersInGroupsOfTheirOwn) {
    const Roots roots = manyClusters();
    const Detail all{.rule = Detail::Rule::all};
    const StrandPlan plan = planOf(roots, all);
    expectGroups(plan);
    EXPECT_EQ(plan.wideEnd, 500u * 40u);
    EXPECT_EQ(plan.narrowBegin % 32, 0u);
    EXPECT_EQ(plan.end - plan.narrowBegin, 500u * 40u);
    for (std::size_t r = 0; r < plan.runs.size(); ++r)
        EXPECT_EQ(plan.runs[r].first / 40 % 2 == 1, r < 500) << r;
}

}  // namespace
}  // namespace pelage
