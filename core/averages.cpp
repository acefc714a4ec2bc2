// averages.cpp -- sums over one-rings and over a grid in space.
#include "averages.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace pelage {
namespace {

// So many vertices within the reach weigh as much as the ring.
constexpr double kRingWeight = 3.0;

// Packs a cell into 3 x 21 bits. Cells 2^21 apart share a key; a skin is some thousand cells wide.
std::uint64_t keyOf(glm::ivec3 cell) {
    auto bits = [](int i) { return static_cast<std::uint64_t>(i) & 0x1fffff; };
    return bits(cell.x) | bits(cell.y) << 21 | bits(cell.z) << 42;
}

// How much a normal faces each of the six directions; sums to 1.
std::array<double, 6> facing(vec3 normal) {
    const glm::dvec3 square = glm::dvec3(normal) * glm::dvec3(normal);
    const double sum = square.x + square.y + square.z;
    std::array<double, 6> share;
    share.fill(1.0 / 6.0);
    if (!(sum > 0.0)) return share;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t plus = 2 * static_cast<std::size_t>(axis);
        share[plus] = normal[axis] > 0.0f ? square[axis] / sum : 0.0;
        share[plus + 1] = normal[axis] > 0.0f ? 0.0 : square[axis] / sum;
    }
    return share;
}

// Weights of the eight corners of a cell at a place in it, [0,1]^3; corner bits are x y z.
std::array<double, 8> cornerWeights(glm::dvec3 at) {
    std::array<double, 8> weight;
    for (std::size_t c = 0; c < 8; ++c)
        weight[c] =
            (c & 1 ? at.x : 1.0 - at.x) * (c & 2 ? at.y : 1.0 - at.y) * (c & 4 ? at.z : 1.0 - at.z);
    return weight;
}

glm::ivec3 cornerOf(glm::ivec3 cell, std::size_t c) {
    return cell + glm::ivec3(c & 1 ? 1 : 0, c & 2 ? 1 : 0, c & 4 ? 1 : 0);
}

}  // namespace

FurVertex towards(const FurVertex& a, const FurVertex& b, float share) {
    FurVertex mixed = a;
    mixed.furLength += share * (b.furLength - a.furLength);
    mixed.density += share * (b.density - a.density);
    mixed.direction += share * (b.direction - a.direction);
    mixed.tint += share * (b.tint - a.tint);
    return mixed;
}

void Averages::Sum::add(double share, const Sum& other) {
    weight += share * other.weight;
    length += share * other.length;
    density += share * other.density;
    direction += share * other.direction;
    tint += share * other.tint;
}

Averages::Averages(const SkinQuery& query, Groom before, float reach)
    : query_(&query),
      before_(std::move(before)),
      reach_(reach),
      means_(query.skin().vertices.size(), Mean{}) {
    assert(reach > 0.0f);
}

glm::ivec3 Averages::cellOf(vec3 position) const {
    // Far cells wrap around; the largest whole number of a float in the range of int.
    constexpr float kMost = 2147483520.0f;
    return glm::ivec3(glm::clamp(glm::floor(position / reach_), -kMost, kMost));
}

// Sums in the vertices of one cell, if they are not in yet.
void Averages::sumCell(glm::ivec3 cell) {
    if (!summed_.insert(keyOf(cell)).second) return;
    const Skin& skin = query_->skin();
    const vec3 middle = (vec3(cell) + 0.5f) * reach_;
    found_.clear();
    query_->within(middle, 0.87f * reach_, found_);  // half the diagonal of a cell is 0.866
    std::array<Cube*, 8> corners{};
    for (const uint v : found_) {
        const SkinVertex& vertex = skin.vertices[v];
        if (cellOf(vertex.position) != cell) continue;
        if (!corners[0])
            for (std::size_t c = 0; c < 8; ++c) corners[c] = &points_[keyOf(cornerOf(cell, c))];
        const FurVertex fur = furToWorld(skin, v, before_.fur[v]);
        const Sum value{1.0, fur.furLength, fur.density, glm::dvec3(fur.direction),
                        glm::dvec3(fur.tint)};
        const std::array<double, 6> side = facing(vertex.normal);
        const auto weights = cornerWeights(glm::dvec3(vertex.position / reach_) - glm::dvec3(cell));
        for (std::size_t c = 0; c < 8; ++c)
            for (std::size_t s = 0; s < 6; ++s)
                if (side[s] > 0.0) (*corners[c])[s].add(weights[c] * side[s], value);
    }
}

// Makes the eight grid points of the cell complete: all cells that touch them are summed.
void Averages::enter(glm::ivec3 cell) {
    if (inside_ && cell == cell_) return;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) sumCell(cell + glm::ivec3(x, y, z));
    for (std::size_t c = 0; c < 8; ++c) corners_[c] = &points_[keyOf(cornerOf(cell, c))];
    cell_ = cell;
    inside_ = true;
}

const FurVertex& Averages::around(uint v) {
    if (!means_[v].known) means_.edit(v) = {meanAround(v), true};
    return means_[v].fur;
}

FurVertex Averages::meanAround(uint v) {
    const Skin& skin = query_->skin();
    const SkinVertex& vertex = skin.vertices[v];
    enter(cellOf(vertex.position));
    const std::array<double, 6> side = facing(vertex.normal);
    const auto weights = cornerWeights(glm::dvec3(vertex.position / reach_) - glm::dvec3(cell_));
    Sum sum;
    for (std::size_t c = 0; c < 8; ++c)
        for (std::size_t s = 0; s < 6; ++s)
            if (side[s] > 0.0) sum.add(weights[c] * side[s], (*corners_[c])[s]);

    const FurVertex ring = ringMean(skin, before_, v);
    if (!(sum.weight > 0.0)) return ring;
    FurVertex mean{};
    mean.furLength = static_cast<float>(sum.length / sum.weight);
    mean.density = static_cast<float>(sum.density / sum.weight);
    mean.direction = vec3(sum.direction / sum.weight);
    mean.tint = vec3(sum.tint / sum.weight);
    return towards(ring, mean, static_cast<float>(sum.weight / (sum.weight + kRingWeight)));
}

FurVertex ringMean(const Skin& skin, const Groom& groom, uint v) {
    const FurVertex here = furToWorld(skin, v, groom.fur[v]);
    const std::span<const uint> ring = skin.ring(v);
    FurVertex mean = here;
    const float weight = 1.0f / static_cast<float>(std::max<std::size_t>(ring.size(), 1));
    for (const uint u : ring) {  // differences, so that an even field stays as it is
        const FurVertex there = furToWorld(skin, u, groom.fur[u]);
        mean.furLength += weight * (there.furLength - here.furLength);
        mean.density += weight * (there.density - here.density);
        mean.direction += weight * (there.direction - here.direction);
        mean.tint += weight * (there.tint - here.tint);
    }
    return mean;
}

}  // namespace pelage
