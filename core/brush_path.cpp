// brush_path.cpp -- images of points, and distances to a piece from those to its ends.
#include "brush_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pelage {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr float kBent = 0.05f;        // of the radius
constexpr float kReachSteps = 12.0f;  // to the radius: alike pieces of path reach equally far

// The space whose planes are mirrors: that of the mesh where all the skin is in one, else the
// world.
mat4 ownSpace(const Skin& skin) {
    const Source& source = *skin.source;
    if (source.parts.empty() || !source.vertexToWorld.empty()) return mat4(1.0f);
    const mat4 toWorld = source.parts[0].toWorld;
    for (const SourcePart& part : source.parts)
        if (part.toWorld != toWorld) return mat4(1.0f);
    const mat4 toOwn = glm::inverse(toWorld);
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) sum += glm::dot(toOwn[i], vec4(1.0f));
    return std::isfinite(sum) ? toWorld : mat4(1.0f);
}

// m from a point to its foot.
double gapOf(const PathPoint& point) {
    return point.foot ? static_cast<double>(glm::distance(point.position, point.foot->position))
                      : kInfinite;
}

}  // namespace

vec3 unitOrZero(vec3 v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : vec3(0.0f);
}

std::vector<Mirroring> mirrorings(const Skin& skin, glm::bvec3 mirror) {
    std::vector<Mirroring> images{{}};
    const mat4 toWorld = ownSpace(skin), toOwn = glm::inverse(toWorld);
    for (int axis = 0; axis < 3; ++axis) {
        if (!mirror[axis]) continue;
        mat4 flip(1.0f);
        flip[axis][axis] = -1.0f;
        const mat4 across = toWorld * flip * toOwn;
        for (std::size_t i = 0, count = images.size(); i < count; ++i)
            images.push_back({across * images[i].matrix, !images[i].turned});
    }
    return images;
}

PathPoint onSkin(const SkinQuery& query, PathPoint point, bool facing) {
    point.foot = query.nearest(point.position, facing ? point.normal : vec3(0.0f));
    if (!point.foot) point.foot = query.nearest(point.position);
    return point;
}

PathPoint imageOf(const SkinQuery& query, const PathPoint& point, const mat4& mirroring,
                  bool facing) {
    PathPoint image = point;
    if (!point.foot) return image;
    image.normal = unitOrZero(mat3(mirroring) * point.normal);
    image.position = vec3(mirroring * vec4(point.foot->position, 1.0f));
    image = onSkin(query, image, facing);
    if (!image.foot) return image;
    const vec3 normal = image.foot->normal;
    if (image.normal != vec3(0.0f))
        image.normal = glm::dot(normal, image.normal) < 0.0f ? -normal : normal;
    image.position =
        image.foot->position + mat3(mirroring) * (point.position - point.foot->position);
    return image;
}

double Beside::distance(double along) const { return std::sqrt((x - along) * (x - along) + y * y); }

void PathImage::advance(const SkinQuery& query, const PathPoint& to, bool alongSurface,
                        float radius) {
    alongSurface_ = alongSurface;
    const vec3 end = alongSurface && to.foot ? to.foot->position : to.position;
    // Farther away the nearest skin is elsewhere all of a sudden, and the image goes on there.
    const bool goesOn = begun_ && glm::distance(end_, end) <= 2.0f * radius;
    begun_ = true;
    from_ = goesOn ? to_ : to;
    to_ = to;
    start_ = goesOn ? end_ : end;
    end_ = end;
    length_ = glm::distance(start_, end_);
    heading_ = length_ > 0.0 ? (end_ - start_) / static_cast<float>(length_) : vec3(0.0f);
    startGap_ = gapOf(from_);
    endGap_ = gapOf(to_);
    if (!goesOn) forget();
    if (!alongSurface) return;
    if (!(endGap_ < static_cast<double>(radius))) return forget();
    if (open_ && radius + glm::distance(*open_, end_) <= fromEnd_.reach()) return;
    // What is within the radius of the piece is no farther than `needed` from its ends. On open
    // skin more is measured, to serve the next pieces as well.
    const float steps = std::ceil(kReachSteps * static_cast<float>(length_) / radius);
    const float most = radius * (1.0f + kLongestPiece);
    const float needed = std::min(radius * (1.0f + steps / kReachSteps), most);
    std::swap(fromStart_, fromEnd_);
    fromEnd_.measure(query, *to_.foot, open_ ? most : needed);
    const bool startIsOpen = open_.has_value();
    open_.reset();
    if (fromEnd_.longestDetour() <= static_cast<double>(kBent * radius))
        open_ = end_;
    else if (length_ > 0.0 && (startIsOpen || fromStart_.reach() < needed))
        fromStart_.measure(query, *from_.foot, needed);
}

void PathImage::forget() {
    open_.reset();
    fromStart_.clear();
    fromEnd_.clear();
}

// m from the skin to the point of the piece at x.
double PathImage::gapAt(double x) const {
    if (startGap_ == endGap_ || !(length_ > 0.0)) return endGap_;
    return startGap_ + std::clamp(x / length_, 0.0, 1.0) * (endGap_ - startGap_);
}

// From the distances a and b to the ends of a piece of length l: x = (l^2 + a^2 - b^2) / 2l. Where
// the skin is curved or open they may not fit l; the vertex is then no nearer than an end. Where
// only one is known, because the other end is too far away, the vertex is beyond the near end, and
// how far to the side can be seen from where it is in space.
Beside PathImage::beside(const SkinVertex& vertex, uint v) const {
    if (!alongSurface_ || open_) {
        const vec3 away = vertex.position - start_;
        const float x = glm::dot(away, heading_);
        const float side = glm::length(away - x * heading_);
        if (!alongSurface_) return {x, side};
        if (!(fromEnd_.to(v) < kInfinite)) return {x, kInfinite};
        return {x, std::hypot(static_cast<double>(side), gapAt(x))};
    }
    const double a = fromStart_.to(v), b = fromEnd_.to(v);
    if (!(std::min(a, b) < kInfinite)) return {0.0, kInfinite};
    const auto sideways = [](double far, double x) {
        return std::sqrt(std::max(0.0, (far - x) * (far + x)));
    };
    Beside place;
    if (!(length_ > 0.0)) {
        place.y = std::min(a, b);
    } else if (!(b < kInfinite)) {
        const double past = glm::dot(vertex.position - start_, heading_);
        place.x = std::clamp(past, -a, 0.0);
        place.y = sideways(a, place.x);
    } else if (!(a < kInfinite)) {
        const double past = std::clamp<double>(glm::dot(vertex.position - end_, heading_), 0.0, b);
        place.x = length_ + past;
        place.y = sideways(b, past);
    } else {
        place.x = std::clamp(0.5 * (length_ + (a - b) * (a + b) / length_), -a, length_ + b);
        place.y = sideways(a, place.x);
    }
    const double gap = gapAt(place.x);
    place.y = std::sqrt(place.y * place.y + gap * gap);
    return place;
}

}  // namespace pelage
