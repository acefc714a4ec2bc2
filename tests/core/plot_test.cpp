// plot_test.cpp -- the promises of plot.h.
#include "core/plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <regex>

namespace pelage {
namespace {

std::size_t countOf(const std::string& text, const std::string& pattern) {
    const std::regex wanted(pattern);
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), {}));
}

// Where the circles of the points are; those of the legend have no title.
std::vector<std::pair<double, double>> places(const std::string& svg) {
    const std::regex circle(R"re(<circle cx="([0-9.]+)" cy="([0-9.]+)"[^>]*><title>)re");
    std::vector<std::pair<double, double>> found;
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), circle);
         it != std::sregex_iterator(); ++it)
        found.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
    return found;
}

Plot plotOf(std::vector<PlotPoint> points) {
    return {.title = "t", .xLabel = "x", .yLabel = "y", .series = {{"s", std::move(points)}}};
}

TEST(Plot, AxesAreLogarithmicAndErrorsGrowUpwards) {
    const Plot plot = plotOf({{1, 1, "", false}, {10, 10, "", false}, {100, 1000, "", false}});
    const auto at = places(svgOf(std::vector{plot}, ""));
    ASSERT_EQ(at.size(), 3u);
    EXPECT_NEAR(at[1].first - at[0].first, at[2].first - at[1].first, 0.2);
    EXPECT_GT(at[1].first, at[0].first);
    EXPECT_NEAR(2.0 * (at[0].second - at[1].second), at[1].second - at[2].second, 0.3);
    EXPECT_GT(at[0].second, at[1].second);
}

TEST(Plot, AxesOfLessThanADecadeHaveTicksToo) {
    for (const double most : {1.1, 2.1, 3.0, 6.0, 9.5, 40.0, 3000.0}) {
        for (const double least : {1.0, 1.3, 2.1, 2.6, 5.1, 8.0}) {
            const Plot plot = plotOf({{least, 1, "", false}, {least * most, 100, "", false}});
            const std::string svg = svgOf(std::vector{plot}, "");
            const std::size_t ticks = countOf(svg, R"re(text-anchor="middle">[0-9.e+]+<)re");
            EXPECT_GE(ticks, 3u) << least << " to " << least * most;
            EXPECT_LE(ticks, 14u) << least << " to " << least * most;
        }
    }
}

TEST(Plot, PointsWithoutAnOrderAreNotJoined) {
    Plot plot = plotOf({{1, 1, "", false}, {10, 10, "", false}});
    const std::size_t before = countOf(svgOf(std::vector{plot}, ""), "<polyline");
    plot.series[0].joined = false;
    const std::string svg = svgOf(std::vector{plot}, "");
    EXPECT_EQ(countOf(svg, "<polyline"), before - 1);
    EXPECT_EQ(places(svg).size(), 2u);
}

TEST(Plot, WhatIsNotPositiveAndFiniteIsLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    const Plot plot = plotOf({{0, 1, "", true},
                              {1, -1, "", false},
                              {nan, 1, "", true},
                              {1, infinite, "", false},
                              {2, 3, "", false}});
    const std::string svg = svgOf(std::vector{plot}, "");
    EXPECT_EQ(places(svg).size(), 1u);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_TRUE(places(svgOf(std::vector{plotOf({})}, "")).empty());
}

TEST(Plot, PlotsStandSideBySideAboveOneLegend) {
    const Plot plot = plotOf({{1, 1, "", false}, {10, 10, "", false}});
    const std::string one = svgOf(std::vector{plot}, "f"),
                      two = svgOf(std::vector{plot, plot}, "f");
    const auto at = places(two);
    ASSERT_EQ(at.size(), 4u);
    EXPECT_GT(at[2].first, at[1].first);
    EXPECT_NEAR(at[2].second, at[0].second, 1e-9);
    EXPECT_EQ(countOf(one, ">s<"), 1u);
    EXPECT_EQ(countOf(two, ">s<"), 1u);
    EXPECT_EQ(countOf(two, ">f<"), 1u);
}

TEST(Plot, PointsOfTheFrontAreRingedAndJoined) {
    const Plot plot =
        plotOf({{1, 4, "", true}, {2, 5, "", false}, {3, 3, "", true}, {4, 6, "", false}});
    const std::string svg = svgOf(std::vector{plot}, "");
    EXPECT_EQ(countOf(svg, "<circle[^>]* stroke=\"#111\""), 2u);
    const std::regex joined(R"re(<polyline[^>]*#ffe08a[^>]* points="([^"]*)")re");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, joined));
    EXPECT_EQ(countOf(match[1], ","), 2u);
}

TEST(Plot, TheLegendNamesTheFrontWhereThereIsOne) {
    const Plot none = plotOf({{1, 4, "", false}, {3, 3, "", false}}),
               some = plotOf({{1, 4, "", true}, {3, 3, "", false}});
    EXPECT_EQ(countOf(svgOf(std::vector{none, none}, ""), "Pareto|#ffe08a"), 0u);
    EXPECT_EQ(countOf(svgOf(std::vector{none, some}, ""), ">Pareto front<"), 1u);
}

TEST(Plot, LongTitlesAndFootersAreNotCut) {
    // The letters of a sans serif face are at most 0.6 of its size wide in the mean.
    const auto widthOf = [](const std::string& svg, const std::string& text) {
        std::smatch match;
        const bool found =
            std::regex_search(svg, match, std::regex("font-size=\"([0-9.]+)\"[^>]*>" + text + "<"));
        EXPECT_TRUE(found);
        return found ? 0.6 * std::stod(match[1]) * static_cast<double>(text.size()) : 0.0;
    };
    Plot plot = plotOf({{1, 1, "", false}, {10, 10, "", false}});
    for (const std::size_t letters : {1u, 20u, 60u, 200u}) {
        plot.title = std::string(letters, 't');
        const std::string footer(letters, 'f');
        const std::string svg = svgOf(std::vector{plot}, footer);
        EXPECT_LT(widthOf(svg, plot.title), 430.0) << letters;
        EXPECT_LT(widthOf(svg, footer), 460.0) << letters;
    }
}

TEST(Plot, ALineStandsAtTheFloorWhereItLiesInThePicture) {
    Plot plot = plotOf({{1, 1, "", false}, {10, 100, "", false}});
    plot.floorLabel = "floor";
    for (const auto& [floor, lines] : {std::pair(0.0, 0u), {10.0, 1u}, {1e-6, 0u}, {1e6, 0u}}) {
        plot.floor = floor;
        EXPECT_EQ(countOf(svgOf(std::vector{plot}, ""), ">floor<"), lines) << floor;
    }
}

TEST(Plot, NamesCannotBreakTheMarkup) {
    Plot plot = plotOf({{1, 1, "<&\">", false}});
    plot.title = "a<b & \"c\"";
    const std::string svg = svgOf(std::vector{plot}, "<f>");
    EXPECT_NE(svg.find(">a&lt;b &amp; &quot;c&quot;</text>"), std::string::npos);
    EXPECT_NE(svg.find(">&lt;&amp;&quot;&gt;</text>"), std::string::npos);
    EXPECT_NE(svg.find(">&lt;f&gt;</text>"), std::string::npos);
}

}  // namespace
}  // namespace pelage
