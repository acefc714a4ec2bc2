// half_edges.cpp -- topology from an OpenMesh half-edge mesh.
#include "half_edges.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

#include "quiet_openmesh.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/Noncopyable.hh>
#pragma GCC diagnostic pop

namespace pelage {
namespace {

// Connectivity only: positions live in Skin.
struct Traits : OpenMesh::DefaultTraits {
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::None);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Mesh::VertexHandle handle(uint v) { return Mesh::VertexHandle(static_cast<int>(v)); }

bool repeatsCorner(uvec3 t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

struct Built {
    Mesh mesh;
    std::vector<uint> triangleOf;  // by face
    std::vector<uint> outside;     // triangles that did not fit
};

Built build(std::size_t vertexCount, std::span<const uvec3> triangles) {
    Built built;
    built.mesh.reserve(vertexCount, triangles.size() * 3 / 2, triangles.size());
    for (std::size_t v = 0; v < vertexCount; ++v) built.mesh.new_vertex();
    for (uint i = 0; i < triangles.size(); ++i) {
        const uvec3 t = triangles[i];
        assert(t.x < vertexCount && t.y < vertexCount && t.z < vertexCount);
        if (repeatsCorner(t) ||
            !built.mesh.add_face(handle(t.x), handle(t.y), handle(t.z)).is_valid())
            built.outside.push_back(i);
        else
            built.triangleOf.push_back(i);
    }
    return built;
}

using Edge = std::pair<uint, uint>;  // smaller vertex first

struct EdgeUse {
    std::size_t forward = 0, backward = 0;  // triangles that run from first to second, and back
};

// A triangle that names a vertex twice joins its vertices but bounds nothing: its edges are listed
// and not counted.
void use(std::map<Edge, EdgeUse>& edges, uint from, uint to, bool counts) {
    if (from == to) return;
    EdgeUse& edge = edges[std::minmax(from, to)];
    if (counts) ++(from < to ? edge.forward : edge.backward);
}

// How the triangles outside the half-edge mesh and those inside it share the edges of the former.
std::map<Edge, EdgeUse> usesOfOutsiders(const Built& built, std::span<const uvec3> triangles) {
    const Mesh& mesh = built.mesh;
    std::map<Edge, EdgeUse> edges;
    for (const uint i : built.outside) {
        const uvec3 t = triangles[i];
        const bool counts = !repeatsCorner(t);
        use(edges, t.x, t.y, counts);
        use(edges, t.y, t.z, counts);
        use(edges, t.z, t.x, counts);
    }
    for (auto& [edge, uses] : edges) {
        const auto h = mesh.find_halfedge(handle(edge.first), handle(edge.second));
        if (!h.is_valid()) continue;
        if (!mesh.is_boundary(h)) ++uses.forward;
        if (!mesh.is_boundary(mesh.opposite_halfedge_handle(h))) ++uses.backward;
    }
    return edges;
}

void countEdges(Topology& topology, const Mesh& mesh, const std::map<Edge, EdgeUse>& outsiders) {
    for (const auto e : mesh.edges())
        if (mesh.is_boundary(e)) ++topology.boundaryEdges;
    for (const auto& [edge, uses] : outsiders) {
        const auto h = mesh.find_halfedge(handle(edge.first), handle(edge.second));
        if (h.is_valid() && mesh.is_boundary(mesh.edge_handle(h))) --topology.boundaryEdges;
        const std::size_t all = uses.forward + uses.backward;
        if (all == 1) ++topology.boundaryEdges;
        if (all >= 3) ++topology.nonManifoldEdges;
        if (all == 2 && uses.forward != 1) ++topology.flippedEdges;
    }
}

// kNone where it is at a boundary.
uint sideOf(const Built& built, std::span<const uvec3> triangles, Mesh::HalfedgeHandle h) {
    if (built.mesh.is_boundary(h)) return MeshEdge::kNone;
    const auto face = static_cast<std::size_t>(built.mesh.face_handle(h).idx());
    const uint t = built.triangleOf[face];
    const auto from = static_cast<uint>(built.mesh.from_vertex_handle(h).idx());
    return 3 * t + (triangles[t].x == from ? 0u : triangles[t].y == from ? 1u : 2u);
}

}  // namespace

Topology makeTopology(std::size_t vertexCount, std::span<const uvec3> triangles) {
    const Quiet quiet;
    const Built built = build(vertexCount, triangles);
    const Mesh& mesh = built.mesh;
    Topology topology;
    topology.repeatedCorners =
        static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), repeatsCorner));
    const auto outsiders = usesOfOutsiders(built, triangles);
    countEdges(topology, mesh, outsiders);

    // Edges that only triangles outside the half-edge mesh have.
    std::vector<Edge> extra;
    for (const auto& [edge, uses] : outsiders)
        if (!mesh.find_halfedge(handle(edge.first), handle(edge.second)).is_valid()) {
            extra.push_back(edge);
            extra.emplace_back(edge.second, edge.first);
        }
    std::sort(extra.begin(), extra.end());

    topology.ringFirst.reserve(vertexCount + 1);
    topology.rings.reserve(triangles.size() * 3 + extra.size());
    auto next = extra.begin();
    for (uint v = 0; v < vertexCount; ++v) {
        topology.ringFirst.push_back(static_cast<uint>(topology.rings.size()));
        for (const auto neighbour : mesh.vv_range(handle(v)))
            topology.rings.push_back(static_cast<uint>(neighbour.idx()));
        for (; next != extra.end() && next->first == v; ++next)
            topology.rings.push_back(next->second);
    }
    topology.ringFirst.push_back(static_cast<uint>(topology.rings.size()));
    return topology;
}

std::vector<MeshEdge> edgesOf(std::size_t vertexCount, std::span<const uvec3> triangles) {
    const Quiet quiet;
    const Built built = build(vertexCount, triangles);
    std::vector<MeshEdge> edges;
    edges.reserve(built.mesh.n_edges());
    for (const auto e : built.mesh.edges()) {
        MeshEdge edge{sideOf(built, triangles, built.mesh.halfedge_handle(e, 0)),
                      sideOf(built, triangles, built.mesh.halfedge_handle(e, 1))};
        if (edge.side == MeshEdge::kNone) std::swap(edge.side, edge.other);
        if (edge.side != MeshEdge::kNone) edges.push_back(edge);
    }
    std::map<Edge, std::size_t> ofOutsiders;
    for (const uint i : built.outside) {
        if (repeatsCorner(triangles[i])) continue;
        for (uint k = 0; k < 3; ++k) {
            const uint from = triangles[i][static_cast<int>(k)];
            const uint to = triangles[i][static_cast<int>((k + 1) % 3)];
            if (built.mesh.find_halfedge(handle(from), handle(to)).is_valid()) continue;
            const auto [known, fresh] =
                ofOutsiders.try_emplace(std::minmax(from, to), edges.size());
            if (fresh)
                edges.push_back({3 * i + k, MeshEdge::kNone});
            else if (edges[known->second].other == MeshEdge::kNone)
                edges[known->second].other = 3 * i + k;
        }
    }
    return edges;
}

}  // namespace pelage
