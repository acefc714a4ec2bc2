// skin.h -- the animal's surface: welded, in spatial order, with its one-rings. Immutable.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "source.h"
#include "types.h"

namespace pelage {

// The matrix of vectors from a mesh's own space, in which fur is stored, to the world.
struct Frame {
    mat3 toWorld{1.0f};
    mat3 toMesh{1.0f};   // inverse, or identity where toWorld is singular
    float scale = 1.0f;  // cube root of |determinant|: world length of a mesh-space length of 1;
                         // 0 where toWorld is, as of a joint that is scaled away
};

// What was found on the way from a file to a skin.
struct LoadReport {
    std::size_t vertices = 0;  // as the file counts them
    std::size_t triangles = 0;
    std::size_t weldedVertices = 0;
    std::size_t unusedVertices = 0;    // named by no triangle
    std::size_t nonManifoldEdges = 0;  // used by three triangles or more
    std::size_t flippedEdges = 0;      // used by two triangles in the same direction
    std::size_t boundaryEdges = 0;     // used by one triangle
    std::size_t degenerateFaces = 0;   // of no area, or with a corner twice
    std::vector<std::string> warnings;
};

struct Skin {
    // World space, at rest unless pose.h made it. Welded by exact position within a mesh at rest,
    // in Morton order, so that neighbours in space are neighbours in memory.
    std::vector<SkinVertex> vertices;
    std::vector<uvec3> triangles;    // skin vertices; in the order of the source file, none dropped
    std::vector<float> areas;        // m^2, one per triangle; at rest, also in a pose
    std::vector<uint> spatialOrder;  // the triangles by their first vertex: neighbours are near
    double area = 0.0;               // m^2, of all triangles; at rest
    vec3 lower{0.0f}, upper{0.0f};   // bounds of the vertices that triangles use, m
    float radius = 0.0f;             // m, of the ball around center() that holds those vertices
    float spacing = 0.0f;            // m, median length of the edges; at rest
    bool outward = false;            // closed, and no back face is ever seen from outside
    std::vector<uint> weld;          // source vertex -> skin vertex
    std::vector<uint> sourceOf;      // skin vertex -> the first source vertex that was welded to it
    std::vector<Frame> frames;       // SkinVertex::frame points here
    LoadReport report;
    std::shared_ptr<const Source> source;  // never null

    std::vector<uint> ringFirst, rings;  // read by ring()

    // Skin vertices that share an edge with vertex v.
    std::span<const uint> ring(uint v) const {
        return {rings.data() + ringFirst[v], rings.data() + ringFirst[v + 1]};
    }
    // Diagonal of the bounds, m; 1 for an empty or point-like skin.
    float size() const;
    // Middle of the bounds.
    vec3 center() const { return 0.5f * (lower + upper); }
};

// Welds, sorts, and counts what is wrong with the mesh. Topology comes from an OpenMesh half-edge
// mesh in which non-manifold edges are opened; the skin itself keeps every triangle.
std::shared_ptr<const Skin> makeSkin(Source source, Progress* progress = nullptr);

// Moves the vertices: places in the world, and the matrices of their vectors from mesh space; `part`
// is partOfVertex of the source. Frames, normals and bounds follow; what roots of hair depend on
// (topology and areas) stays.
void moveVertices(Skin& skin, const std::vector<uint>& part, std::span<const vec3> places,
                  std::span<const mat4> toWorld);

// The painted values of vertex v, which are kept in the file's mesh space, in the world, and back.
FurVertex furToWorld(const Skin& skin, uint v, FurVertex inMesh);
FurVertex furToMesh(const Skin& skin, uint v, FurVertex inWorld);

}  // namespace pelage
