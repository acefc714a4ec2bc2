// segment_parts.cpp -- principal directions, and which end of a piece is nearer to the head.
#include "segment_parts.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace pelage {
namespace {

using glm::dmat3, glm::dvec3;

constexpr std::size_t kMostPieces = 64;  // more are no parts of a body

dvec3 middleOf(std::span<const vec3> points) {
    dvec3 sum(0.0);
    for (const vec3 p : points) sum += dvec3(p);
    return points.empty() ? sum : sum / static_cast<double>(points.size());
}

// The direction in which the points spread most, unit; zero where they are all in one place.
dvec3 principalDirection(std::span<const vec3> points, dvec3 middle) {
    dmat3 spread(0.0);
    for (const vec3 p : points) {
        const dvec3 away = dvec3(p) - middle;
        spread += glm::outerProduct(away, away);
    }
    // Each squaring squares the ratio of the largest eigenvalue to the others.
    for (int i = 0; i < 32; ++i) {
        const double largest = std::max({spread[0][0], spread[1][1], spread[2][2]});
        if (!(largest > 0.0)) return dvec3(0.0);
        spread /= largest;
        spread = spread * spread;
    }
    const auto longer = [](dvec3 a, dvec3 b) { return glm::dot(a, a) < glm::dot(b, b); };
    return glm::normalize(std::max({spread[0], spread[1], spread[2]}, longer));
}

// World places of the vertices of each piece.
std::vector<std::vector<vec3>> placesOf(const Source& source, const Pieces& pieces) {
    std::vector<std::vector<vec3>> places(pieces.names.size());
    for (const SourcePart& part : source.parts)
        for (uint v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
            if (pieces.of[v] != kNoSegment)
                places[pieces.of[v]].emplace_back(part.toWorld * vec4(source.positions[v], 1.0f));
    return places;
}

struct Bearing {
    vec3 middle{0.0f};  // of all pieces
    vec3 head{0.0f};
};

Bearing bearingOf(const Pieces& pieces, const std::vector<std::vector<vec3>>& places) {
    std::vector<vec3> all;
    for (const std::vector<vec3>& of : places) all.insert(all.end(), of.begin(), of.end());
    Bearing bearing{vec3(middleOf(all)), all.front()};
    float left = all.front().x, right = left;
    for (const vec3 p : all) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        bearing.head = glm::max(bearing.head, p);
    }
    bearing.head.x = 0.5f * (left + right);
    for (std::size_t p = 0; p < places.size(); ++p)
        if (saysHead(pieces.names[p]) && !places[p].empty()) {
            bearing.head = vec3(middleOf(places[p]));
            break;
        }
    return bearing;
}

}  // namespace

bool saysHead(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name.find("head") != std::string::npos;
}

Segment segmentAlong(std::string name, std::span<const vec3> points, vec3 head) {
    const dvec3 middle = middleOf(points), axis = principalDirection(points, middle);
    double least = 0.0, greatest = 0.0;
    for (const vec3 p : points) {
        const double along = glm::dot(dvec3(p) - middle, axis);
        least = std::min(least, along);
        greatest = std::max(greatest, along);
    }
    Segment segment{std::move(name), vec3(middle + least * axis), vec3(middle + greatest * axis)};
    if (glm::distance(segment.tip, head) < glm::distance(segment.root, head))
        std::swap(segment.root, segment.tip);
    return segment;
}

bool segmentsFromPieces(Source& source, const Pieces& pieces, const char* kind) {
    const std::vector<std::vector<vec3>> places = placesOf(source, pieces);
    std::size_t used = 0, named = 0;
    for (std::size_t p = 0; p < places.size(); ++p) {
        used += !places[p].empty();
        named += !places[p].empty() && !pieces.names[p].empty();
    }
    if (named < 2 || used > kMostPieces) return false;

    const Bearing bearing = bearingOf(pieces, places);
    std::vector<uint> numbers(places.size(), kNoSegment);
    for (std::size_t p = 0; p < places.size(); ++p) {
        if (places[p].empty()) continue;
        numbers[p] = static_cast<uint>(source.segments.size());
        const std::string& name = pieces.names[p];
        const vec3 own(middleOf(places[p]));
        source.segments.push_back(
            segmentAlong(name.empty() ? kind + (' ' + std::to_string(p)) : name, places[p],
                         saysHead(name) ? 2.0f * own - bearing.middle : bearing.head));
    }
    source.segmentOf.assign(source.positions.size(), kNoSegment);
    for (std::size_t v = 0; v < pieces.of.size(); ++v)
        if (pieces.of[v] != kNoSegment) source.segmentOf[v] = numbers[pieces.of[v]];
    return true;
}

void segmentsFromParts(Source& source, const std::vector<std::string>& names) {
    Pieces byMaterial, byMesh{names, {}};
    for (const SourceMaterial& material : source.materials)
        byMaterial.names.push_back(material.name);
    for (const SourcePart& part : source.parts) {
        const uint material = part.material < 0 ? kNoSegment : static_cast<uint>(part.material);
        byMaterial.of.resize(part.firstVertex + part.vertexCount, material);
        byMesh.of.resize(part.firstVertex + part.vertexCount, part.mesh);
    }
    if (!segmentsFromPieces(source, byMaterial, "material"))
        segmentsFromPieces(source, byMesh, "node");
}

}  // namespace pelage
