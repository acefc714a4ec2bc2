// shell_map.cpp -- discs, noise and pictures as heights of hair, and the levels of both.
#include "shell_map.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>

#include "strand.h"
#include "texel_cover.h"

namespace pelage {
namespace {

constexpr int kLargestSide = 8192;
constexpr std::uint16_t kTip = 65535;

std::size_t placeOf(ivec2 size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(x);
}

// Near the tile, so that this is faster than a division.
int wrapped(int x, int side) {
    while (x < 0) x += side;
    while (x >= side) x -= side;
    return x;
}

// A height of hair that is there, however short.
std::uint16_t heightCode(float height) {
    const float share = std::fmin(std::fmax(height, 0.0f), 1.0f);
    return static_cast<std::uint16_t>(std::max(std::lround(share * 65535.0f), 1l));
}

// How far up a hair is still as wide as `width`, a share of its width at the root.
float heightAt(float width, float taper) {
    return width <= 1.0f - taper ? 1.0f : (1.0f - width) / taper;
}

// Places of the values from the lowest to the highest; equal ones in an order of chance. NaN is the
// lowest.
std::vector<uint> ascending(std::span<const float> values, uint seed) {
    struct Key {
        uint value, chance, place;
        auto operator<=>(const Key&) const = default;
    };
    const auto orderOf = [](float value) {  // bits that are in order as the values are
        if (std::isnan(value)) return 0u;
        const auto bits = std::bit_cast<uint>(value + 0.0f);  // -0 is 0
        return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
    };
    std::vector<Key> keys(values.size());
    for (uint i = 0; i < keys.size(); ++i) keys[i] = {orderOf(values[i]), pcg(i ^ pcg(seed)), i};
    tbb::parallel_sort(keys.begin(), keys.end());
    std::vector<uint> places(keys.size());
    std::ranges::transform(keys, places.begin(), &Key::place);
    return places;
}

// The peak that each place belongs to, given the places in order: from the highest to the lowest,
// each goes with the highest of its eight neighbors, which has been given to a peak before.
std::vector<uint> peaksOf(ivec2 size, std::span<const uint> places) {
    std::vector<uint> ranks(places.size()), peaks(places.size());
    for (uint i = 0; i < places.size(); ++i) ranks[places[i]] = i;
    const auto width = static_cast<uint>(size.x);
    for (std::size_t i = places.size(); i-- > 0;) {
        const uint here = places[i];
        const int x = static_cast<int>(here % width), y = static_cast<int>(here / width);
        uint highest = here;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const auto there = static_cast<uint>(
                    placeOf(size, wrapped(x + dx, size.x), wrapped(y + dy, size.y)));
                if (ranks[there] > ranks[highest]) highest = there;
            }
        peaks[here] = highest == here ? here : peaks[highest];
    }
    return peaks;
}

ShellLevel bareLevel(ivec2 size) { return {size, std::vector<ShellTexel>(pixelCount(size))}; }

void giveIds(ShellLevel& level, std::span<const uint> places, uint seed) {
    const std::vector<uint> peaks = peaksOf(level.size, places);
    for (std::size_t i = 0; i < peaks.size(); ++i)
        level.texels[i].id = static_cast<std::uint16_t>(pcg(peaks[i] ^ pcg(seed + 1)) >> 16);
}

// Heights as they are averaged from level to level, and the hairs that go with them.
struct Averages {
    ivec2 size{0};
    std::vector<float> heights;
    std::vector<std::uint16_t> ids;
};

Averages halved(const Averages& fine) {
    Averages coarse{halfSize(fine.size), {}, {}};
    for (int y = 0; y < coarse.size.y; ++y)
        for (int x = 0; x < coarse.size.x; ++x) {
            const Cover across(x, fine.size.x, coarse.size.x), down(y, fine.size.y, coarse.size.y);
            double sum = 0.0, area = 0.0;
            std::size_t highest = placeOf(fine.size, across.first(), down.first());
            for (int j = down.first(); j < down.end(); ++j)
                for (int i = across.first(); i < across.end(); ++i) {
                    const std::size_t place = placeOf(fine.size, i, j);
                    const double share = across.share(i) * down.share(j);
                    sum += share * static_cast<double>(fine.heights[place]);
                    area += share;
                    if (fine.heights[place] > fine.heights[highest]) highest = place;
                }
            coarse.heights.push_back(static_cast<float>(sum / area));
            coarse.ids.push_back(fine.ids[highest]);
        }
    return coarse;
}

// The heights of a level by rank: of the lowest texel first.
class Heights {
public:
    explicit Heights(const ShellLevel& level) : texels_(level.texels.size()) {
        for (const ShellTexel& texel : level.texels) ++counts_[texel.height];
    }
    // In the middle of part i of n equal ones. Only with rising i.
    std::uint16_t quantile(std::size_t i, std::size_t n) {
        const std::size_t rank = (2 * i + 1) * texels_ / (2 * n);
        while (below_ + counts_[height_] <= rank) below_ += counts_[height_++];
        return static_cast<std::uint16_t>(height_);
    }

private:
    std::size_t texels_;
    std::vector<std::size_t> counts_ = std::vector<std::size_t>(std::size_t{kTip} + 1);
    std::size_t height_ = 0, below_ = 0;
};

ShellMap withLevels(ShellLevel tile, uint seed) {
    Averages averages{tile.size, {}, {}};
    for (const ShellTexel& texel : tile.texels) {
        averages.heights.push_back(texel.height);
        averages.ids.push_back(texel.id);
    }
    ShellMap map{{std::move(tile)}};
    while (averages.heights.size() > 1) {
        averages = halved(averages);
        const std::vector<uint> places = ascending(averages.heights, seed);
        Heights heights(map.levels.front());
        ShellLevel level = bareLevel(averages.size);
        for (std::size_t i = 0; i < places.size(); ++i)
            level.texels[places[i]] = {heights.quantile(i, places.size()), averages.ids[places[i]]};
        map.levels.push_back(std::move(level));
    }
    return map;
}

// One row of the averaging mask: a row of Pascal's triangle, or ones.
std::vector<float> maskRow(int mask, bool weighted) {
    std::vector<float> row(static_cast<std::size_t>(mask), 1.0f);
    if (weighted)
        for (std::size_t i = 1; i < row.size(); ++i)
            row[i] = row[i - 1] * static_cast<float>(row.size() - i) / static_cast<float>(i);
    return row;
}

// Sums over the mask along one axis, over the edge too. The sums are whole numbers up to 2^24, and
// so exact in a float.
Plane summed(const Plane& plane, std::span<const float> mask, ivec2 step) {
    Plane result{plane.size, {}};
    result.values.reserve(plane.values.size());
    const int radius = static_cast<int>(mask.size()) / 2;
    for (int y = 0; y < plane.size.y; ++y)
        for (int x = 0; x < plane.size.x; ++x) {
            float sum = 0.0f;
            for (int i = -radius; i <= radius; ++i)
                sum += mask[static_cast<std::size_t>(i + radius)] *
                       plane.values[placeOf(plane.size, wrapped(x + i * step.x, plane.size.x),
                                            wrapped(y + i * step.y, plane.size.y))];
            result.values.push_back(sum);
        }
    return result;
}

// The way between two places of a tile that repeats, by the shortest way.
float apart(vec2 a, vec2 b) {
    const vec2 way = a - b;
    return glm::length(way - glm::round(way));
}

// Roots in square cells, in the end about one in each, to find those that are near a place.
class RootGrid {
public:
    struct Found {
        RootTexel hairs;
        float distance = std::numeric_limits<float>::infinity(), nextDistance = distance;
    };

    explicit RootGrid(uint count)
        : side_(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count))))),
          cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {}

    void add(vec2 root) {
        cells_[placeOf(ivec2(side_), cellOf(root.x), cellOf(root.y))].push_back(
            static_cast<std::uint16_t>(roots_.size()));
        roots_.push_back(root);
    }
    const std::vector<vec2>& roots() const { return roots_; }

    Found nearestTwo(vec2 place) const {
        const float cell = 1.0f / static_cast<float>(side_);
        Found found;
        // Rings of cells around that of the place, until they are farther away than the second.
        for (int ring = 0; ring <= side_ / 2 + 1; ++ring) {
            if (found.nextDistance <= static_cast<float>(ring - 1) * cell) break;
            for (int y = -ring; y <= ring; ++y) {
                const int step = std::abs(y) == ring ? 1 : std::max(2 * ring, 1);
                for (int x = -ring; x <= ring; x += step)
                    look(place, cellOf(place.x) + x, cellOf(place.y) + y, found);
            }
        }
        return found;
    }

private:
    int cellOf(float x) const {
        return std::min(static_cast<int>(x * static_cast<float>(side_)), side_ - 1);
    }

    // A cell may be looked at twice, over the edges of a small tile.
    void look(vec2 place, int x, int y, Found& found) const {
        const std::size_t cell = placeOf(ivec2(side_), wrapped(x, side_), wrapped(y, side_));
        for (const std::uint16_t hair : cells_[cell]) {
            const float distance = apart(place, roots_[hair]);
            if (distance < found.distance) {
                const bool first = std::isinf(found.distance);
                found.hairs = {hair, first ? hair : found.hairs.nearest};
                found.nextDistance = found.distance;
                found.distance = distance;
            } else if (hair != found.hairs.nearest && distance < found.nextDistance) {
                found.hairs.next = hair;
                found.nextDistance = distance;
            }
        }
    }

    int side_;
    std::vector<std::vector<std::uint16_t>> cells_;
    std::vector<vec2> roots_;
};

// Each root is that of a few candidates which is farthest from those before it (Mitchell,
// "Spectrally Optimal Sampling for Distribution Ray Tracing", 1991), and so evenly spread from
// every side. The rows of a lattice or of Sobol's sequence would hide nothing of each other from
// two.
RootGrid evenRoots(uint count, uint seed) {
    constexpr uint kCandidates = 3;
    RootGrid grid(count);
    for (uint hair = 0; hair < count; ++hair) {
        vec2 farthest(0.0f);
        float most = -1.0f;
        for (uint i = 0; i < kCandidates; ++i) {
            const uint id = pcg((kCandidates * hair + i) ^ pcg(seed));
            const vec2 place(rand01(id), rand01(id + 1));
            const float distance = grid.nearestTwo(place).distance;
            if (distance > most) {
                farthest = place;
                most = distance;
            }
        }
        grid.add(farthest);
    }
    return grid;
}

vec2 middleOf(int x, int y, int side) { return (vec2(x, y) + 0.5f) / static_cast<float>(side); }

}  // namespace

double coverage(const ShellLevel& level, float t) {
    const auto covered =
        std::ranges::count_if(level.texels, [&](ShellTexel texel) { return reaches(texel, t); });
    return static_cast<double>(covered) / static_cast<double>(level.texels.size());
}

ivec2 halfSize(ivec2 size) { return glm::max(size / 2, ivec2(1)); }

std::size_t texelsWithLevels(ivec2 size) {
    std::size_t sum = pixelCount(size);
    for (; pixelCount(size) > 1; sum += pixelCount(size)) size = halfSize(size);
    return sum;
}

RootMap rootMap(const HairPattern& pattern) {
    assert(pattern.side >= 1 && pattern.side <= kLargestSide);
    assert(pattern.hairs >= 1 && pattern.hairs <= 65536);
    const RootGrid grid = evenRoots(pattern.hairs, pattern.seed);
    RootMap map{ivec2(pattern.side), {}, grid.roots()};
    map.texels.resize(pixelCount(map.size));
    tbb::parallel_for(0, pattern.side, [&](int y) {
        for (int x = 0; x < pattern.side; ++x)
            map.texels[placeOf(map.size, x, y)] =
                grid.nearestTwo(middleOf(x, y, pattern.side)).hairs;
    });
    return map;
}

ShellMap hairMap(const HairPattern& pattern) {
    assert(pattern.radius > 0.0f && pattern.radius <= 0.5f);
    const RootMap roots = rootMap(pattern);
    ShellLevel tile = bareLevel(roots.size);
    for (int y = 0; y < pattern.side; ++y)
        for (int x = 0; x < pattern.side; ++x) {
            const std::size_t place = placeOf(roots.size, x, y);
            const std::uint64_t hair = roots.texels[place].nearest;
            const float width =
                apart(middleOf(x, y, pattern.side), roots.roots[hair]) / pattern.radius;
            if (width <= 1.0f)
                tile.texels[place] = {
                    heightCode(heightAt(width, pattern.taper)),
                    static_cast<std::uint16_t>((2 * hair + 1) * 32768 / pattern.hairs)};
        }
    return withLevels(std::move(tile), pattern.seed);
}

Plane noisePicture(const NoisePattern& pattern) {
    assert(pattern.side >= 1 && pattern.side <= kLargestSide);
    assert(pattern.mask >= 1 && pattern.mask <= 9 && pattern.mask % 2 == 1);
    Plane picture{ivec2(pattern.side), {}};
    for (uint i = 0; i < pixelCount(picture.size); ++i)
        picture.values.push_back(static_cast<float>(pcg(i ^ pcg(pattern.seed)) >> 24));
    const std::vector<float> row = maskRow(pattern.mask, pattern.weighted);
    picture = summed(summed(picture, row, {1, 0}), row, {0, 1});
    const float sum = std::accumulate(row.begin(), row.end(), 0.0f);
    for (float& value : picture.values) value /= 255.0f * sum * sum;
    return picture;
}

ShellMap rankedMap(const Plane& picture, const ShellCut& cut, uint seed) {
    assert(cut.coverage > 0.0f && cut.coverage <= 1.0f && cut.taper >= 0.0f && cut.taper <= 1.0f);
    const std::vector<uint> places = ascending(picture.values, seed);
    ShellLevel tile = bareLevel(picture.size);
    giveIds(tile, places, seed);
    const auto count = static_cast<double>(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double fromTop = (count - static_cast<double>(i) - 0.5) / count;
        const double area = fromTop / static_cast<double>(cut.coverage);
        if (area > 1.0) continue;
        const float height = heightAt(static_cast<float>(std::sqrt(area)), cut.taper);
        tile.texels[places[i]].height = heightCode(height);
    }
    return withLevels(std::move(tile), seed);
}

ShellMap rawMap(const Plane& picture, uint seed) {
    ShellLevel tile = bareLevel(picture.size);
    giveIds(tile, ascending(picture.values, seed), seed);
    for (std::size_t i = 0; i < tile.texels.size(); ++i)
        if (picture.values[i] > 0.0f) tile.texels[i].height = heightCode(picture.values[i]);
    return withLevels(std::move(tile), seed);
}

}  // namespace pelage
