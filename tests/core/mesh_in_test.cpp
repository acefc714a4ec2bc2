// mesh_in_test.cpp -- OBJ, PLY, OFF and STL: what they hold, and how bad ones are refused.
#include "core/mesh_in.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "core/srgb.h"
#include "reading.h"

namespace pelage {
namespace {

using test::bytesOf;
using test::refusal;
using test::sharedMesh;
using test::TempFolder;

Source obj(const std::string& text) { return readObj(bytesOf(text), ""); }
Source ply(const std::string& text) { return readPly(bytesOf(text), ""); }
Source off(const std::string& text) { return readOff(bytesOf(text), ""); }
Source stl(const std::string& text) { return readStl(bytesOf(text), ""); }

template <typename Read>
std::string refusalOf(Read read, const std::string& text) {
    return refusal([&] { read(text); });
}

using Triangles = std::vector<uvec3>;

TEST(Obj, VerticesKeepTheirOrderAlsoUnusedOnes) {
    const Source source = obj("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n");
    EXPECT_EQ(source.positions, (std::vector<vec3>{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(source.triangles, (Triangles{{1, 2, 3}}));
    EXPECT_EQ(source.fileVertices, 4u);
    EXPECT_TRUE(source.uvs.empty());
    ASSERT_EQ(source.parts.size(), 1u);
    EXPECT_EQ(source.parts[0].vertexCount, 4u);
    EXPECT_EQ(source.parts[0].triangleCount, 1u);
}

TEST(Obj, EveryFormOfCornerIsRead) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f -3 -2 -1",
          "f -3/-3/-1 -2/-2/-1 -1/-1/-1", "f 1 2 \\\n 3", "\tf  1\t2 3  # comment", "f 1/ 2/ 3/"}) {
        EXPECT_EQ(obj(vertices + face).triangles, (Triangles{{0, 1, 2}})) << face;
    }
    EXPECT_EQ(obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0").triangles.size(),
              1u);  // faces may come first
}

TEST(Obj, LineEndsOfEverySystemAreRead) {
    EXPECT_EQ(obj("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n").triangles.size(), 1u);
    EXPECT_EQ(obj("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3").triangles.size(), 1u);
    EXPECT_EQ(refusalOf(obj, "v 0 0 0\r\n\r\nv 1 x 0\r\n"), "OBJ: line 3: \"x\" is not a number");
}

TEST(Obj, PolygonsBecomeFansAndRepeatedCornersStay) {
    const Source source = obj(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.1 0.1 0\nf 1 2 3 4\nf 1 1 2\nf 1 2\nf 2 3 4 5\n");
    EXPECT_EQ(source.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 0, 1}, {1, 2, 3}, {1, 3, 4}}));
    ASSERT_EQ(source.warnings.size(), 1u);
    EXPECT_EQ(source.warnings[0], "1 faces have fewer than three corners and hold no surface");
    const Source concave = obj("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 2 3 4 1\nf 1 2 3 4\n");
    EXPECT_EQ(concave.warnings,
              (std::vector<std::string>{"1 faces are concave; their fans of triangles overlap"}));
}

TEST(Obj, AFurtherTextureCoordinateMakesAFurtherVertex) {
    const Source source =
        obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n"
            "f 1/1 2/2 3/3\nf 1/4 3/3 2/2\nf 1/4 2/2 3/1\n");
    EXPECT_EQ(source.fileVertices, 3u);
    EXPECT_EQ(source.positions,
              (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(source.triangles, (Triangles{{0, 1, 2}, {3, 2, 1}, {3, 1, 4}}));
    EXPECT_EQ(source.uvs,
              (std::vector<vec2>{{0, 0.75f}, {1, 1}, {0, 0}, {0.5f, 0.5f}, {0, 0.75f}}));
}

TEST(Obj, VertexColorsAreTakenForSrgb) {
    const Source source = obj("v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1 0.5\nf 1 2 3\n");
    ASSERT_EQ(source.colors.size(), 3u);
    EXPECT_EQ(source.colors[0], vec4(1, 0, linearFromSrgb(0.5f), 1));
    EXPECT_EQ(source.colors[2], vec4(0, 0, 1, 0.5f));
    EXPECT_NEAR(linearFromSrgb(0.5f), 0.21404f, 1e-5f);
    EXPECT_TRUE(obj("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").colors.empty());  // a weight
}

TEST(Obj, ThePictureOfTheMaterialOrOfTheSameNameIsShown) {
    const TempFolder folder;
    const auto picture = bytesOf("\x89PNG coat");
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
    folder.write("coat one.png", picture);
    folder.write("m.mtl",
                 "newmtl other\nmap_Kd x.png\nnewmtl fur\nKd 0.5 1 0.25\nmap_Kd coat one.png\n");
    const Source named = readSource(folder.write("a.obj", "mtllib m.mtl\nusemtl fur\n" + mesh));
    ASSERT_EQ(named.images.size(), 1u);
    EXPECT_EQ(named.images[0].bytes, picture);
    EXPECT_EQ(named.materials[0].name, "fur");
    EXPECT_EQ(named.materials[0].baseColor, vec4(0.5f, 1, 0.25f, 1));
    EXPECT_EQ(named.materials[0].image, 0);
    EXPECT_EQ(named.parts[0].material, 0);
    EXPECT_EQ(named.parts[0].name, "a");

    folder.write("b_texture.png", picture);
    EXPECT_EQ(readSource(folder.write("b.obj", mesh)).images.at(0).bytes, picture);
    const Source missing = readSource(folder.write("c.obj", "mtllib ../m.mtl\n" + mesh));
    EXPECT_TRUE(missing.images.empty());
    ASSERT_EQ(missing.warnings.size(), 1u);
    EXPECT_NE(missing.warnings[0].find("leads out of the folder"), std::string::npos);
}

TEST(Obj, BadLinesAreNamed) {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const struct {
        std::string text;
        const char* message;
    } rows[] = {
        {v + "f 1 2 9000", "line 4: face names vertex 9000 of 3"},
        {v + "\n# x\nf 1 2 0", "line 6: face names vertex 0 of 3"},
        {v + "f 1 2 -4", "line 4: face names vertex -4 of 3"},
        {v + "f 1 2 99999999999", "line 4: face names vertex 99999999999 of 3"},
        {v + "f 1 2 99999999999999999999",
         "line 4: \"99999999999999999999\" is not a corner of a face"},
        {v + "f 1/1 2/1 3/1", "line 4: face names texture coordinate 1 of 0"},
        {v + "f 1//2 2 3", "line 4: face names normal 2 of 0"},
        {v + "f 1 2 3x", "line 4: \"3x\" is not a corner of a face"},
        {v + "f 1/a 2 3", "line 4: \"1/a\" is not a corner of a face"},
        {"v 0 0", "line 1: ends where a coordinate is expected"},
        {"v 0 0 1e", "line 1: \"1e\" is not a number"},
        {"v 0 0 nan", "line 1: \"nan\" is not a finite number"},
        {"v 0 0 1e39", "line 1: \"1e39\" is not a finite number"},
        {"v 0 0 1e999", "line 1: \"1e999\" is not a number"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(refusalOf(obj, row.text), std::string("OBJ: ") + row.message);
    EXPECT_EQ(refusalOf(obj, v), "OBJ: holds no triangle");
    EXPECT_EQ(refusalOf(obj, ""), "OBJ: holds no triangle");
    EXPECT_EQ(obj("v 1e-60 0 0\n" + v + "f 2 3 4").positions[0], vec3(0.0f));  // too small is 0
}

const char* const kPlyHeader =
    "element vertex 4\nproperty float x\nproperty double y\nproperty short z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty list uchar float "
    "extra\n"
    "property float s\nproperty float t\nelement face 2\nproperty uchar flags\n"
    "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\nend_header\n";

// The numbers of the body, in the bytes of an order.
struct Body {
    std::string text;
    bool big;
    template <typename T>
    void add(T value) {
        std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
        if (big) bytes = std::string(bytes.rbegin(), bytes.rend());
        text += bytes;
    }
};

std::string binaryPly(bool big) {
    Body body{"ply\nformat " + std::string(big ? "binary_big_endian" : "binary_little_endian") +
                  " 1.0\n" + kPlyHeader,
              big};
    for (int v = 0; v < 4; ++v) {
        body.add(static_cast<float>(v == 1 || v == 2));
        body.add(static_cast<double>(v >= 2));
        body.add(static_cast<std::int16_t>(-v));
        for (int c = 0; c < 3; ++c) body.add(static_cast<std::uint8_t>(c == 0 ? 255 : 0));
        body.add(static_cast<std::uint8_t>(2));
        body.add(1.0f);
        body.add(2.0f);
        body.add(0.25f);
        body.add(0.75f);
    }
    for (const std::vector<int>& face : {std::vector<int>{0, 1, 2, 3}, std::vector<int>{3, 2, 1}}) {
        body.add(static_cast<std::uint8_t>(7));
        body.add(static_cast<std::uint8_t>(face.size()));
        for (const int v : face) body.add(static_cast<std::int32_t>(v));
    }
    body.add(std::int32_t{3});
    return body.text;
}

const std::string kAsciiPly =
    std::string("ply\nformat ascii 1.0\ncomment by hand\n") + kPlyHeader +
    "0 0 0 255 0 0 2 1 2 .25 .75\n1 0 -1 255 0 0 2 1 2 .25 .75\n1 1 -2 255 0 0 2 1 2 .25 .75\n"
    "0 1 -3 255 0 0 0 .25 .75\n7 4 0 1 2 3\n7 3 3 2 1\n3\n";

TEST(Ply, TextAndBothByteOrdersHoldTheSame) {
    for (const std::string& file : {kAsciiPly, binaryPly(false), binaryPly(true)}) {
        const Source source = ply(file);
        EXPECT_EQ(source.positions,
                  (std::vector<vec3>{{0, 0, 0}, {1, 0, -1}, {1, 1, -2}, {0, 1, -3}}));
        EXPECT_EQ(source.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {3, 2, 1}}));
        EXPECT_EQ(source.colors, std::vector<vec4>(4, vec4(1, 0, 0, 1)));
        EXPECT_EQ(source.uvs, std::vector<vec2>(4, vec2(0.25f, 0.25f)));
        EXPECT_EQ(source.fileVertices, 4u);
    }
}

TEST(Ply, TruncationAtEveryByteIsRefusedAndNeverCrashes) {
    for (const std::string& file : {kAsciiPly, binaryPly(false)}) {
        for (std::size_t size = 0; size + 2 < file.size(); ++size) {
            EXPECT_TRUE(refusalOf(ply, file.substr(0, size)).starts_with("PLY: ")) << size;
        }
    }
}

TEST(Ply, BadFilesAreNamed) {
    const std::string start =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\n";
    const std::string face =
        "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0 1 0 0 0 1 0\n";
    EXPECT_EQ(refusalOf(ply, start + face + "3 0 1 3\n"),
              "PLY: line 11: face 0 names vertex 3 of 3");
    EXPECT_EQ(refusalOf(ply, start + face + "3 0 1 -1\n"),
              "PLY: line 11: face 0 names vertex -1 of 3");
    EXPECT_EQ(refusalOf(ply, start + face + "250 0 1 2\n"),
              "PLY: line 11: list \"vertex_index\" is longer than the file");
    EXPECT_EQ(refusalOf(ply, start + "end_header\n0 0 0 1 0 0 0 1 0"), "PLY: holds no triangle");
    EXPECT_EQ(refusalOf(ply, "ply\nformat ascii 1.0\nelement vertex 4000000000\n"),
              "PLY: line 3: count 4000000000 is out of range");
    EXPECT_EQ(refusalOf(ply,
                        "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty "
                        "float x\nend_header\n"),
              "PLY: says 2000000000 of element \"vertex\", but only 0 bytes follow the header");
    EXPECT_EQ(refusalOf(ply, "ply\nformat morse 1.0\n"),
              "PLY: line 2: \"morse\" is not a format of PLY");
    EXPECT_EQ(refusalOf(ply, "ply\nelement vertex 1\nproperty word x\n"),
              "PLY: line 3: \"word\" is not a type of PLY");
    EXPECT_EQ(refusalOf(ply, start), "PLY: line 7: the header has no end: the file is truncated");
    std::string nan = binaryPly(false);
    const float value = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(nan.data() + nan.find("end_header\n") + 11, &value, sizeof value);
    EXPECT_NE(refusalOf(ply, nan).find("vertex 0 has a value of \"x\" that is not finite"),
              std::string::npos);
}

TEST(Off, PlainAndWithColorsNormalsAndTextureCoordinates) {
    const Source plain =
        off("OFF # a comment\n\n4 2 0\n0 0 0\n1 0 0 # here\n1 1 0\n0 1 0\n4 0 1 2 3\n3 2 1 0 255 0 "
            "0\n");
    EXPECT_EQ(plain.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}));
    EXPECT_EQ(plain.fileVertices, 4u);
    const Source all =
        off("STCNOFF 3 1 0\n0 0 0 0 0 1 255 0 0 255 .5 .25\n1 0 0 0 0 1 0 255 0 0 0 0\n0 1 0 0 0 1 "
            "0 0 255 255 0 0\n3 0 1 2\n");
    EXPECT_EQ(all.normals[0], vec3(0, 0, 1));
    EXPECT_EQ(all.colors, (std::vector<vec4>{{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 1}}));
    EXPECT_EQ(all.uvs[0], vec2(0.5f, 0.75f));
    EXPECT_EQ(off("COFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2\n").colors[1],
              vec4(0, 1, 0, 1));
}

TEST(Off, BadFilesAreNamed) {
    EXPECT_EQ(refusalOf(off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
              "OFF: line 6: face names vertex 3 of 3");
    EXPECT_EQ(refusalOf(off, "OFF\n3 1 0\n0 0 0\n1 0 0\n"),
              "OFF: line 5: ends after 2 of 3 vertices");
    EXPECT_EQ(refusalOf(off, "OFF\n3 1 0\n0 0 0\n1 0\n"),
              "OFF: line 4: ends where a number is expected");
    EXPECT_EQ(refusalOf(off, "OFF\n900000000 1 0\n"),
              "OFF: line 2: says 900000000 vertices, but only 5 bytes follow");
    EXPECT_EQ(refusalOf(off, "OFF\n-1 1 0\n"),
              "OFF: line 2: says -1 vertices, but only 5 bytes follow");
    EXPECT_EQ(refusalOf(off, "OFF BINARY\n"), "OFF: line 1: \"BINARY\" is not a whole number");
    EXPECT_EQ(refusalOf(off, "4OFF\n"),
              "OFF: line 1: \"4OFF\" is no form of OFF that is read (OFF with ST, C, N before it)");
    EXPECT_EQ(refusalOf(off, "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "OFF: holds no triangle");
}

std::string binaryStl(std::uint32_t says, int holds) {
    Body body{"solid but binary", false};
    body.text.resize(80, ' ');
    body.add(says);
    for (int t = 0; t < holds; ++t) {
        for (const float value :
             {0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f})
            body.add(value);
        body.add(std::uint16_t{0});
    }
    return body.text;
}

TEST(Stl, BinaryIsKnownByItsLengthAlsoWhenItBeginsWithSolid) {
    const Source source = stl(binaryStl(2, 2));
    EXPECT_EQ(source.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(source.positions[4], vec3(1, 0, 0));
    EXPECT_EQ(source.fileVertices, 6u);
}

TEST(Stl, TextIsRead) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\n";
    EXPECT_EQ(stl("solid a b\n" + facet + facet + "endsolid a b\n").triangles.size(), 2u);
    EXPECT_EQ(refusalOf(stl, "solid\n" + facet),
              "STL: line 9: ends without \"endsolid\": the file is truncated");
    EXPECT_EQ(refusalOf(stl, "solid\nfacet\nvertex 0 0 0\nendfacet\nendsolid\n"),
              "STL: line 4: facet has 1 vertices, not 3");
    EXPECT_EQ(refusalOf(stl, "solid\nvertex 0 0 inf\n"),
              "STL: line 2: \"inf\" is not a finite number");
    EXPECT_EQ(refusalOf(stl, "solid\nendsolid\n"), "STL: holds no triangle");
}

TEST(Stl, TruncatedBinariesAreRefused) {
    std::string cut = binaryStl(3, 2);
    cut[0] = 'x';
    EXPECT_EQ(refusalOf(stl, cut), "STL: says 3 triangles, which take 234 bytes, but has 184");
    EXPECT_EQ(refusalOf(stl, "xyz"),
              "STL: is truncated: a binary STL has at least 84 bytes, this has 3");
    std::string nan = binaryStl(1, 1);
    const float value = std::numeric_limits<float>::infinity();
    std::memcpy(nan.data() + 96, &value, sizeof value);
    EXPECT_EQ(refusalOf(stl, nan),
              "STL: triangle 0 at byte 96 has a coordinate that is not finite");
}

TEST(Source, TheReaderIsChosenByContentAndThenByName) {
    const TempFolder folder;
    EXPECT_EQ(readSource(folder.write("a.obj", kAsciiPly)).triangles.size(), 3u);
    EXPECT_EQ(readSource(folder.write("b.txt", binaryStl(1, 1))).triangles.size(), 1u);
    EXPECT_EQ(
        readSource(folder.write("c", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).triangles.size(),
        1u);
    EXPECT_EQ(
        readSource(folder.write("d.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).triangles.size(),
        1u);
    const std::string other = folder.write("e.txt", "hello");
    EXPECT_EQ(refusal([&] { readSource(other); }),
              other +
                  ": is none of .glb, .gltf, .obj, .ply, .off, .stl, neither by its content nor by "
                  "its name");
    const std::string empty = folder.write("f.obj", "");
    EXPECT_EQ(refusal([&] { readSource(empty); }), empty + ": is empty");
    EXPECT_EQ(refusal([&] { readSource(folder.path("none.obj")); }),
              folder.path("none.obj") + ": No such file or directory");
}

TEST(Source, CancelStopsTheWork) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 100000; ++i) text += "f 1 2 3\n";
    Progress progress;
    progress.cancel = true;
    EXPECT_THROW(readObj(bytesOf(text), "", &progress), Cancelled);
}

TEST(SourceShared, MeshesHaveTheirCounts) {
    const struct {
        const char* name;
        std::size_t vertices, triangles;
    } rows[] = {{"stanford-bunny.obj", 35947, 69451},
                {"teapot.obj", 3644, 6320},
                {"suzanne.obj", 507, 968},
                {"spot.obj", 2930, 5856}};
    for (const auto& row : rows) {
        const std::string path = sharedMesh(row.name);
        if (path.empty()) GTEST_SKIP() << "the shared meshes are not here";
        const Source source = readSource(path);
        EXPECT_EQ(source.fileVertices, row.vertices) << row.name;
        EXPECT_EQ(source.triangles.size(), row.triangles) << row.name;
        std::vector<char> used(source.positions.size(), 0);
        for (const uvec3 t : source.triangles) used[t.x] = used[t.y] = used[t.z] = 1;
        if (row.vertices == 35947) {
            EXPECT_EQ(std::count(used.begin(), used.end(), 1), 34834);
        }
        EXPECT_EQ(source.images.size(), row.vertices == 2930 ? 1u : 0u) << row.name;
    }
}

TEST(Ply, ElementsWithoutPropertiesTakeNoTimeWhateverTheirCount) {
    const std::string start =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float "
        "z\n";
    std::string text = start;
    for (int i = 0; i < 1000; ++i) text += "element face 2147483647\nelement edge 2147483647\n";
    text += "end_header\n0 0 0\n1 0 0\n0 1 0\n";
    // Were they counted through, this test would not end.
    EXPECT_EQ(refusal([&] { readPly(bytesOf(text), ""); }), "PLY: holds no triangle");
}

}  // namespace
}  // namespace pelage
