// off_in.cpp -- reads the Object File Format of Geomview, as text.
#include <algorithm>
#include <vector>

#include "mesh_build.h"
#include "mesh_in.h"
#include "srgb.h"
#include "text.h"
#include "text_scan.h"

namespace pelage {
namespace {

// What the lines of vertices hold besides a place.
struct OffForm {
    bool normals = false, colors = false, uvs = false;
};

OffForm readKeyword(TextScan& scan) {
    std::string_view word = scan.word();
    const std::string_view whole = word;
    OffForm form;
    const auto take = [&](std::string_view prefix) {
        if (!word.starts_with(prefix)) return false;
        word.remove_prefix(prefix.size());
        return true;
    };
    form.uvs = take("ST");
    form.colors = take("C");
    form.normals = take("N");
    if (word != "OFF")
        scan.refuse(inQuotes(whole) +
                    " is no form of OFF that is read (OFF with ST, C, N before it)");
    if (scan.atLineEnd()) {
        scan.nextLine();
        return form;
    }
    return form;
}

std::size_t readCount(TextScan& scan, const char* what) {
    const std::int64_t count = scan.integer(what);
    // Each takes a line of at least two bytes.
    const std::size_t most = std::min(scan.bytesLeft() / 2 + 1, std::size_t{0x7fffffff});
    if (count < 0 || static_cast<std::size_t>(count) > most) {
        scan.refuse("says " + std::to_string(count) + " " + what + ", but only " +
                    std::to_string(scan.bytesLeft()) + " bytes follow");
    }
    return static_cast<std::size_t>(count);
}

void nextRow(TextScan& scan, const char* what, std::size_t index, std::size_t count) {
    if (!scan.nextContent()) {
        scan.refuse(std::string("ends after ") + std::to_string(index) + " of " +
                    std::to_string(count) + " " + what);
    }
}

void readVertex(TextScan& scan, const OffForm& form, Source& source, bool& bytes) {
    const auto read = [&](auto vector) {
        for (int i = 0; i < decltype(vector)::length(); ++i) vector[i] = scan.number("a number");
        return vector;
    };
    source.positions.push_back(read(vec3(0.0f)));
    if (form.normals) source.normals.push_back(read(vec3(0.0f)));
    if (form.colors) {
        // Three numbers, or four with alpha; texture coordinates may follow.
        std::vector<float> values;
        while (const auto value = scan.tryNumber()) values.push_back(*value);
        const std::size_t uvs = form.uvs ? 2 : 0;
        if (values.size() < 3 + uvs) scan.refuse("ends where a color is expected");
        const std::size_t size = std::min(values.size() - uvs, std::size_t{4});
        vec4 color(values[0], values[1], values[2], -1.0f);
        if (size == 4) color.a = values[3];
        bytes = bytes || std::max({color.r, color.g, color.b, color.a}) > 1.0f;
        source.colors.push_back(color);
        if (form.uvs) source.uvs.emplace_back(values[values.size() - 2], 1.0f - values.back());
    } else if (form.uvs) {
        const vec2 uv = read(vec2(0.0f));
        source.uvs.emplace_back(uv.x, 1.0f - uv.y);
    }
    scan.nextLine();
}

// Colors are 0 to 255 when any is above 1, else 0 to 1; sRGB either way. No alpha is opaque.
void finishColors(Source& source, bool bytes) {
    for (vec4& color : source.colors) {
        const vec4 value = glm::clamp(bytes ? color / 255.0f : color, vec4(0.0f), vec4(1.0f));
        color = vec4(linearFromSrgb(value.r), linearFromSrgb(value.g), linearFromSrgb(value.b),
                     color.a < 0.0f ? 1.0f : value.a);
    }
}

void readFace(TextScan& scan, MeshBuild& build, std::vector<uint>& polygon) {
    const std::int64_t corners = scan.integer("the number of corners");
    if (corners < 0 || static_cast<std::size_t>(corners) > scan.bytesLeft()) {
        scan.refuse("face says it has " + std::to_string(corners) + " corners");
    }
    polygon.clear();
    for (std::int64_t i = 0; i < corners; ++i) {
        const std::int64_t v = scan.integer("a vertex");
        if (v < 0 || static_cast<std::size_t>(v) >= build.source.positions.size()) {
            scan.refuse("face names vertex " + std::to_string(v) + " of " +
                        std::to_string(build.source.positions.size()));
        }
        polygon.push_back(static_cast<uint>(v));
    }
    build.addPolygon(polygon);
    scan.nextLine();  // what is left is the color of the face
}

}  // namespace

Source readOff(std::span<const std::byte> bytes, const std::string& path, Progress* progress) {
    MeshBuild build(path, "OFF");
    TextScan scan(build.file, bytes);
    scan.nextContent();
    const OffForm form = readKeyword(scan);
    nextRow(scan, "counts", 0, 1);
    const std::size_t vertices = readCount(scan, "vertices"), faces = readCount(scan, "faces");
    scan.nextLine();

    Ticker ticker{progress};
    bool byteColors = false;
    build.source.positions.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        nextRow(scan, "vertices", v, vertices);
        readVertex(scan, form, build.source, byteColors);
        ticker.tick(v, vertices + faces);
    }
    finishColors(build.source, byteColors);
    std::vector<uint> polygon;
    for (std::size_t f = 0; f < faces; ++f) {
        nextRow(scan, "faces", f, faces);
        readFace(scan, build, polygon);
        ticker.tick(vertices + f, vertices + faces);
    }
    build.source.fileVertices = vertices;
    return build.finish();
}

}  // namespace pelage
