// obj_in.cpp -- reads Wavefront OBJ and what is shown of its material file.
#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "beside.h"
#include "mesh_build.h"
#include "mesh_in.h"
#include "obj_pieces.h"
#include "srgb.h"
#include "text.h"
#include "text_scan.h"

namespace pelage {
namespace {

constexpr uint kNone = 0xffffffffu;
enum Kind { kVertex, kTexture, kNormal };
constexpr const char* kKindNames[] = {"vertex", "texture coordinate", "normal"};

// The largest number that a face named, to be checked when all of the file is read: faces may
// come before their vertices.
struct Farthest {
    std::int64_t number = 0;  // from 1
    std::size_t line = 0;
};

struct ObjRead {
    ObjRead(std::span<const std::byte> bytes, const std::string& path)
        : build(path, "OBJ"), scan(build.file, bytes) {}

    MeshBuild build;
    TextScan scan;
    std::vector<vec2> uvs;
    std::vector<uint> cornerUvs;  // three per triangle, kNone where a corner has none
    std::array<std::int64_t, 3> counts{};
    std::array<Farthest, 3> farthest{};
    std::string library, material;  // of the first mtllib and usemtl
    std::size_t materials = 0;
    ObjPieces pieces;
    std::vector<uint> polygon, polygonUvs;  // of the current face
};

// A number of a corner as an index from 0. Negative ones count back from the last read.
uint resolved(ObjRead& read, std::int64_t number, Kind kind) {
    const std::int64_t count = read.counts[kind];
    const std::int64_t index = number > 0 ? number - 1 : count + number;
    if (number == 0 || index < 0 || index >= std::int64_t{kNone}) {
        read.scan.refuse(std::string("face names ") + kKindNames[kind] + " " +
                         std::to_string(number) + " of " + std::to_string(count));
    }
    Farthest& farthest = read.farthest[kind];
    if (index + 1 > farthest.number) farthest = {index + 1, read.scan.line()};
    return static_cast<uint>(index);
}

// "7", "7/1", "7//3" or "7/1/3".
void readCorner(ObjRead& read, std::string_view word) {
    std::array<uint, 3> index{kNone, kNone, kNone};
    const char* at = word.data();
    const char* end = at + word.size();
    for (int kind = kVertex; kind <= kNormal; ++kind) {
        if (at != end && *at != '/') {
            std::int64_t number = 0;
            const auto result = std::from_chars(at, end, number);
            if (result.ec != std::errc()) break;
            at = result.ptr;
            index[static_cast<std::size_t>(kind)] = resolved(read, number, static_cast<Kind>(kind));
        }
        if (at == end || *at != '/') break;
        ++at;
    }
    if (at != end || index[kVertex] == kNone) {
        read.scan.refuse(inQuotes(word) + " is not a corner of a face");
    }
    read.polygon.push_back(index[kVertex]);
    read.polygonUvs.push_back(index[kTexture]);
}

void readFace(ObjRead& read) {
    read.polygon.clear();
    read.polygonUvs.clear();
    while (!read.scan.atLineEnd()) readCorner(read, read.scan.word());
    read.build.addPolygon(read.polygon);
    for (std::size_t i = 1; i + 1 < read.polygonUvs.size(); ++i) {
        read.cornerUvs.insert(read.cornerUvs.end(),
                              {read.polygonUvs[0], read.polygonUvs[i], read.polygonUvs[i + 1]});
    }
}

void readVertex(ObjRead& read) {
    vec3 position;
    for (int i = 0; i < 3; ++i) position[i] = read.scan.number("a coordinate");
    Source& source = read.build.source;
    // Beyond x y z: a weight, or a color, or a color and its alpha.
    std::array<float, 4> more{0.0f, 0.0f, 0.0f, 1.0f};
    std::size_t extra = 0;
    while (const auto value = read.scan.tryNumber()) {
        if (extra < 4) more[extra] = *value;
        ++extra;
    }
    if (extra == 3 || extra == 4) {
        source.colors.resize(source.positions.size(), vec4(1.0f));
        vec4 color(1.0f);
        for (int i = 0; i < 3; ++i) {
            color[i] = linearFromSrgb(std::clamp(more[static_cast<std::size_t>(i)], 0.0f, 1.0f));
        }
        color.a = std::clamp(more[3], 0.0f, 1.0f);
        source.colors.push_back(color);
    }
    source.positions.push_back(position);
    ++read.counts[kVertex];
}

void readLine(ObjRead& read) {
    const std::string_view key = read.scan.word();
    if (key == "v") {
        readVertex(read);
    } else if (key == "vt") {
        const float u = read.scan.number("a coordinate");
        const float v = read.scan.tryNumber().value_or(0.0f);
        read.uvs.emplace_back(u, 1.0f - v);
        ++read.counts[kTexture];
    } else if (key == "vn") {
        ++read.counts[kNormal];  // normals are made anew from the surface
    } else if (key == "f" || key == "fo") {
        readFace(read);
    } else if (key == "mtllib") {
        if (read.library.empty()) read.library = read.scan.rest();
    } else if (key == "usemtl") {
        const std::string_view name = read.scan.rest();
        if (read.material.empty()) read.material = name;
        if (name != read.material) ++read.materials;
        read.pieces.begin(ObjPieces::kMaterial, name, read.build.source.triangles.size());
    } else if (key == "o" || key == "g") {
        read.pieces.begin(key == "o" ? ObjPieces::kObject : ObjPieces::kGroup, read.scan.rest(),
                          read.build.source.triangles.size());
    }
    read.scan.nextLine();
}

void checkFarthest(const ObjRead& read) {
    for (const Kind kind : {kVertex, kTexture, kNormal}) {
        const Farthest& farthest = read.farthest[kind];
        if (farthest.number <= read.counts[kind]) continue;
        read.scan.refuseAt(farthest.line, std::string("face names ") + kKindNames[kind] + " " +
                                              std::to_string(farthest.number) + " of " +
                                              std::to_string(read.counts[kind]));
    }
}

// Gives each vertex the first texture coordinate that a corner names with it; each further one
// makes a copy of the vertex after all others, in the order of vertex and coordinate.
void splitByUv(ObjRead& read) {
    if (read.uvs.empty()) return;
    Source& source = read.build.source;
    const std::size_t count = source.positions.size();
    std::vector<uint> uvOf(count, kNone);
    std::vector<char> taken(count, 0);
    if (!source.colors.empty()) source.colors.resize(count, vec4(1.0f));
    struct Further {
        std::uint64_t key;  // vertex and texture coordinate
        std::size_t corner;
    };
    std::vector<Further> further;
    const auto cornerAt = [&](std::size_t c) -> uint& {
        return source.triangles[c / 3][static_cast<int>(c % 3)];
    };
    for (std::size_t c = 0; c < read.cornerUvs.size(); ++c) {
        const uint v = cornerAt(c), uv = read.cornerUvs[c];
        if (!taken[v]) {
            taken[v] = 1;
            uvOf[v] = uv;
        } else if (uvOf[v] != uv) {
            further.push_back({std::uint64_t{v} << 32 | uv, c});
        }
    }
    std::sort(further.begin(), further.end(),
              [](const Further& a, const Further& b) { return a.key < b.key; });
    for (std::size_t i = 0; i < further.size(); ++i) {
        uint& corner = cornerAt(further[i].corner);
        if (i == 0 || further[i].key != further[i - 1].key) {
            source.positions.push_back(vec3(source.positions[corner]));
            if (!source.colors.empty()) source.colors.push_back(vec4(source.colors[corner]));
            uvOf.push_back(read.cornerUvs[further[i].corner]);
        }
        corner = static_cast<uint>(source.positions.size() - 1);
    }
    source.uvs.reserve(uvOf.size());
    for (const uint uv : uvOf) source.uvs.push_back(uv == kNone ? vec2(0.0f) : read.uvs[uv]);
}

struct ObjMaterial {
    std::string name, picture;
    vec4 color{1.0f};
};

// The material of that name, else the first with a picture, else the first. Options before the
// name of a picture ("-s 1 1 1") are passed over by taking the last word.
ObjMaterial readLibrary(const std::string& owner, const std::string& library,
                        const std::string& wanted) {
    const auto bytes = readBeside(owner, library, std::size_t{1} << 26);
    TextScan scan(library, bytes);
    std::vector<ObjMaterial> all;
    for (; scan.nextContent(); scan.nextLine()) {
        const std::string_view key = scan.word();
        if (key == "newmtl") {
            all.push_back({std::string(scan.rest()), {}});
        } else if (!all.empty() && key == "Kd") {
            for (int i = 0; i < 3; ++i)
                all.back().color[i] = std::clamp(scan.number("a color"), 0.0f, 1.0f);
        } else if (!all.empty() && key == "map_Kd") {
            std::string text(scan.rest());
            if (text.starts_with('-'))
                text = text.substr(std::min(text.rfind(' ') + 1, text.size()));
            all.back().picture = text;
        }
    }
    for (const ObjMaterial& material : all) {
        if (material.name == wanted && !wanted.empty()) return material;
    }
    for (const ObjMaterial& material : all) {
        if (!material.picture.empty()) return material;
    }
    return all.empty() ? ObjMaterial{} : all.front();
}

// A picture of the name of the mesh, for meshes that come without a material file.
std::string pictureNamedAlike(const std::string& path) {
    const std::filesystem::path mesh(path);
    for (const char* ending : {".png", "_texture.png", ".jpg", "_texture.jpg"}) {
        const std::string name = mesh.stem().string() + ending;
        std::error_code error;
        if (std::filesystem::is_regular_file(mesh.parent_path() / name, error)) return name;
    }
    return {};
}

void addMaterial(ObjRead& read) {
    Source& source = read.build.source;
    if (source.path.empty()) return;
    ObjMaterial material;
    if (!read.library.empty()) {
        try {
            material = readLibrary(source.path, read.library, read.material);
        } catch (const std::runtime_error& error) {
            source.warnings.push_back(error.what());
        }
        source.materials.push_back({material.name, material.color, -1});
    }
    if (material.picture.empty() && !source.uvs.empty())
        material.picture = pictureNamedAlike(source.path);
    if (!material.picture.empty()) addPicture(source, material.picture);
    if (read.materials > 0) {
        source.warnings.push_back(
            "several materials are used; the first is shown on all of the skin");
    }
}

}  // namespace

Source readObj(std::span<const std::byte> bytes, const std::string& path, Progress* progress) {
    ObjRead read(bytes, path);
    Ticker ticker{progress};
    while (read.scan.nextContent()) {
        readLine(read);
        ticker.tick(bytes.size() - read.scan.bytesLeft(), bytes.size());
    }
    checkFarthest(read);
    read.build.source.fileVertices = read.build.source.positions.size();
    splitByUv(read);
    addMaterial(read);
    Source source = read.build.finish();
    read.pieces.nameSegments(source);
    return source;
}

}  // namespace pelage
