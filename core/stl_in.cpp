// stl_in.cpp -- reads stereolithography files, binary and ASCII.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "mesh_build.h"
#include "mesh_in.h"
#include "text_scan.h"

namespace pelage {
namespace {

constexpr std::size_t kHeader = 84, kRecord = 50;  // bytes

std::size_t recordCount(std::span<const std::byte> bytes) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        count |= std::to_integer<std::size_t>(bytes[80 + i]) << (8 * i);
    return count;
}

// Little-endian, as the file; the machines this is built for are, too, but it costs nothing.
float floatAt(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i)
        bits |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

void addTriangle(Source& source) {
    const uint last = static_cast<uint>(source.positions.size());
    source.triangles.emplace_back(last - 3, last - 2, last - 1);
}

void readBinary(std::span<const std::byte> bytes, MeshBuild& build, Ticker ticker) {
    const std::size_t count = recordCount(bytes);
    build.source.positions.reserve(count * 3);
    build.source.triangles.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t at = kHeader + t * kRecord + 12 + corner * 12;
            const vec3 p(floatAt(bytes, at), floatAt(bytes, at + 4), floatAt(bytes, at + 8));
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
                throw std::runtime_error(build.file + ": triangle " + std::to_string(t) +
                                         " at byte " + std::to_string(at) +
                                         " has a coordinate that is not finite");
            }
            build.source.positions.push_back(p);
        }
        addTriangle(build.source);
        ticker.tick(t, count);
    }
}

void readText(std::span<const std::byte> bytes, MeshBuild& build, Ticker ticker) {
    TextScan scan(build.file, bytes);
    std::size_t corners = 0;  // of the current facet
    bool open = false;        // a solid
    for (; scan.nextContent(); scan.nextLine()) {
        const std::string_view word = scan.word();
        if (word == "vertex") {
            vec3 p;
            for (int i = 0; i < 3; ++i) p[i] = scan.number("a coordinate");
            build.source.positions.push_back(p);
            if (++corners == 3) addTriangle(build.source);
        } else if (word == "endfacet") {
            if (corners != 3)
                scan.refuse("facet has " + std::to_string(corners) + " vertices, not 3");
            corners = 0;
        } else if (word == "solid" || word == "endsolid") {
            open = word == "solid";
        } else if (word != "facet" && word != "outer" && word != "endloop") {
            scan.refuse("is not a line of an STL file");
        }
        ticker.tick(bytes.size() - scan.bytesLeft(), bytes.size());
    }
    if (open) scan.refuse("ends without \"endsolid\": the file is truncated");
    if (corners != 0) scan.refuse("ends within a facet");
}

}  // namespace

bool isBinaryStl(std::span<const std::byte> bytes) {
    return bytes.size() > kHeader && bytes.size() == kHeader + recordCount(bytes) * kRecord;
}

Source readStl(std::span<const std::byte> bytes, const std::string& path, Progress* progress) {
    MeshBuild build(path, "STL");
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    if (isBinaryStl(bytes)) {
        readBinary(bytes, build, {progress});
    } else if (text.substr(start).starts_with("solid")) {
        readText(bytes, build, {progress});
    } else if (bytes.size() < kHeader) {
        throw std::runtime_error(build.file +
                                 ": is truncated: a binary STL has at least 84 bytes, this has " +
                                 std::to_string(bytes.size()));
    } else {
        throw std::runtime_error(build.file + ": says " + std::to_string(recordCount(bytes)) +
                                 " triangles, which take " +
                                 std::to_string(kHeader + recordCount(bytes) * kRecord) +
                                 " bytes, but has " + std::to_string(bytes.size()));
    }
    build.source.fileVertices = build.source.positions.size();
    return build.finish();
}

}  // namespace pelage
