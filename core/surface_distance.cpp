// surface_distance.cpp -- the spreading of distances over triangles.
#include "surface_distance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace pelage {
namespace {

constexpr uint kNone = ~0u;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kQueues = 64;        // rings of equal width up to the reach
constexpr std::size_t kFirstSlots = 1024;  // a power of 2
constexpr double kLeastGain = 1e-9;        // of the reach; smaller gains are rounding
constexpr uint kMostTold = 8;              // once is usual; bounds the cost where triangles cross
constexpr double kAlmost = 1.0 - 1e-8;

}  // namespace

void SurfaceDistance::clear() {
    nodes_.clear();
    std::fill(slots_.begin(), slots_.end(), Slot{kNone, kNone});
}

// Where vertex v is in the table, or would be.
std::size_t SurfaceDistance::slotOf(uint v) const {
    const std::size_t wrap = slots_.size() - 1;
    std::size_t slot = (v * std::size_t{0x9e3779b97f4a7c15} >> 32) & wrap;
    while (slots_[slot].vertex != v && slots_[slot].vertex != kNone) slot = (slot + 1) & wrap;
    return slot;
}

void SurfaceDistance::grow() {
    slots_.assign(std::max(kFirstSlots, 2 * slots_.size()), {kNone, kNone});
    for (uint node = 0; node < nodes_.size(); ++node)
        slots_[slotOf(nodes_[node].vertex)] = {nodes_[node].vertex, node};
}

uint SurfaceDistance::nodeOf(uint v) {
    Slot& slot = slots_[slotOf(v)];
    if (slot.vertex == v) return slot.node;
    const uint node = static_cast<uint>(nodes_.size());
    slot = {v, node};
    nodes_.push_back({query_->skin().vertices[v].position, v, kInfinite});
    if (2 * nodes_.size() > slots_.size()) grow();
    return node;
}

void SurfaceDistance::improve(uint node, double distance) {
    Node& at = nodes_[node];
    if (!(distance < at.distance - kLeastGain * reach_)) return;
    const auto queueFor = [&](double far) {
        const double ring = far / reach_ * static_cast<double>(kQueues);
        const std::size_t queue =
            ring < static_cast<double>(kQueues) ? static_cast<std::size_t>(ring) : kQueues;
        return std::max(queue, queue_);
    };
    const std::size_t queue = queueFor(distance);
    const bool queued = at.waiting && queueFor(at.distance) == queue;
    at.distance = distance;
    if (at.told == kMostTold) return;
    at.waiting = true;
    if (!queued) queues_[queue].push_back(node);
}

void SurfaceDistance::alongEdge(uint from, uint to) {
    const Node& a = nodes_[from];
    const Node& b = nodes_[to];
    const double gain = b.distance - a.distance;
    if (!(gain > 0.0)) return;
    const glm::dvec3 edge = glm::dvec3(b.position) - glm::dvec3(a.position);
    const double square = glm::dot(edge, edge);
    if (gain * gain > square) improve(to, a.distance + std::sqrt(square));
}

// The plane of the triangle has a at 0 and b at 1 on its axis, `to` above the axis and the point
// from which is measured below it.
void SurfaceDistance::acrossTriangle(uint a, uint b, uint to) {
    const Node &first = nodes_[a], &second = nodes_[b], &third = nodes_[to];
    const glm::dvec3 axis(second.position - first.position), side(third.position - first.position);
    const double square = glm::dot(axis, axis), sideSquare = glm::dot(side, side);
    const double far = first.distance * first.distance;
    const double point2 = square + far - second.distance * second.distance;  // x 2 square
    const double corner2 = 2.0 * glm::dot(axis, side);                       // x 2 square
    // No root is needed to see that the corner would not be nearer than it is, which settles most
    // cases: its square would be far + sideSquare - corner2 point2 / 2 square + 2 below above.
    const double gain =
        corner2 * point2 - 2.0 * square * (far + sideSquare - third.distance * third.distance);
    if (!(gain > 0.0)) return;
    if ((4.0 * square * far - point2 * point2) * (4.0 * square * sideSquare - corner2 * corner2) >=
        kAlmost * gain * gain)
        return;
    if (!(square > 0.0)) return;
    const double point = 0.5 * point2 / square, corner = 0.5 * corner2 / square;
    if ((point < 0.0 && corner < 0.0) || (point > 1.0 && corner > 1.0)) return;
    const double below = std::sqrt(std::max(0.0, far - point * point * square));
    const double above = std::sqrt(std::max(0.0, sideSquare - corner * corner * square));
    const double height = below + above;
    if (!(height > 0.0)) return;
    const double crossing = (point * above + corner * below) / height;
    if (!(crossing >= 0.0 && crossing <= 1.0)) return;
    const double distance =
        std::sqrt((corner - point) * (corner - point) * square + height * height);
    if (distance * below <= reach_ * height) improve(to, distance);
}

void SurfaceDistance::tellNeighbours(uint node) {
    nodes_[node].waiting = false;
    ++nodes_[node].told;
    const bool along = nodes_[node].distance <= reach_;
    uint last = kNone, lastNode = kNone;  // neighbours in the fan share a corner
    for (const uvec2 others : query_->fan(nodes_[node].vertex)) {
        const bool shared = others.x == last;
        const uint u = shared ? lastNode : nodeOf(others.x), w = nodeOf(others.y);
        if (nodes_[u].distance < kInfinite) acrossTriangle(node, u, w);
        if (nodes_[w].distance < kInfinite) acrossTriangle(node, w, u);
        if (along && !shared) alongEdge(node, u);
        if (along) alongEdge(node, w);
        last = others.y;
        lastNode = w;
    }
}

void SurfaceDistance::measure(const SkinQuery& query, const SkinHit& from, float reach) {
    assert(reach > 0.0f);
    query_ = &query;
    reach_ = reach;
    from_ = from.position;
    queue_ = 0;
    queues_.resize(kQueues + 1);
    clear();
    if (slots_.empty()) grow();
    const uvec3 corners = query.skin().triangles[from.triangle];
    for (int c = 0; c < 3; ++c)
        improve(nodeOf(corners[c]),
                glm::distance(glm::dvec3(from.position),
                              glm::dvec3(query.skin().vertices[corners[c]].position)));
    for (queue_ = 0; queue_ < queues_.size(); ++queue_) {
        std::vector<uint>& queue = queues_[queue_];
        for (std::size_t i = 0; i < queue.size(); ++i)
            if (nodes_[queue[i]].waiting) tellNeighbours(queue[i]);
        queue.clear();
    }
}

double SurfaceDistance::to(uint v) const {
    if (nodes_.empty()) return kInfinite;
    const Slot slot = slots_[slotOf(v)];
    if (slot.vertex != v || nodes_[slot.node].distance > reach_) return kInfinite;
    return nodes_[slot.node].distance;
}

double SurfaceDistance::longestDetour() const {
    double longest = 0.0;
    for (const Node& node : nodes_) {
        if (!(node.distance <= reach_)) continue;
        const double straight = static_cast<double>(glm::distance(node.position, from_));
        longest = std::max(longest, node.distance - straight);
    }
    return longest;
}

}  // namespace pelage
