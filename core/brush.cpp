// brush.cpp -- the path of a stroke and its coverage.
#include "brush.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "script_text.h"
#include "text.h"
#include "tools.h"

namespace pelage {
namespace {

constexpr double kCombStep = 1.0 / 8.0;  // of the radius, between two looks at the path's direction
constexpr float kFarthest = 2.0f;        // sizes from the middle of the skin
constexpr float kTie = 1e-5f;  // of the radius; images of the path that differ less are as near
constexpr float kSmoothReach = 1.0f / 3.0f;  // of the radius, over which smooth takes its mean
constexpr float kFacingRamp =
    0.2f;  // cosine to the cursor's normal from which a vertex counts in full

bool finite(vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// [0,1]. A vertex without a normal faces everywhere.
float facingWeight(vec3 vertexNormal, vec3 cursorNormal) {
    if (vertexNormal == vec3(0.0f) || cursorNormal == vec3(0.0f)) return 1.0f;
    return glm::smoothstep(0.0f, kFacingRamp, glm::dot(vertexNormal, cursorNormal));
}

}  // namespace

float falloffWeight(Falloff falloff, float distance, float radius) {
    if (!(distance < radius)) return 0.0f;
    const float x = distance / radius;
    switch (falloff) {
        case Falloff::smooth:
            return (1.0f - x * x) * (1.0f - x * x);
        case Falloff::linear:
            return 1.0f - x;
        case Falloff::sharp:
            return (1.0f - x) * (1.0f - x);
        case Falloff::constant:
            return 1.0f;
    }
    return 0.0f;
}

Stroke::Stroke(const SkinQuery& query, Groom before, Brush brush)
    : query_(&query),
      before_(std::move(before)),
      brush_(brush),
      radius_(workingRadius(query.skin(), brush)),
      touched_(query.skin().vertices.size(), Touch{}),
      mirrorings_(mirrorings(query.skin(), brush.mirror)),
      images_(mirrorings_.size()) {
    assert(brush.radius > 0.0f && brush.strength >= 0.0f && brush.strength <= 1.0f);
    assert(before_.fur.size() == query.skin().vertices.size());
    assert(before_.mask.size() == query.skin().vertices.size());
    if (brush.tool == Tool::smooth) averages_.emplace(query, before_, kSmoothReach * radius_);
    if (brush.tool == Tool::segment) segments_.emplace(query.skin(), before_, brush_);
}

void Stroke::dab(Groom& groom, vec3 position, vec3 normal, float pressure) {
    const Skin& skin = query_->skin();
    const float farthest = kFarthest * skin.size();
    if (!finite(position) || glm::distance(position, skin.center()) > farthest) return;
    if (!std::isfinite(pressure)) return;
    const PathPoint to{position, finite(normal) ? normal : vec3(0.0f),
                       std::clamp(pressure, 0.0f, 1.0f)};
    const PathPoint from = samples_.empty() ? to : samples_.back();
    if (samples_.empty()) lastStep_ = position;
    samples_.push_back(to);

    const float length = glm::distance(from.position, to.position);
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(length / (kLongestPiece * radius_))));
    PathPoint begin = from;
    for (int k = 1; k <= pieces; ++k) {
        const float t = static_cast<float>(k) / static_cast<float>(pieces);
        const PathPoint end = k == pieces ? to
                                          : PathPoint{glm::mix(from.position, to.position, t),
                                                      glm::mix(from.normal, to.normal, t),
                                                      glm::mix(from.pressure, to.pressure, t)};
        advance(groom, begin, end);
        begin = end;
    }
}

// All images go on to the next point.
void Stroke::advance(Groom& groom, const PathPoint& from, const PathPoint& to) {
    const std::vector<CombStep> steps = combSteps(from.position, to.position);
    const bool needsFoot = brush_.alongSurface || images_.size() > 1;
    const PathPoint own = needsFoot ? onSkin(*query_, to, brush_.facingOnly) : to;
    for (std::size_t i = 0; i < images_.size(); ++i) {
        const PathPoint image =
            i == 0 ? own : imageOf(*query_, own, mirrorings_[i].matrix, brush_.facingOnly);
        images_[i].advance(*query_, image, brush_.alongSurface, radius_);
        cover(groom, i, steps);
    }
}

std::vector<Stroke::CombStep> Stroke::combSteps(vec3 from, vec3 to) {
    std::vector<CombStep> steps;
    if (brush_.tool != Tool::comb) return steps;
    const double spacing = kCombStep * radius_;
    const double length = glm::distance(glm::dvec3(from), glm::dvec3(to));
    double next = spacing - sinceStep_;
    for (; next <= length; next += spacing) {
        const float along = static_cast<float>(next / length);
        const vec3 place = glm::mix(from, to, along);
        steps.push_back({along, (place - lastStep_) / static_cast<float>(spacing)});
        lastStep_ = place;
    }
    sinceStep_ = length - (next - spacing);
    return steps;
}

void Stroke::cover(Groom& groom, std::size_t image, const std::vector<CombStep>& steps) {
    const Skin& skin = query_->skin();
    const PathImage& path = images_[image];
    const vec3 from = path.start(), to = path.end();
    found_.clear();
    query_->within(0.5f * (from + to), radius_ + 0.5f * glm::distance(from, to), found_);
    for (const uint v : found_) {
        Touch touched = touched_[v];
        if (!touch(v, image, steps, touched)) continue;
        touched_.edit(v) = touched;
        const Touching by = touching(v, touched);
        writeVertex(groom, v, brushedFur(skin, before_, brush_, v, by),
                    brushedMask(before_, brush_, v, by));
        if (segments_) segments_->paint(groom, v, by.coverage);
    }
}

Touching Stroke::touching(uint v, const Touch& touched) {
    Touching by;
    by.coverage = std::max(touched.coverage, touched.turned);
    by.turn = touched.coverage - touched.turned;
    by.path = touched.combed;
    if (touched.ties != 0)
        by.offset = touched.offset / static_cast<float>(std::popcount(touched.ties));
    if (averages_) by.around = averages_->around(v);
    return by;
}

// The largest falloff x pressure along the last piece of the image.
float Stroke::coverage(const PathImage& image, const Beside& place) const {
    const float first = image.from().pressure, last = image.to().pressure;
    const double length = image.length(), reach = static_cast<double>(radius_);
    const auto pressure = [&](double along) {
        return length > 0.0 ? glm::mix(first, last, static_cast<float>(along / length)) : last;
    };
    const auto at = [&](double along) {
        return pressure(along) *
               falloffWeight(brush_.falloff, static_cast<float>(place.distance(along)), radius_);
    };
    if (first == last || !(place.y < reach)) return at(std::clamp(place.x, 0.0, length));
    // The stretch within the radius. There both factors are log-concave, so that their product has
    // one maximum, which golden sections find.
    const double half = std::sqrt((reach - place.y) * (reach + place.y));
    if (place.x + half <= 0.0 || place.x - half >= length) return 0.0f;
    double least = std::clamp(place.x - half, 0.0, length);
    double most = std::clamp(place.x + half, 0.0, length);
    if (brush_.falloff == Falloff::constant) return std::max(pressure(least), pressure(most));
    constexpr double kGolden = 0.6180339887498949;
    double lower = most - kGolden * (most - least), upper = least + kGolden * (most - least);
    float atLower = at(lower), atUpper = at(upper);
    for (int i = 0; i < 10; ++i) {
        if (atLower < atUpper) {
            least = lower;
            lower = upper;
            atLower = atUpper;
            upper = least + kGolden * (most - least);
            atUpper = at(upper);
        } else {
            most = upper;
            upper = lower;
            atUpper = atLower;
            lower = most - kGolden * (most - least);
            atLower = at(lower);
        }
    }
    return std::max({atLower, atUpper, at(least), at(most)});
}

// Adds the last piece of the image to what the vertex has felt; false when it felt nothing new.
bool Stroke::touch(uint v, std::size_t image, const std::vector<CombStep>& steps,
                   Touch& touched) const {
    const SkinVertex& vertex = query_->skin().vertices[v];
    const PathImage& path = images_[image];
    const Beside place = path.beside(vertex, v);
    if (!(place.y < static_cast<double>(radius_))) return false;
    const double along = std::clamp(place.x, 0.0, path.length());
    const float t = path.length() > 0.0 ? static_cast<float>(along / path.length()) : 1.0f;
    const vec3 normal = glm::mix(path.from().normal, path.to().normal, t);
    const float facing = brush_.facingOnly ? facingWeight(vertex.normal, unitOrZero(normal)) : 1.0f;
    if (facing <= 0.0f) return false;

    const float covers = facing * coverage(path, place);
    float& covered = mirrorings_[image].turned ? touched.turned : touched.coverage;
    bool changed = covers > covered;
    covered = std::max(covered, covers);
    if (toolInfo(brush_.tool).needsPath && covers > 0.0f) {
        const float distance = static_cast<float>(place.distance(along));
        const uint own = 1u << image;
        const float tie = kTie * radius_;
        const bool nearer =
            distance < touched.nearest - tie || (touched.ties == own && distance < touched.nearest);
        const bool tied = !nearer && distance <= touched.nearest + tie && !(touched.ties & own);
        const vec3 offset = vertex.position - glm::mix(path.from().position, path.to().position, t);
        if (nearer) touched.nearest = distance;
        if (nearer || tied) {
            touched.ties = nearer ? own : touched.ties | own;
            touched.offset = nearer ? offset : touched.offset + offset;
            changed = true;
        }
    }
    for (const CombStep& step : steps) {
        const double there = static_cast<double>(step.along) * path.length();
        const float distance = static_cast<float>(place.distance(there));
        const float weight = facing *
                             glm::mix(path.from().pressure, path.to().pressure, step.along) *
                             falloffWeight(brush_.falloff, distance, radius_);
        if (weight <= 0.0f) continue;
        touched.combed += weight * (mat3(mirrorings_[image].matrix) * step.direction);
        changed = true;
    }
    return changed;
}

std::string Stroke::line() const {
    const bool pressed = std::any_of(samples_.begin(), samples_.end(), [](const PathPoint& sample) {
        return sample.pressure != 1.0f;
    });
    std::string text = "stroke " + brushText(brush_) + (pressed ? " pressure :" : " :");
    for (const PathPoint& sample : samples_) {
        text += "  " + pointText(sample.position) + ' ' + pointText(sample.normal);
        if (pressed) text += ' ' + floatText(sample.pressure);
    }
    return text;
}

void flood(const SkinQuery& query, Groom& groom, const Brush& brush, vec3 direction) {
    if (toolInfo(brush.tool).needsPath) return;
    const Skin& skin = query.skin();
    const Groom before = groom;  // smooth looks at neighbours
    std::optional<Averages> averages;
    if (brush.tool == Tool::smooth) averages.emplace(query, before, kFloodReach * skin.size());
    std::optional<SegmentPaint> segments;
    if (brush.tool == Tool::segment) segments.emplace(skin, before, brush);
    Touching touching;
    touching.coverage = touching.turn = 1.0f;
    touching.path = direction;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        if (averages) touching.around = averages->around(v);
        writeVertex(groom, v, brushedFur(skin, before, brush, v, touching),
                    brushedMask(before, brush, v, touching));
        if (segments) segments->paint(groom, v, touching.coverage);
    }
}

void reset(const Skin& skin, Groom& groom, Tool tool) {
    const bool length = tool == Tool::length || tool == Tool::cut || tool == Tool::smooth;
    const bool density = tool == Tool::density || tool == Tool::smooth;
    const bool tint = tool == Tool::tint || tool == Tool::smooth;
    const bool direction = tool != Tool::mask && tool != Tool::segment &&
                           (tool == Tool::smooth || !(length || density || tint));
    const Groom first = length || density || direction ? initialGroom(skin) : Groom{};
    std::optional<SegmentPaint> segments;
    if (tool == Tool::segment) segments.emplace(skin, groom);
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        FurVertex fur = groom.fur[v];
        const float held = groom.mask[v];
        if (length) fur.furLength = first.fur[v].furLength;
        if (density) fur.density = first.fur[v].density;
        if (direction) fur.direction = first.fur[v].direction;
        if (tint) fur.tint = vec3(1.0f);
        writeVertex(groom, v, heldBack(fur, groom.fur[v], held), tool == Tool::mask ? 0.0f : held);
        if (segments) segments->paint(groom, v, 1.0f);
    }
}

}  // namespace pelage
