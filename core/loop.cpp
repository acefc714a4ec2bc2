// loop.cpp -- the only place that knows OpenMesh's subdivider.
#include "loop.h"

#include <algorithm>
#include <cassert>

#include "quiet_openmesh.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#pragma GCC diagnostic pop

namespace pelage {
namespace {

// The subdivider computes in Point and Normal.
struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Loop = OpenMesh::Subdivider::Uniform::LoopT<Mesh>;

Mesh::VertexHandle handle(std::size_t v) { return Mesh::VertexHandle(static_cast<int>(v)); }

// The mesh without positions, and which vertices keep their place.
struct Held {
    Mesh mesh;
    std::vector<char> stays;
};

Held halfEdgeMesh(std::size_t vertexCount, std::span<const uvec3> triangles) {
    const Quiet quiet;
    Held held;
    held.stays.assign(vertexCount, 0);
    held.mesh.reserve(vertexCount, triangles.size() * 3 / 2, triangles.size());
    for (std::size_t v = 0; v < vertexCount; ++v) held.mesh.new_vertex();
    for (const uvec3 t : triangles) {
        // One without an inside bounds nothing and follows its neighbours.
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        if (held.mesh.add_face(handle(t.x), handle(t.y), handle(t.z)).is_valid()) continue;
        for (int k = 0; k < 3; ++k) held.stays[t[k]] = 1;
    }
    // The subdivider would put vertices without an edge at the origin.
    for (std::size_t v = 0; v < vertexCount; ++v)
        if (held.mesh.is_isolated(handle(v))) held.stays[v] = 1;
    return held;
}

// The subdivider has weights up to 49 neighbours unless it is told.
std::size_t mostNeighbours(const Mesh& mesh) {
    std::vector<std::size_t> count(mesh.n_vertices(), 0);
    for (const auto e : mesh.edges()) {
        const auto h = mesh.halfedge_handle(e, 0);
        ++count[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
        ++count[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())];
    }
    return count.empty() ? 0 : *std::max_element(count.begin(), count.end());
}

// For each of `edges` its number in the mesh, -1 where that does not have it.
std::vector<int> numbersIn(const Mesh& mesh, std::span<const EdgeEnds> edges) {
    EdgeNumbers ours(edges.size());
    for (const auto [a, b] : edges) ours.number(a, b);
    std::vector<int> numbers(edges.size(), -1);
    for (const auto e : mesh.edges()) {
        const auto h = mesh.halfedge_handle(e, 0);
        const auto a = static_cast<uint>(mesh.from_vertex_handle(h).idx());
        const auto b = static_cast<uint>(mesh.to_vertex_handle(h).idx());
        numbers.at(ours.number(a, b)) = e.idx();
    }
    return numbers;
}

glm::dvec3 pointOf(const Mesh& mesh, std::size_t v) {
    const OpenMesh::Vec3d& p = mesh.point(handle(v));
    return {p[0], p[1], p[2]};
}

}  // namespace

std::vector<std::vector<glm::dvec3>> loopStep(std::vector<std::vector<glm::dvec3>> quantities,
                                              std::span<const uvec3> triangles,
                                              std::span<const EdgeEnds> edges) {
    if (quantities.empty()) return quantities;
    const std::size_t count = quantities.front().size();
    const Held held = halfEdgeMesh(count, triangles);
    const std::vector<int> numbers = numbersIn(held.mesh, edges);
    const std::size_t neighbours = mostNeighbours(held.mesh);
    for (std::vector<glm::dvec3>& points : quantities) {
        assert(points.size() == count);
        Mesh mesh = held.mesh;
        for (std::size_t v = 0; v < count; ++v)
            mesh.set_point(handle(v), {points[v].x, points[v].y, points[v].z});
        Loop loop;
        loop.init_weights(neighbours + 1);
        loop(mesh, 1);
        // The subdivider appends the vertex of edge e at count + e.
        assert(mesh.n_vertices() == count + held.mesh.n_edges());
        for (std::size_t v = 0; v < count; ++v)
            if (!held.stays[v]) points[v] = pointOf(mesh, v);
        points.reserve(count + edges.size());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const auto [a, b] = edges[i];
            const bool smooth = numbers[i] >= 0 && !(held.stays[a] && held.stays[b]);
            points.push_back(smooth ? pointOf(mesh, count + static_cast<std::size_t>(numbers[i]))
                                    : 0.5 * (points[a] + points[b]));
        }
    }
    return quantities;
}

}  // namespace pelage
