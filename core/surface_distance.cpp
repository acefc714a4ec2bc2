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
constexpr uint kPage = 32;                 // vertices in a row of the skin
constexpr double kLeastGain = 1e-9;        // of the reach; smaller gains are rounding
constexpr uint kMostTold = 8;              // once is usual; bounds the cost where triangles cross
constexpr double kAlmost = 1.0 - 1e-8;

}  // namespace

void SurfaceDistance::clear() {
    reach_ = 0.0;
    nodes_.clear();
    std::fill(pages_.begin(), pages_.end(), kNone);
}

void SurfaceDistance::addPage(std::size_t page) {
    const std::vector<SkinVertex>& vertices = query_->skin().vertices;
    pages_[page] = static_cast<uint>(nodes_.size());
    const std::size_t end = std::min(vertices.size(), (page + 1) * kPage);
    for (std::size_t v = page * kPage; v < end; ++v)
        nodes_.push_back({vertices[v].position, static_cast<uint>(v), kInfinite});
}

uint SurfaceDistance::nodeOf(uint v) {
    const std::size_t page = v / kPage;
    if (pages_[page] == kNone) addPage(page);
    return pages_[page] + v % kPage;
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

void SurfaceDistance::alongEdge(const Node& from, const Corner& to) {
    const double gain = nodes_[to.node].distance - from.distance;
    if (gain > 0.0 && gain * gain > to.square)
        improve(to.node, from.distance + std::sqrt(to.square));
}

// The plane of the triangle has `from` at 0 and `second` at 1 on its axis, `third` above the axis
// and the point from which is measured below it. All but the distance found is kept in multiples
// of the axis' square, which saves divisions. Inlined it is half as dear.
inline void SurfaceDistance::acrossTriangle(const Node& from, const Corner& second, const Corner& third,
                                     double corner) {
    const double square2 = 2.0 * second.square, far = from.distance * from.distance;
    const double known = nodes_[second.node].distance, sofar = nodes_[third.node].distance;
    const double point = second.square + far - known * known;
    const double straight = square2 * (far + third.square) - corner * point;
    // No root is needed to see that the corner would not be nearer than it is, which settles most
    // cases.
    const double gain = square2 * sofar * sofar - straight;
    if (!(gain > 0.0)) return;
    const double below2 = 2.0 * square2 * far - point * point;
    const double above2 = 2.0 * square2 * third.square - corner * corner;
    if (below2 * above2 >= kAlmost * gain * gain) return;
    const double below = std::sqrt(std::max(0.0, below2));
    const double above = std::sqrt(std::max(0.0, above2));
    const double height = below + above;
    const double crossing = point * above + corner * below;  // of height x square2
    if (!(height > 0.0 && crossing >= 0.0 && crossing <= square2 * height)) return;
    const double distance = std::sqrt((straight + below * above) / square2);
    if (distance * below <= reach_ * height) improve(third.node, distance);
}

void SurfaceDistance::tellNeighbours(uint node) {
    nodes_[node].waiting = false;
    ++nodes_[node].told;
    const Node from = nodes_[node];
    const bool along = from.distance <= reach_;
    const auto cornerOf = [&](uint v) {
        Corner corner{nodeOf(v), {}, 0.0};
        corner.edge = glm::dvec3(nodes_[corner.node].position - from.position);
        corner.square = glm::dot(corner.edge, corner.edge);
        return corner;
    };
    uint last = kNone;  // neighbours in the fan share a corner
    Corner first, second;
    for (const uvec2 others : query_->fan(from.vertex)) {
        const bool shared = others.x == last;
        first = shared ? second : cornerOf(others.x);
        second = cornerOf(others.y);
        last = others.y;
        const double angle = 2.0 * glm::dot(first.edge, second.edge);
        if (nodes_[first.node].distance < kInfinite) acrossTriangle(from, first, second, angle);
        if (nodes_[second.node].distance < kInfinite) acrossTriangle(from, second, first, angle);
        if (along && !shared) alongEdge(from, first);
        if (along) alongEdge(from, second);
    }
}

void SurfaceDistance::measure(const SkinQuery& query, const SkinHit& from, float reach) {
    assert(reach > 0.0f);
    query_ = &query;
    pages_.resize(query.skin().vertices.size() / kPage + 1);
    clear();
    reach_ = reach;
    from_ = from.position;
    queue_ = 0;
    queues_.resize(kQueues + 1);
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
    if (nodes_.empty() || pages_[v / kPage] == kNone) return kInfinite;
    const double distance = nodes_[pages_[v / kPage] + v % kPage].distance;
    return distance <= reach_ ? distance : kInfinite;
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
