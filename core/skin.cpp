// skin.cpp -- from the vertices of a file to the surface of an animal.
#include "skin.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>

#include "half_edges.h"
#include "morton.h"
#include "outward.h"
#include "spacing.h"
#include "strand.h"

namespace pelage {
namespace {

constexpr uint kNone = ~0u;

// Part of each source vertex.
std::vector<uint> partOfVertex(const Source& source) {
    std::vector<uint> part(source.positions.size(), 0);
    for (uint p = 0; p < source.parts.size(); ++p) {
        const SourcePart& run = source.parts[p];
        std::fill_n(part.begin() + run.firstVertex, run.vertexCount, p);
    }
    return part;
}

uvec3 positionBits(vec3 p) {
    p += 0.0f;  // -0 and 0 are the same place
    return {std::bit_cast<uint>(p.x), std::bit_cast<uint>(p.y), std::bit_cast<uint>(p.z)};
}

// For each source vertex the first source vertex of the same mesh at exactly the same place.
std::vector<uint> firstAtSamePlace(const Source& source, const std::vector<uint>& part) {
    const std::size_t count = source.positions.size();
    std::vector<uint> table(std::bit_ceil(count * 2 + 2), kNone);
    const std::size_t wrap = table.size() - 1;
    std::vector<uint> first(count);
    for (uint v = 0; v < count; ++v) {
        const uint mesh = source.parts[part[v]].mesh;
        const uvec3 bits = positionBits(source.positions[v]);
        std::size_t slot = pcg(bits.x ^ pcg(bits.y ^ pcg(bits.z ^ pcg(mesh)))) & wrap;
        while (table[slot] != kNone && (positionBits(source.positions[table[slot]]) != bits ||
                                        source.parts[part[table[slot]]].mesh != mesh))
            slot = (slot + 1) & wrap;
        if (table[slot] == kNone) table[slot] = v;
        first[v] = table[slot];
    }
    return first;
}

mat4 vertexMatrix(const Source& source, const std::vector<uint>& part, uint v) {
    return source.vertexToWorld.empty() ? source.parts[part[v]].toWorld : source.vertexToWorld[v];
}

Frame makeFrame(const mat4& toWorld) {
    Frame frame;
    frame.toWorld = mat3(toWorld);
    const float determinant = glm::determinant(frame.toWorld);
    // Below this the inverse is noise: a flattened node keeps its fields as they are.
    const float size = glm::length(frame.toWorld[0]) + glm::length(frame.toWorld[1]) +
                       glm::length(frame.toWorld[2]);
    if (std::abs(determinant) > 1e-9f * size * size * size && std::isfinite(determinant)) {
        frame.toMesh = glm::inverse(frame.toWorld);
        frame.scale = std::cbrt(std::abs(determinant));
    }
    return frame;
}

// Consecutive vertices usually share a matrix; each new one becomes a frame.
void assignFrames(Skin& skin, const std::vector<uint>& part, const std::vector<uint>& sourceOf) {
    const Source& source = *skin.source;
    std::vector<uint> frameOfPart(source.parts.size(), kNone);
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const mat4 matrix = vertexMatrix(source, part, sourceOf[v]);
        uint& known = frameOfPart[part[sourceOf[v]]];
        if (known == kNone || skin.frames[known].toWorld != mat3(matrix)) {
            known = static_cast<uint>(skin.frames.size());
            skin.frames.push_back(makeFrame(matrix));
        }
        skin.vertices[v].frame = known;
    }
}

// Welds and sorts: fills weld and the positions of vertices; returns the source vertex of each.
std::vector<uint> placeVertices(Skin& skin, const std::vector<uint>& part) {
    const Source& source = *skin.source;
    const std::vector<uint> first = firstAtSamePlace(source, part);

    std::vector<vec3> world(source.positions.size());
    vec3 lower(INFINITY), upper(-INFINITY);
    for (uint v = 0; v < world.size(); ++v) {
        world[v] = vec3(vertexMatrix(source, part, v) * vec4(source.positions[v], 1.0f));
        lower = glm::min(lower, world[v]);
        upper = glm::max(upper, world[v]);
    }
    const vec3 extent = upper - lower;
    const float cells = kLastCell / std::max({extent.x, extent.y, extent.z, 1e-30f});

    struct Placed {
        std::uint64_t code;
        uint vertex;
    };
    std::vector<Placed> order;
    for (uint v = 0; v < world.size(); ++v)
        if (first[v] == v) order.push_back({mortonCode(world[v], lower, cells), v});
    tbb::parallel_sort(order.begin(), order.end(), [](const Placed& a, const Placed& b) {
        return a.code != b.code ? a.code < b.code : a.vertex < b.vertex;
    });

    std::vector<uint> sourceOf(order.size());
    skin.vertices.assign(order.size(), SkinVertex{});
    skin.weld.assign(world.size(), kNone);
    for (uint v = 0; v < order.size(); ++v) {
        sourceOf[v] = order[v].vertex;
        skin.weld[order[v].vertex] = v;
        skin.vertices[v].position = world[order[v].vertex];
        if (!source.segmentOf.empty()) skin.vertices[v].segment = source.segmentOf[order[v].vertex];
    }
    for (uint v = 0; v < world.size(); ++v) skin.weld[v] = skin.weld[first[v]];
    return sourceOf;
}

// Areas, bounds, and normals weighted by the angle of each face at the vertex (Thuermer and
// Wuethrich, "Computing Vertex Normals from Polygonal Facets", 1998), which do not depend on how
// a flat piece was cut into triangles.
void measureTriangles(Skin& skin) {
    const Source& source = *skin.source;
    std::vector<glm::dvec3> sum(skin.vertices.size(), glm::dvec3(0.0));
    std::vector<char> used(skin.vertices.size(), 0);
    skin.areas.resize(skin.triangles.size());
    for (const SourcePart& part : source.parts) {
        // A mirroring matrix turns faces inside out, and glTF turns them back.
        const double side = glm::determinant(mat3(part.toWorld)) < 0.0f ? -1.0 : 1.0;
        for (uint t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
            const uvec3 corners = skin.triangles[t];
            glm::dvec3 p[3];
            for (int c = 0; c < 3; ++c) {
                p[c] = skin.vertices[corners[c]].position;
                used[corners[c]] = 1;
            }
            const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
            const double doubled = glm::length(cross);
            skin.areas[t] = static_cast<float>(0.5 * doubled);
            if (!(skin.areas[t] > 0.0f)) {
                ++skin.report.degenerateFaces;
                continue;
            }
            skin.area += skin.areas[t];
            for (int c = 0; c < 3; ++c) {
                const glm::dvec3 a = p[(c + 1) % 3] - p[c], b = p[(c + 2) % 3] - p[c];
                const double angle = std::atan2(doubled, glm::dot(a, b));
                sum[corners[c]] += cross * (side * angle / doubled);
            }
        }
    }
    bool any = false;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const double size = glm::length(sum[v]);
        skin.vertices[v].normal = size > 1e-6 ? vec3(sum[v] / size) : vec3(0.0f);
        if (!used[v]) continue;
        const vec3 p = skin.vertices[v].position;
        skin.lower = any ? glm::min(skin.lower, p) : p;
        skin.upper = any ? glm::max(skin.upper, p) : p;
        any = true;
    }
    for (uint v = 0; v < skin.vertices.size(); ++v)
        if (used[v])
            skin.radius =
                std::max(skin.radius, glm::distance(skin.vertices[v].position, skin.center()));
    skin.report.unusedVertices =
        static_cast<std::size_t>(std::count(used.begin(), used.end(), char(0)));
}

// Vertices are in Morton order already: counting those before is all it takes.
std::vector<uint> orderByVertex(const Skin& skin) {
    std::vector<uint> first(skin.vertices.size() + 1, 0);
    for (const uvec3 t : skin.triangles) ++first[t.x + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<uint> order(skin.triangles.size());
    for (uint t = 0; t < order.size(); ++t) order[first[skin.triangles[t].x]++] = t;
    return order;
}

}  // namespace

float Skin::size() const {
    const float diagonal = glm::length(upper - lower);
    return diagonal > 0.0f ? diagonal : 1.0f;
}

std::shared_ptr<const Skin> makeSkin(Source source, Progress* progress) {
    const auto step = [&](float done) {
        if (progress) progress->report(done);
    };
    auto skin = std::make_shared<Skin>();
    skin->report.vertices = source.fileVertices;
    skin->report.triangles = source.triangles.size();
    skin->report.warnings = source.warnings;
    skin->source = std::make_shared<const Source>(std::move(source));
    const Source& kept = *skin->source;

    const std::vector<uint> part = partOfVertex(kept);
    const std::vector<uint> sourceOf = placeVertices(*skin, part);
    assignFrames(*skin, part, sourceOf);
    step(0.4f);

    skin->triangles.reserve(kept.triangles.size());
    for (const uvec3 t : kept.triangles)
        skin->triangles.emplace_back(skin->weld[t.x], skin->weld[t.y], skin->weld[t.z]);
    measureTriangles(*skin);
    skin->spatialOrder = orderByVertex(*skin);
    step(0.6f);

    Topology topology = makeTopology(skin->vertices.size(), skin->triangles);
    skin->ringFirst = std::move(topology.ringFirst);
    skin->rings = std::move(topology.rings);
    skin->spacing = medianSpacing(*skin);
    skin->report.weldedVertices = skin->vertices.size();
    skin->report.nonManifoldEdges = topology.nonManifoldEdges;
    skin->report.flippedEdges = topology.flippedEdges;
    skin->report.boundaryEdges = topology.boundaryEdges;
    const bool closed =
        topology.nonManifoldEdges + topology.flippedEdges + topology.boundaryEdges == 0;
    skin->outward = closed && facesOutward(skin->vertices, skin->triangles);
    step(1.0f);
    return skin;
}

FurVertex furToWorld(const Skin& skin, uint v, FurVertex fur) {
    const Frame& frame = skin.frames[skin.vertices[v].frame];
    fur.direction = frame.toWorld * fur.direction / frame.scale;
    fur.furLength *= frame.scale;
    return fur;
}

FurVertex furToMesh(const Skin& skin, uint v, FurVertex fur) {
    const Frame& frame = skin.frames[skin.vertices[v].frame];
    fur.direction = frame.toMesh * fur.direction * frame.scale;
    fur.furLength /= frame.scale;
    return fur;
}

}  // namespace pelage
