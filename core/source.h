// source.h -- what a mesh file holds, as read: every vertex and triangle of every mesh, unwelded.
//
// The readers (gltf_in, mesh_in, animal) make it, Skin is built from it, and the writer
// (gltf_out) puts the fur back on the same vertices in the same order.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "progress.h"
#include "types.h"

namespace pelage {

struct Rig;          // what moves the vertices, see rig.h
struct CarriedGltf;  // the glTF as it was in the file; known to gltf_in and gltf_out only

// A run of vertices and triangles that share a material and a place: one glTF primitive.
struct SourcePart {
    std::string name;    // of the mesh, for reports and segments
    uint mesh = 0;       // parts of one mesh are welded to each other
    uint primitive = 0;  // within the mesh
    uint firstVertex = 0, vertexCount = 0;
    uint firstTriangle = 0, triangleCount = 0;
    int material = -1;   // into Source::materials, -1 = default
    mat4 toWorld{1.0f};  // from mesh space to the world in the rest pose
};

struct SourceMaterial {
    std::string name;
    vec4 baseColor{1.0f};  // linear RGBA factor
    int image = -1;        // base-color texture into Source::images, -1 = none
};

// An encoded picture (PNG or JPEG), as in the file.
struct SourceImage {
    std::string name;
    std::vector<std::byte> bytes;
};

// The number of no body segment.
inline constexpr uint kNoSegment = ~0u;

// A named part of the body with the axis along which fur usually lies.
struct Segment {
    std::string name;
    vec3 root{0.0f};  // world, rest pose; the end nearer the head of the animal
    vec3 tip{0.0f};
    bool operator==(const Segment&) const = default;
};

// Fur fields found in the file, one value per source vertex, in mesh space.
struct SourceFur {
    std::vector<float> length;
    std::vector<float> density;
    std::vector<vec3> direction;
    std::vector<vec3> tint;
};

struct Source {
    std::string path;  // empty for what was made by code
    // One entry per vertex, in file order; mesh space. The last four are empty when the file has
    // none of them at all, else as long as positions.
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec2> uvs;        // of the base-color texture; v = 0 at the top (glTF)
    std::vector<vec4> colors;     // COLOR_0, linear RGBA
    std::vector<uint> segmentOf;  // into segments, or kNoSegment: as the list below says
    // For skinned vertices the matrix from mesh space to the world at rest; empty when no part is
    // skinned, and then SourcePart::toWorld holds for all its vertices.
    std::vector<mat4> vertexToWorld;
    std::vector<uvec3> triangles;  // vertex numbers; strips, fans and polygons unrolled
    std::vector<SourcePart> parts;
    std::vector<SourceMaterial> materials;
    std::vector<SourceImage> images;
    // What an earlier groom left; else the joints of a skin, each with the vertices that it holds
    // most; else the materials or, where all is of one, the nodes or groups that have a name. Or
    // what the maker says.
    std::vector<Segment> segments;
    bool segmentsKept = false;          // by an earlier groom
    std::unique_ptr<SourceFur> fur;     // null when the file has no fur fields
    std::string furBlock;               // the JSON of extras.fur, empty when there is none
    std::size_t fileVertices = 0;       // vertices as the file counts them (OBJ: its v lines)
    std::vector<std::string> warnings;  // one line each, for the load report
    std::shared_ptr<const CarriedGltf> carried;  // null when the source is not glTF
    std::shared_ptr<const Rig> rig;              // null where nothing moves
};

// Number of the part that each vertex belongs to.
std::vector<uint> partOfVertex(const Source& source);

// Reads .glb, .gltf, .obj, .ply, .off or .stl; which one is decided by content where it can be, by
// the extension otherwise. Throws std::runtime_error with one line "file: what, where, numbers".
// Never opens a file outside the folder of `path`. Progress may be null.
Source readSource(const std::string& path, Progress* progress = nullptr);

}  // namespace pelage
