// skin.cpp -- from the vertices of a file to the surface of an animal.
#include "skin.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
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

Frame makeFrame(const mat3& toWorld) {
    Frame frame;
    frame.toWorld = toWorld;
    const float determinant = glm::determinant(frame.toWorld);
    // Below this the inverse is noise: a flattened node keeps its fields as they are.
    const float size = glm::length(frame.toWorld[0]) + glm::length(frame.toWorld[1]) +
                       glm::length(frame.toWorld[2]);
    if (std::abs(determinant) > 1e-9f * size * size * size && std::isfinite(determinant)) {
        frame.toMesh = glm::inverse(frame.toWorld);
        frame.scale = std::cbrt(std::abs(determinant));
    }
    if (size == 0.0f) frame.scale = 0.0f;
    return frame;
}

// Consecutive vertices of a part usually share a matrix; each new one becomes a frame.
template <typename MatrixOf>
void assignFrames(Skin& skin, const std::vector<uint>& part, MatrixOf matrixOf) {
    std::vector<uint> frameOfPart(skin.source->parts.size(), kNone);
    skin.frames.clear();
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const mat3 matrix(matrixOf(v));
        uint& known = frameOfPart[part[skin.sourceOf[v]]];
        if (known == kNone || skin.frames[known].toWorld != matrix) {
            known = static_cast<uint>(skin.frames.size());
            skin.frames.push_back({.toWorld = matrix});
        }
        skin.vertices[v].frame = known;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, skin.frames.size(), 4096),
                      [&](const auto& range) {
                          for (std::size_t f = range.begin(); f < range.end(); ++f)
                              skin.frames[f] = makeFrame(skin.frames[f].toWorld);
                      });
}

// Welds and sorts: fills weld, sourceOf and the positions of vertices.
void placeVertices(Skin& skin, const std::vector<uint>& part) {
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

    skin.sourceOf.resize(order.size());
    skin.vertices.assign(order.size(), SkinVertex{});
    skin.weld.assign(world.size(), kNone);
    for (uint v = 0; v < order.size(); ++v) {
        skin.sourceOf[v] = order[v].vertex;
        skin.weld[order[v].vertex] = v;
        skin.vertices[v].position = world[order[v].vertex];
    }
    for (uint v = 0; v < world.size(); ++v) skin.weld[v] = skin.weld[first[v]];
}

// What a triangle gives to the normals of its corners, and its area.
struct Face {
    glm::dvec3 atCorner[3]{};
    float area = 0.0f;  // m^2
};

// Normals are weighted by the angle of each face at the vertex (Thuermer and Wuethrich, "Computing
// Vertex Normals from Polygonal Facets", 1998), which do not depend on how a flat piece was cut
// into triangles.
Face faceOf(const Skin& skin, uvec3 corners) {
    Face face;
    glm::dvec3 p[3];
    for (int c = 0; c < 3; ++c) p[c] = skin.vertices[corners[c]].position;
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double doubled = glm::length(cross);
    face.area = static_cast<float>(0.5 * doubled);
    if (!(face.area > 0.0f)) return face;
    // A mirroring matrix turns faces inside out, and glTF turns them back.
    const Frame& frame = skin.frames[skin.vertices[corners.x].frame];
    const double side = glm::determinant(frame.toWorld) < 0.0f ? -1.0 : 1.0;
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 a = p[(c + 1) % 3] - p[c], b = p[(c + 2) % 3] - p[c];
        const double angle = std::atan2(doubled, glm::dot(a, b));
        face.atCorner[c] = cross * (side * angle / doubled);
    }
    return face;
}

// Calls visit(triangle, face) in the order of the triangles; what costs is done on all cores.
template <typename Visit>
void eachFace(const Skin& skin, Visit visit) {
    constexpr std::size_t kBlock = 1 << 16;  // triangles, so that memory is bounded
    std::vector<Face> faces(std::min(kBlock, skin.triangles.size()));
    for (std::size_t first = 0; first < skin.triangles.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, skin.triangles.size() - first);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 2048), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                faces[i] = faceOf(skin, skin.triangles[first + i]);
        });
        for (std::size_t i = 0; i < count; ++i) visit(first + i, faces[i]);
    }
}

// Normals, bounds of the vertices that triangles name, and, at rest, the areas.
void shapeVertices(Skin& skin, bool atRest) {
    std::vector<glm::dvec3> sum(skin.vertices.size(), glm::dvec3(0.0));
    std::vector<char> used(skin.vertices.size(), 0);
    if (atRest) skin.areas.reserve(skin.triangles.size());
    eachFace(skin, [&](std::size_t t, const Face& face) {
        const uvec3 corners = skin.triangles[t];
        for (int c = 0; c < 3; ++c) {
            used[corners[c]] = 1;
            if (face.area > 0.0f) sum[corners[c]] += face.atCorner[c];
        }
        if (!atRest) return;
        skin.areas.push_back(face.area);
        if (face.area > 0.0f)
            skin.area += face.area;
        else
            ++skin.report.degenerateFaces;
    });
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
    skin.radius = 0.0f;
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
    placeVertices(*skin, part);
    assignFrames(*skin, part, [&](uint v) { return vertexMatrix(kept, part, skin->sourceOf[v]); });
    step(0.4f);

    skin->triangles.reserve(kept.triangles.size());
    for (const uvec3 t : kept.triangles)
        skin->triangles.emplace_back(skin->weld[t.x], skin->weld[t.y], skin->weld[t.z]);
    shapeVertices(*skin, true);
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

void moveVertices(Skin& skin, const std::vector<uint>& part, std::span<const vec3> places,
                  std::span<const mat4> toWorld) {
    assert(places.size() == skin.vertices.size() && toWorld.size() == skin.vertices.size());
    for (std::size_t v = 0; v < places.size(); ++v) skin.vertices[v].position = places[v];
    assignFrames(skin, part, [&](uint v) { return toWorld[v]; });
    shapeVertices(skin, false);
    skin.outward = false;  // bent skin may show its inside
}

FurVertex furToWorld(const Skin& skin, uint v, FurVertex fur) {
    const Frame& frame = skin.frames[skin.vertices[v].frame];
    fur.direction = frame.toWorld * fur.direction;
    if (frame.scale > 0.0f) fur.direction /= frame.scale;
    fur.furLength *= frame.scale;
    return fur;
}

FurVertex furToMesh(const Skin& skin, uint v, FurVertex fur) {
    const Frame& frame = skin.frames[skin.vertices[v].frame];
    if (!(frame.scale > 0.0f)) return fur;
    fur.direction = frame.toMesh * fur.direction * frame.scale;
    fur.furLength /= frame.scale;
    return fur;
}

}  // namespace pelage
