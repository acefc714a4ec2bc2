// segment_comb.cpp -- axes of the body in the direction field, one by one and all at once.
#include "segment_comb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "tools.h"

namespace pelage {
namespace {

constexpr float kReach = 0.03f;    // L, of the skin's size
constexpr float kFaintest = 0.4f;  // tangential share of a unit vector below which it fades
constexpr float kEdgeWeight = 0.577350269f;  // tan(30 degrees), see the header
// A / (L^2 kEdgeWeight) is at most this, so that on meshes with edges longer than L the vertices
// at a border still share their axes.
constexpr float kFirmest = 0.5f;
constexpr int kFineSweeps = 12, kCoarseSweeps = 40;
constexpr float kDamping = 0.8f;       // of Jacobi: settles waves from vertex to vertex
constexpr std::size_t kCoarsest = 64;  // vertices
constexpr uint kNone = ~0u;

// A graph with a wish at each vertex: the skin itself, or whole one-rings of a finer level as one.
struct Level {
    std::vector<uint> first, rings;  // as in Skin
    std::vector<float> hold;         // A / (L^2 kEdgeWeight): how firmly a vertex holds its wish
    std::vector<vec3> wish;          // t, world

    std::size_t size() const { return wish.size(); }
};

Level finest(const Skin& skin, const Groom& groom) {
    const std::size_t count = skin.vertices.size();
    const std::span<const Segment> body = groom.body();
    Level level{skin.ringFirst, skin.rings, std::vector<float>(count, 0.0f),
                std::vector<vec3>(count)};
    const float reach = kReach * skin.size();
    const float perArea = 1.0f / (3.0f * reach * reach * kEdgeWeight);
    for (std::size_t t = 0; t < skin.triangles.size(); ++t)
        for (int c = 0; c < 3; ++c) level.hold[skin.triangles[t][c]] += perArea * skin.areas[t];
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t v) {
        const uint segment = groom.segmentOf[v];
        const vec3 axis = segment == kNoSegment ? vec3(0.0f) : axisOf(body[segment]);
        if (axis == vec3(0.0f)) level.hold[v] = 0.0f;
        const vec3 normal = skin.vertices[v].normal;
        level.wish[v] = axis - glm::dot(axis, normal) * normal;
    });
    return level;
}

// Each vertex's place in the coarser level: one-rings in which nobody was taken, then who is left
// with the first neighbour that was.
std::vector<uint> gather(const Level& fine) {
    std::vector<uint> place(fine.size(), kNone);
    uint count = 0;
    const auto ring = [&](std::size_t v) {
        return std::span(fine.rings).subspan(fine.first[v], fine.first[v + 1] - fine.first[v]);
    };
    for (std::size_t v = 0; v < fine.size(); ++v) {
        const auto free = [&](uint n) { return place[n] == kNone; };
        if (place[v] != kNone || !std::ranges::all_of(ring(v), free)) continue;
        place[v] = count;
        for (const uint n : ring(v)) place[n] = count;
        ++count;
    }
    const std::vector<uint> rings = place;
    for (std::size_t v = 0; v < fine.size(); ++v)
        for (const uint n : ring(v))
            if (place[v] == kNone) place[v] = rings[n];
    return place;
}

Level coarser(const Level& fine, const std::vector<uint>& place) {
    const std::size_t count = 1 + std::ranges::max(place);
    std::vector<std::vector<uint>> neighbours(count);
    Level level{{}, {}, std::vector<float>(count, 0.0f), std::vector<vec3>(count, vec3(0.0f))};
    for (std::size_t v = 0; v < fine.size(); ++v) {
        const uint to = place[v];
        level.hold[to] += fine.hold[v];
        level.wish[to] += fine.hold[v] * fine.wish[v];
        for (uint r = fine.first[v]; r < fine.first[v + 1]; ++r) {
            const uint other = place[fine.rings[r]];
            if (other != to && std::ranges::find(neighbours[to], other) == neighbours[to].end())
                neighbours[to].push_back(other);
        }
    }
    level.first.push_back(0);
    for (std::size_t v = 0; v < count; ++v) {
        level.rings.insert(level.rings.end(), neighbours[v].begin(), neighbours[v].end());
        level.first.push_back(static_cast<uint>(level.rings.size()));
        if (level.hold[v] > 0.0f) level.wish[v] /= level.hold[v];
    }
    return level;
}

// Jacobi: each vertex moves towards the mean of its neighbours and its wish.
std::vector<vec3> smoothed(const Level& level, std::vector<vec3> field, int sweeps) {
    std::vector<vec3> next(field.size());
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        tbb::parallel_for(std::size_t(0), field.size(), [&](std::size_t v) {
            const float hold = std::min(level.hold[v], kFirmest);
            vec3 sum = hold * level.wish[v];
            for (uint r = level.first[v]; r < level.first[v + 1]; ++r) sum += field[level.rings[r]];
            const float weight = hold + static_cast<float>(level.first[v + 1] - level.first[v]);
            next[v] = weight > 0.0f ? glm::mix(field[v], sum / weight, kDamping) : level.wish[v];
        });
        field.swap(next);
    }
    return field;
}

// Whether neighbours are about as far apart as the field may bend.
bool coarseEnough(const Level& level) {
    const auto firm = std::ranges::count_if(level.hold, [](float h) { return h >= kFirmest; });
    return level.size() <= kCoarsest || 2 * static_cast<std::size_t>(firm) >= level.size();
}

std::vector<vec3> solved(const Level& level) {
    if (!coarseEnough(level)) {
        const std::vector<uint> place = gather(level);
        const Level coarse = coarser(level, place);
        if (4 * coarse.size() < 3 * level.size()) {
            const std::vector<vec3> start = solved(coarse);
            std::vector<vec3> field(level.size());
            for (std::size_t v = 0; v < field.size(); ++v) field[v] = start[place[v]];
            return smoothed(level, std::move(field), kFineSweeps);
        }
    }
    return smoothed(level, level.wish, kCoarseSweeps);
}

bool finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Mixes a direction of the world into that of vertex v, as much as the mask lets through.
void mixIn(const Skin& skin, Groom& groom, uint v, vec3 direction, float weight) {
    const float share = weight * (1.0f - groom.mask[v]);
    if (!(share > 0.0f)) return;
    const FurVertex old = groom.fur[v];
    const FurVertex fur = furToWorld(skin, v, old);
    const vec3 mixed = inMesh(skin, v, fur, glm::mix(fur.direction, direction, share));
    // A flattened frame may have no finite answer; and writing what is there would copy a chunk.
    if (finite(mixed) && mixed != old.direction) groom.fur.edit(v).direction = mixed;
}

}  // namespace

vec3 laidOnSkin(vec3 comb, vec3 normal) {
    const vec3 tangential = comb - glm::dot(comb, normal) * normal;
    return tangential / std::max(glm::length(tangential), kFaintest);
}

vec3 axisOf(const Segment& segment) {
    const glm::dvec3 axis = glm::dvec3(segment.tip) - glm::dvec3(segment.root);
    const double length = glm::length(axis);
    return length > 0.0 && std::isfinite(length) ? vec3(axis / length) : vec3(0.0f);
}

void combSegment(const Skin& skin, Groom& groom, uint segment, vec3 axis, float weight) {
    assert(segment < groom.body().size() && weight >= 0.0f && weight <= 1.0f);
    const vec3 along = axisOf({"", vec3(0.0f), axis});
    assert(along != vec3(0.0f));
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        if (groom.segmentOf[v] == segment)
            mixIn(skin, groom, v, laidOnSkin(along, skin.vertices[v].normal), weight);
    }
}

std::vector<vec3> headToTail(const Skin& skin, const Groom& groom) {
    const auto hasAxis = [](const Segment& segment) { return axisOf(segment) != vec3(0.0f); };
    if (std::ranges::none_of(groom.body(), hasAxis))
        throw std::runtime_error(groom.body().empty()
                                     ? "the mesh has no body segments to comb along"
                                     : "no body segment of the mesh has an axis to comb along");
    std::vector<vec3> field = solved(finest(skin, groom));
    tbb::parallel_for(std::size_t(0), field.size(), [&](std::size_t v) {
        field[v] = laidOnSkin(field[v], skin.vertices[v].normal);
    });
    return field;
}

void combHeadToTail(const Skin& skin, Groom& groom, float weight) {
    assert(weight >= 0.0f && weight <= 1.0f);
    const std::vector<vec3> field = headToTail(skin, groom);
    for (uint v = 0; v < field.size(); ++v)
        if (field[v] != vec3(0.0f)) mixIn(skin, groom, v, field[v], weight);
}

}  // namespace pelage
