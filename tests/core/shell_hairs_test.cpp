// shell_hairs_test.cpp -- the promises of shell_map.h: noise, and hairs that stand on a tile.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "core/shell_map.h"
#include "core/strand.h"

namespace pelage {
namespace {

bool equal(const ShellMap& a, const ShellMap& b) {
    if (a.levels.size() != b.levels.size()) return false;
    for (std::size_t i = 0; i < a.levels.size(); ++i)
        for (std::size_t j = 0; j < a.levels[i].texels.size(); ++j) {
            const ShellTexel p = a.levels[i].texels[j], q = b.levels[i].texels[j];
            if (p.height != q.height || p.id != q.id) return false;
        }
    return true;
}

// The shortest way from one place of a tile to another, over the edge too.
vec2 wayTo(vec2 to, vec2 from) { return to - from - glm::round(to - from); }

TEST(ShellMap, NoiseIsUniformOfEightBitsAndAveragedOverTheEdge) {
    const Plane raw = noisePicture({.seed = 5, .side = 64, .mask = 1});
    double mean = 0.0, square = 0.0;
    for (const float value : raw.values) {
        EXPECT_EQ(value, std::round(value * 255.0f) / 255.0f);
        mean += static_cast<double>(value) / 4096.0;
        square += static_cast<double>(value) * static_cast<double>(value) / 4096.0;
    }
    EXPECT_NEAR(mean, 0.5, 0.018);  // 4 standard deviations
    EXPECT_NEAR(square - mean * mean, 1.0 / 12.0, 0.005);
    // By hand from the raw noise: 3 x 3, 1 2 1 and all alike; and 5 x 5, 1 4 6 4 1; in the corner.
    const auto at = [&](int x, int y) {
        return static_cast<double>(
            raw.values[static_cast<std::size_t>((y + 64) % 64 * 64 + (x + 64) % 64)]);
    };
    const std::map<int, std::vector<double>> rows = {{3, {1, 2, 1}},
                                                     {5, {1, 4, 6, 4, 1}},
                                                     {7, {1, 6, 15, 20, 15, 6, 1}},
                                                     {9, {1, 8, 28, 56, 70, 56, 28, 8, 1}}};
    for (const auto& [mask, row] : rows)
        for (const bool weighted : {true, false}) {
            double sum = 0.0, weights = 0.0;
            const int radius = mask / 2;
            for (int j = -radius; j <= radius; ++j)
                for (int i = -radius; i <= radius; ++i) {
                    const double weight = weighted ? row[static_cast<std::size_t>(i + radius)] *
                                                         row[static_cast<std::size_t>(j + radius)]
                                                   : 1.0;
                    sum += weight * at(i, j);
                    weights += weight;
                }
            const Plane averaged =
                noisePicture({.seed = 5, .side = 64, .mask = mask, .weighted = weighted});
            EXPECT_NEAR(static_cast<double>(averaged.values[0]), sum / weights, 1e-6) << mask;
        }
}

TEST(ShellMap, NoiseIsTheSameOnEveryMachine) {
    // Whole numbers below 2^24, exact in a float, and one division.
    const Plane noise = noisePicture({.seed = 5, .side = 32, .mask = 9});
    constexpr uint kRow[] = {1, 8, 28, 56, 70, 56, 28, 8, 1};
    for (uint y = 0; y < 32; ++y)
        for (uint x = 0; x < 32; ++x) {
            uint sum = 0;
            for (uint j = 0; j < 9; ++j)
                for (uint i = 0; i < 9; ++i) {
                    const uint place = (y + j + 28) % 32 * 32 + (x + i + 28) % 32;
                    sum += kRow[i] * kRow[j] * (pcg(place ^ pcg(5)) >> 24);
                }
            EXPECT_EQ(noise.values[y * 32 + x], static_cast<float>(sum) / (255.0f * 65536.0f));
        }
}

TEST(ShellMap, ASmallTileIsAveragedAroundItself) {
    for (const int side : {1, 2, 3, 5}) {
        const Plane raw = noisePicture({.side = side, .mask = 1});
        const Plane noise = noisePicture({.side = side, .mask = 9});
        double before = 0.0, after = 0.0;
        for (const float value : raw.values) before += static_cast<double>(value);
        for (const float value : noise.values) after += static_cast<double>(value);
        EXPECT_NEAR(before, after, 1e-5) << side;
        EXPECT_EQ(rankedMap(noise, {1.0f, 1.0f}, 1).levels.back().texels.size(), 1u);
    }
}

TEST(ShellMap, OneHairIsACone) {
    for (const float taper : {0.0f, 0.5f, 1.0f}) {
        const ShellMap map = hairMap({.side = 512, .hairs = 1, .radius = 0.4f, .taper = taper});
        for (const float t : {0.01f, 0.25f, 0.5f, 0.75f}) {
            const double radius = 0.4 * (1.0 - static_cast<double>(taper * t));
            EXPECT_NEAR(coverage(map.levels[0], t), std::numbers::pi * radius * radius, 0.0015)
                << taper << " " << t;
        }
        EXPECT_NEAR(coverage(map.levels[0], 1.0f),
                    std::numbers::pi * 0.16 * (1.0 - static_cast<double>(taper)) *
                        (1.0 - static_cast<double>(taper)),
                    0.0015);
    }
}

TEST(ShellMap, HairsApartCoverTheSumOfTheirDiscs) {
    // As wide as the two nearest roots allow, over the edge too.
    HairPattern pattern{.side = 2048, .hairs = 40};
    const std::vector<vec2> roots = rootMap({.side = 1, .hairs = pattern.hairs}).roots;
    pattern.radius = 0.5f;
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            pattern.radius =
                std::min(pattern.radius, 0.499f * glm::length(wayTo(roots[i], roots[j])));
    const ShellMap map = hairMap(pattern);
    for (const float t : {0.001f, 0.2f, 0.4f, 0.6f}) {
        const double r = static_cast<double>(pattern.radius * (1.0f - t));
        const double area = 40.0 * std::numbers::pi * r * r;
        EXPECT_NEAR(coverage(map.levels[0], t) / area, 1.0, 0.01) << t;
    }
}

TEST(ShellMap, APlaceOfTwoHairsBelongsToTheNearestRoot) {
    // Roots so near that no images of them in the next tiles come in between.
    HairPattern pattern{.seed = 0, .side = 512, .hairs = 2, .taper = 0.0f};
    const auto rootsOf = [](const HairPattern& p) {
        return rootMap({.seed = p.seed, .side = 1, .hairs = 2}).roots;
    };
    const auto apartIn = [](const std::vector<vec2>& roots) {
        return static_cast<double>(glm::length(wayTo(roots[1], roots[0])));
    };
    while (apartIn(rootsOf(pattern)) > 0.45) ++pattern.seed;
    const std::vector<vec2> roots = rootsOf(pattern);
    const double apart = apartIn(roots), r = 0.55 * apart;
    pattern.radius = static_cast<float>(r);
    const ShellLevel tile = hairMap(pattern).levels[0];
    // The union of two discs is their sum less the lens between them.
    const double lens = 2.0 * r * r * std::acos(apart / (2.0 * r)) -
                        0.5 * apart * std::sqrt(4.0 * r * r - apart * apart);
    EXPECT_NEAR(coverage(tile, 1.0f), 2.0 * std::numbers::pi * r * r - lens, 0.0015);
    for (int i = 0; i < 512 * 512; i += 37) {
        const ShellTexel texel = tile.texels[static_cast<std::size_t>(i)];
        const vec2 here = (vec2(i % 512, i / 512) + 0.5f) / 512.0f;
        const float first = glm::length(wayTo(roots[0], here)),
                    second = glm::length(wayTo(roots[1], here));
        if (texel.height > 0 && std::abs(first - second) > 0.001f) {
            EXPECT_EQ(texel.id, first < second ? 16384 : 49152) << i;
        }
    }
}

TEST(ShellMap, ManyHairsCoverAsDiscsOfChanceDo) {
    // 1 - exp(-n pi r^2), and a little more, since roots are more even than chance.
    for (const float t : {0.001f, 0.3f, 0.6f}) {
        const ShellMap map = hairMap({.side = 512, .hairs = 4096, .radius = 0.008f});
        const double r = 0.008 * (1.0 - static_cast<double>(t));
        const double sum = 4096.0 * std::numbers::pi * r * r;
        const double covered = coverage(map.levels[0], t);
        EXPECT_GT(covered, 1.0 - std::exp(-sum)) << t;
        EXPECT_LT(covered, std::min(sum, 1.25 * (1.0 - std::exp(-sum)))) << t;
    }
}

TEST(ShellMap, AShareOfTheIdsIsThatShareOfTheHairsEvenlySpread) {
    constexpr uint kHairs = 1024;
    const ShellMap map = hairMap({.side = 1024, .hairs = kHairs, .radius = 0.004f, .taper = 0.0f});
    std::set<int> ids;
    for (const ShellTexel& texel : map.levels[0].texels)
        if (texel.height > 0) ids.insert(texel.id);
    ASSERT_EQ(ids.size(), kHairs);
    for (const double share : {0.0625, 0.25, 0.5})
        EXPECT_EQ(std::ranges::count_if(ids, [&](int id) { return id < 65536.0 * share; }),
                  static_cast<int>(share * kHairs));
    // In 64 cells, as a share of the variance that chance would have: of the first quarter of the
    // hairs and of all.
    const std::vector<vec2> roots = rootMap({.side = 1, .hairs = kHairs}).roots;
    for (const uint hairs : {kHairs / 4, kHairs}) {
        std::vector<double> cells(64);
        const double mean = hairs / 64.0;
        for (uint i = 0; i < hairs; ++i) {
            const auto x = static_cast<std::size_t>(roots[i].x * 1024.0f),
                       y = static_cast<std::size_t>(roots[i].y * 1024.0f);
            EXPECT_EQ(map.levels[0].texels[y * 1024 + x].id, 64 * i + 32);
            ++cells[y / 128 * 8 + x / 128];
        }
        double variance = 0.0;
        for (const double count : cells) variance += (count - mean) * (count - mean) / 64.0;
        EXPECT_LT(variance / mean, 0.6) << hairs;
    }
}

TEST(RootMap, TheTwoNearestRootsAreThoseOfAll) {
    for (const uint hairs : {1u, 2u, 3u, 5u, 100u, 1000u})
        for (const int side : {1, 7, 32}) {
            const RootMap map = rootMap({.seed = 4, .side = side, .hairs = hairs});
            ASSERT_EQ(map.roots.size(), hairs);
            for (int i = 0; i < side * side; ++i) {
                const vec2 here = (vec2(i % side, i / side) + 0.5f) / static_cast<float>(side);
                std::vector<std::pair<float, uint>> all;
                for (uint hair = 0; hair < hairs; ++hair) {
                    const vec2 way = map.roots[hair] - here;
                    all.emplace_back(glm::length(way - glm::round(way)), hair);
                }
                std::ranges::sort(all);
                const RootTexel texel = map.texels[static_cast<std::size_t>(i)];
                EXPECT_EQ(texel.nearest, all[0].second) << hairs << " in " << side << ": " << i;
                EXPECT_EQ(texel.next, all[hairs > 1 ? 1 : 0].second) << hairs << " in " << side;
            }
        }
}

// A ray that goes down through hairs that taper to points: from the height 1 over `from` it travels
// `way` in x down to the skin. Whether it meets the hair at `root`, or an image of it near `from`.
struct Ray {
    glm::dvec2 from;
    double way;

    bool meets(glm::dvec2 root, double radius) const {
        // (from + s way - root)^2 <= (radius s)^2 for some s in [0,1].
        const glm::dvec2 to = from - root;
        const double a = way * way - radius * radius, b = to.x * way, c = glm::dot(to, to);
        if (b * b < a * c) return false;
        const double half = std::sqrt(b * b - a * c);
        return half >= b && -b - half <= a;
    }
};

// Hairs of 2 pixels and 64 high in a tile of 128 pixels: an optical depth of 1.36 at 45 degrees.
constexpr double kTile = 128.0, kRadius = 1.0, kHigh = 64.0;
constexpr uint kHairs = 348;

bool meetsNear(const Ray& ray, glm::dvec2 root, glm::dvec2 near) {
    return ray.meets(root + glm::round((near - root) / kTile) * kTile, kRadius);
}

bool meetsAny(const Ray& ray, const std::vector<vec2>& roots) {
    for (const vec2 root : roots)  // images may repeat along the way
        for (double x = 0.0; x < ray.way + kTile; x += 0.5 * kTile)
            if (meetsNear(ray, kTile * glm::dvec2(root), ray.from + glm::dvec2(x, 0.0)))
                return true;
    return false;
}

// The same of the hairs that are nearest to the places on the way, one look for each texel.
bool meetsOnTheWay(const Ray& ray, const RootMap& map) {
    const int looks = static_cast<int>(std::ceil(ray.way / kTile * map.size.x));
    for (int look = 0; look < looks; ++look) {
        const glm::dvec2 near = ray.from + glm::dvec2((look + 0.5) / looks * ray.way, 0.0);
        const auto texel =
            glm::uvec2((near / kTile - glm::floor(near / kTile)) * static_cast<double>(map.size.x));
        const RootTexel hairs = map.texels[texel.y * static_cast<uint>(map.size.x) + texel.x];
        for (const std::uint16_t hair : {hairs.nearest, hairs.next})
            if (meetsNear(ray, kTile * glm::dvec2(map.roots[hair]), near)) return true;
    }
    return false;
}

// The same of heights, two looks for each texel.
bool reachesOnTheWay(const Ray& ray, const ShellLevel& tile) {
    const int looks = static_cast<int>(std::ceil(2.0 * ray.way / kTile * tile.size.x));
    for (int look = 0; look < looks; ++look) {
        const double s = (look + 0.5) / looks;
        const glm::dvec2 at = (ray.from + glm::dvec2(s * ray.way, 0.0)) / kTile;
        const auto texel = glm::uvec2((at - glm::floor(at)) * static_cast<double>(tile.size.x));
        if (reaches(tile.texels[texel.y * static_cast<uint>(tile.size.x) + texel.x],
                    static_cast<float>(1.0 - s)))
            return true;
    }
    return false;
}

TEST(RootMap, AMarchOverTheNearestRootsMeetsTheHairsThatThereAre) {
    // Two texels across a hair.
    const HairPattern pattern{
        .seed = 2, .side = 128, .hairs = kHairs, .radius = static_cast<float>(kRadius / kTile)};
    const RootMap map = rootMap(pattern);
    const ShellMap heights = hairMap(pattern);
    constexpr int kPixels = 32;
    for (const double degrees : {10.0, 45.0, 70.0}) {
        const double angle = degrees * std::numbers::pi / 180.0;
        double bias = 0.0, square = 0.0, ofHeights = 0.0;
        for (int pixel = 0; pixel < kPixels * kPixels; ++pixel) {
            double error = 0.0;
            for (int sample = 0; sample < 16; ++sample) {
                const glm::dvec2 at(pixel % kPixels + (sample % 4 + 0.5) / 4.0,
                                    pixel / kPixels + (sample / 4 + 0.5) / 4.0);
                const Ray ray{{at.x / std::cos(angle), at.y}, kHigh * std::tan(angle)};
                const bool meets = meetsAny(ray, map.roots);
                error += (meetsOnTheWay(ray, map) - meets) / 16.0;
                ofHeights +=
                    (reachesOnTheWay(ray, heights.levels[0]) - meets) / (16.0 * kPixels * kPixels);
            }
            bias += error / (kPixels * kPixels);
            square += error * error / (kPixels * kPixels);
        }
        EXPECT_LE(std::abs(bias), 0.001) << degrees;
        EXPECT_LE(std::sqrt(square), 0.01) << degrees;
        if (degrees == 45.0) {
            EXPECT_LT(ofHeights, -0.03) << "the tips of hairs are finer than texels";
        }
    }
}

TEST(RootMap, FromEverySideHairsHideEachOtherAboutAsThoseOfChanceDo) {
    const double chance = 1.0 - std::exp(-1.36);
    for (const bool turned : {false, true}) {
        int hits = 0;
        for (uint seed = 0; seed < 8; ++seed) {
            std::vector<vec2> roots = rootMap({.seed = seed, .side = 1, .hairs = kHairs}).roots;
            if (turned)
                for (vec2& root : roots) root = {root.y, root.x};
            for (uint i = 0; i < 1000; ++i) {
                const uint id = pcg(i ^ pcg(seed + 1000));  // not the draws of the roots
                const glm::dvec2 from(rand01(id), rand01(id + 1));
                hits += meetsAny({kTile * from, kHigh}, roots);
            }
        }
        EXPECT_GT(hits / 8000.0, chance - 0.02) << turned;
        EXPECT_LT(hits / 8000.0, chance + 0.07) << turned;  // Sobol's sequence: 0.16
    }
}

TEST(ShellMap, TilesRepeatWithoutASeam) {
    // A disc that leaves the tile on one side comes in on the other; and noise differs no more over
    // the edge than inside.
    const ShellMap hairs = hairMap({.side = 256, .hairs = 64, .radius = 0.05f});
    const Plane noise = noisePicture({.side = 256, .mask = 9});
    const ShellMap ranked = rankedMap(noise, {1.0f, 1.0f}, 1);
    for (const ShellMap* map : {&hairs, &ranked}) {
        const auto step = [&](int x) {  // mean difference to the column on the left
            double sum = 0.0;
            for (int y = 0; y < 256; ++y) {
                const auto& texels = map->levels[0].texels;
                const int there = (x + 255) % 256;
                sum += std::abs(texels[static_cast<std::size_t>(256 * y + x)].height -
                                texels[static_cast<std::size_t>(256 * y + there)].height) /
                       256.0;
            }
            return sum;
        };
        double inside = 0.0, most = 0.0;
        for (int x = 1; x < 256; ++x) {
            inside += step(x) / 255.0;
            most = std::max(most, step(x));
        }
        EXPECT_LT(step(0), most + 0.2 * inside);
    }
}

TEST(ShellMap, EqualSeedsMakeEqualMapsAndOthersDoNot) {
    const HairPattern hairs{.side = 64, .hairs = 50};
    EXPECT_TRUE(equal(hairMap(hairs), hairMap(hairs)));
    HairPattern other = hairs;
    other.seed = 2;
    EXPECT_FALSE(equal(hairMap(hairs), hairMap(other)));
    const Plane flat{{16, 16}, std::vector<float>(256, 0.5f)};
    EXPECT_TRUE(equal(rankedMap(flat, {}, 4), rankedMap(flat, {}, 4)));
    EXPECT_FALSE(equal(rankedMap(flat, {}, 4), rankedMap(flat, {}, 5)));
}

}  // namespace
}  // namespace pelage
