// brush.cpp -- the path of a stroke and its coverage.
#include "brush.h"

#include <algorithm>
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
constexpr float kSmoothReach = 1.0f / 3.0f;  // of the radius, over which smooth takes its mean
constexpr float kFacingRamp =
    0.2f;  // cosine to the cursor's normal from which a vertex counts in full

bool finite(vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// [0,1]. A vertex without a normal faces everywhere.
float facingWeight(vec3 vertexNormal, vec3 cursorNormal) {
    if (vertexNormal == vec3(0.0f) || cursorNormal == vec3(0.0f)) return 1.0f;
    return glm::smoothstep(0.0f, kFacingRamp, glm::dot(vertexNormal, cursorNormal));
}

vec3 unitOrZero(vec3 v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : vec3(0.0f);
}

// Writes a vertex unless it holds these values already: writing may copy a chunk.
void writeVertex(Groom& groom, uint v, const FurVertex& fur, float mask) {
    if (!(groom.fur[v] == fur)) groom.fur.edit(v) = fur;
    if (groom.mask[v] != mask) groom.mask.edit(v) = mask;
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
      touched_(query.skin().vertices.size(), Touch{}) {
    assert(brush.radius > 0.0f && brush.strength >= 0.0f && brush.strength <= 1.0f);
    assert(before_.fur.size() == query.skin().vertices.size());
    assert(before_.mask.size() == query.skin().vertices.size());
    if (brush.tool == Tool::smooth) averages_.emplace(query, before_, kSmoothReach * radius());
    if (brush.tool == Tool::segment) segments_.emplace(query.skin(), before_, brush_);
}

void Stroke::dab(Groom& groom, vec3 position, vec3 normal) {
    const Skin& skin = query_->skin();
    const float farthest = kFarthest * skin.size();
    if (!finite(position) || glm::distance(position, skin.center()) > farthest) return;
    const Sample to{position, finite(normal) ? normal : vec3(0.0f)};
    const Sample from = samples_.empty() ? to : samples_.back();
    if (samples_.empty()) lastStep_ = position;
    samples_.push_back(to);

    const float length = glm::distance(from.position, to.position);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / radius())));
    Sample begin = from;
    for (int k = 1; k <= pieces; ++k) {
        const float t = static_cast<float>(k) / static_cast<float>(pieces);
        const Sample end = k == pieces ? to
                                       : Sample{glm::mix(from.position, to.position, t),
                                                glm::mix(from.normal, to.normal, t)};
        Piece piece{begin, end, combSteps(begin.position, end.position)};
        cover(groom, piece);
        if (brush_.mirrorX) {
            mirror(piece.from);
            mirror(piece.to);
            for (Sample& step : piece.steps) mirror(step);
            piece.mirrored = true;
            cover(groom, piece);
        }
        begin = end;
    }
}

void Stroke::mirror(Sample& sample) {
    sample.position.x = -sample.position.x;
    sample.normal.x = -sample.normal.x;
}

float Stroke::radius() const { return workingRadius(query_->skin(), brush_); }

std::vector<Stroke::Sample> Stroke::combSteps(vec3 from, vec3 to) {
    std::vector<Sample> steps;
    if (brush_.tool != Tool::comb) return steps;
    const double spacing = kCombStep * radius();
    const double length = glm::distance(glm::dvec3(from), glm::dvec3(to));
    double next = spacing - sinceStep_;
    for (; next <= length; next += spacing) {
        const vec3 place = glm::mix(from, to, static_cast<float>(next / length));
        steps.push_back({place, (place - lastStep_) / static_cast<float>(spacing)});
        lastStep_ = place;
    }
    sinceStep_ = length - (next - spacing);
    return steps;
}

void Stroke::cover(Groom& groom, const Piece& piece) {
    const Skin& skin = query_->skin();
    const vec3 middle = 0.5f * (piece.from.position + piece.to.position);
    const float reach = radius() + 0.5f * glm::distance(piece.from.position, piece.to.position);
    found_.clear();
    query_->within(middle, reach, found_);
    for (const uint v : found_) {
        Touch touched = touched_[v];
        if (!touch(skin.vertices[v], piece, touched)) continue;
        touched_.edit(v) = touched;
        const Touching by = touching(v, touched);
        writeVertex(groom, v, brushedFur(skin, before_, brush_, v, by),
                    brushedMask(before_, brush_, v, by));
        if (segments_) segments_->paint(groom, v, by.coverage);
    }
}

Touching Stroke::touching(uint v, const Touch& touched) {
    Touching by;
    by.coverage = std::max(touched.coverage, touched.mirrored);
    by.turn = touched.coverage - touched.mirrored;
    by.path = touched.combed;
    if (touched.ties > 0.0f) by.offset = touched.offset / touched.ties;
    if (averages_) by.around = averages_->around(v);
    return by;
}

// Adds the piece of path to what the vertex has felt; false when it felt nothing new.
bool Stroke::touch(const SkinVertex& vertex, const Piece& piece, Touch& touched) const {
    const vec3 along = piece.to.position - piece.from.position;
    const float square = glm::dot(along, along);
    const vec3 away = vertex.position - piece.from.position;
    const float t = square > 0.0f ? glm::clamp(glm::dot(away, along) / square, 0.0f, 1.0f) : 0.0f;
    const vec3 normal = unitOrZero(glm::mix(piece.from.normal, piece.to.normal, t));
    const float facing = brush_.facingOnly ? facingWeight(vertex.normal, normal) : 1.0f;
    if (facing <= 0.0f) return false;

    const vec3 offset = away - t * along;
    const float distance = glm::length(offset);
    const float coverage = facing * falloffWeight(brush_.falloff, distance, radius());
    float& covered = piece.mirrored ? touched.mirrored : touched.coverage;
    bool changed = coverage > covered;
    covered = std::max(covered, coverage);
    if (toolInfo(brush_.tool).needsPath && coverage > 0.0f && distance <= touched.nearest) {
        const bool tie = distance == touched.nearest;  // as on the plane of a mirrored stroke
        touched.ties = tie ? touched.ties + 1.0f : 1.0f;
        touched.offset = tie ? touched.offset + offset : offset;
        touched.nearest = distance;
        changed = true;
    }
    for (const Sample& step : piece.steps) {
        const float weight =
            facing *
            falloffWeight(brush_.falloff, glm::distance(vertex.position, step.position), radius());
        if (weight <= 0.0f) continue;
        touched.combed += weight * step.normal;
        changed = true;
    }
    return changed;
}

std::string Stroke::line() const {
    std::string text = "stroke " + brushText(brush_) + " :";
    for (const Sample& sample : samples_) {
        text += ' ';
        for (const float number : {sample.position.x, sample.position.y, sample.position.z,
                                   sample.normal.x, sample.normal.y, sample.normal.z})
            text += ' ' + floatText(number);
    }
    return text;
}

void flood(const SkinQuery& query, Groom& groom, const Brush& brush, vec3 direction) {
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
    const Groom first = initialGroom(skin);
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
