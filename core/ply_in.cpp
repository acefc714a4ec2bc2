// ply_in.cpp -- reads Stanford PLY, text and binary.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "mesh_build.h"
#include "mesh_in.h"
#include "ply_header.h"
#include "srgb.h"
#include "text.h"
#include "text_scan.h"

namespace pelage {
namespace {

// What a property of a vertex is for.
enum Role : int {
    kX,
    kY,
    kZ,
    kNormalX,
    kNormalY,
    kNormalZ,
    kRed,
    kGreen,
    kBlue,
    kAlpha,
    kU,
    kV,
    kOther
};

Role roleOf(const std::string& name) {
    static constexpr struct {
        std::string_view name;
        Role role;
    } kRows[] = {{"x", kX},        {"y", kY},         {"z", kZ},         {"nx", kNormalX},
                 {"ny", kNormalY}, {"nz", kNormalZ},  {"red", kRed},     {"green", kGreen},
                 {"blue", kBlue},  {"alpha", kAlpha}, {"r", kRed},       {"g", kGreen},
                 {"b", kBlue},     {"a", kAlpha},     {"u", kU},         {"v", kV},
                 {"s", kU},        {"t", kV},         {"texture_u", kU}, {"texture_v", kV}};
    for (const auto& row : kRows) {
        if (row.name == name) return row.role;
    }
    return kOther;
}

// The numbers after the header, one after the other, whatever their form.
class PlyNumbers {
public:
    PlyNumbers(const PlyHeader& header, std::span<const std::byte> bytes, const std::string& file)
        : format_(header.format),
          file_(file),
          headerLines_(header.lines),
          bytes_(bytes),
          at_(header.bytes),
          scan_(file, bytes.subspan(header.bytes)) {}

    double next(PlyType type) {
        if (format_ != PlyFormat::ascii) return nextBinary(type);
        if (!scan_.nextContent()) refuse("the file ends too early");
        try {
            return isInteger(type) ? static_cast<double>(scan_.integer("a number"))
                                   : double{scan_.number("a number")};
        } catch (const std::runtime_error&) {
            refuse("a number is expected");
        }
    }

    std::size_t bytesLeft() const {
        return format_ == PlyFormat::ascii ? scan_.bytesLeft() : bytes_.size() - at_;
    }

    // Adds where in the file the complaint is.
    [[noreturn]] void refuse(const std::string& what) const {
        const std::string where = format_ == PlyFormat::ascii
                                      ? "line " + std::to_string(headerLines_ + scan_.line())
                                      : "byte " + std::to_string(at_);
        throw std::runtime_error(file_ + ": " + where + ": " + what);
    }

private:
    double nextBinary(PlyType type) {
        const std::size_t size = byteCount(type);
        if (size > bytes_.size() - at_) refuse("the file ends too early");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t from =
                format_ == PlyFormat::littleEndian ? at_ + size - 1 - i : at_ + i;
            bits = bits << 8 | std::to_integer<std::uint64_t>(bytes_[from]);
        }
        at_ += size;
        switch (type) {
            case PlyType::int8:
                return static_cast<std::int8_t>(bits);
            case PlyType::int16:
                return static_cast<std::int16_t>(bits);
            case PlyType::int32:
                return static_cast<std::int32_t>(bits);
            case PlyType::float32:
                return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
            case PlyType::float64:
                return std::bit_cast<double>(bits);
            default:
                return static_cast<double>(bits);
        }
    }

    PlyFormat format_;
    std::string file_;
    std::size_t headerLines_;
    std::span<const std::byte> bytes_;
    std::size_t at_;
    TextScan scan_;
};

// Length of a list; it must fit into what is left of the file.
std::size_t listLength(PlyNumbers& numbers, const PlyProperty& property) {
    const double length = numbers.next(property.countType);
    if (!(length >= 0.0 && length <= static_cast<double>(numbers.bytesLeft()))) {
        numbers.refuse("list " + inQuotes(property.name) + " is longer than the file");
    }
    return static_cast<std::size_t>(length);
}

void skip(PlyNumbers& numbers, const PlyProperty& property) {
    const std::size_t count = property.isList ? listLength(numbers, property) : 1;
    for (std::size_t i = 0; i < count; ++i) numbers.next(property.type);
}

float colorValue(double value, PlyType type, bool isAlpha) {
    const double scale = type == PlyType::uint8 ? 255.0 : type == PlyType::uint16 ? 65535.0 : 1.0;
    const float share = static_cast<float>(std::clamp(value / scale, 0.0, 1.0));
    return isAlpha || !isInteger(type) ? share : linearFromSrgb(share);
}

void readVertices(PlyNumbers& numbers, const PlyElement& element, Source& source, Ticker& ticker) {
    std::vector<Role> roles;
    bool has[kOther + 1] = {};
    for (const PlyProperty& property : element.properties) {
        roles.push_back(property.isList ? kOther : roleOf(property.name));
        has[roles.back()] = true;
    }
    if (!has[kX] || !has[kY] || !has[kZ]) numbers.refuse("vertices have no x, y, z");
    const bool normals = has[kNormalX] && has[kNormalY] && has[kNormalZ];
    const bool colors = has[kRed] && has[kGreen] && has[kBlue], uvs = has[kU] && has[kV];
    source.positions.reserve(element.count);
    for (std::size_t v = 0; v < element.count; ++v) {
        float value[kOther] = {};
        value[kAlpha] = 1.0f;
        for (std::size_t p = 0; p < roles.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (roles[p] == kOther) {
                skip(numbers, property);
                continue;
            }
            const double read = numbers.next(property.type);
            if (!(std::abs(read) <= 3.402823466e38)) {
                numbers.refuse("vertex " + std::to_string(v) + " has a value of " +
                               inQuotes(property.name) + " that is not finite");
            }
            const bool isColor = roles[p] >= kRed && roles[p] <= kAlpha;
            value[roles[p]] = isColor ? colorValue(read, property.type, roles[p] == kAlpha)
                                      : static_cast<float>(read);
        }
        source.positions.emplace_back(value[kX], value[kY], value[kZ]);
        if (normals) source.normals.emplace_back(value[kNormalX], value[kNormalY], value[kNormalZ]);
        if (colors)
            source.colors.emplace_back(value[kRed], value[kGreen], value[kBlue], value[kAlpha]);
        if (uvs) source.uvs.emplace_back(value[kU], 1.0f - value[kV]);
        ticker.tick(v, 2 * element.count);
    }
}

// Polygons of the list of corners; other properties are passed over.
void readFaces(PlyNumbers& numbers, const PlyElement& element, MeshBuild& build, Ticker& ticker) {
    std::vector<uint> polygon;
    for (std::size_t f = 0; f < element.count; ++f) {
        for (const PlyProperty& property : element.properties) {
            if (!property.isList ||
                (property.name != "vertex_indices" && property.name != "vertex_index")) {
                skip(numbers, property);
                continue;
            }
            polygon.clear();
            const std::size_t corners = listLength(numbers, property);
            for (std::size_t c = 0; c < corners; ++c) {
                const double v = numbers.next(property.type);
                if (!(v >= 0.0 && v < static_cast<double>(build.source.positions.size())) ||
                    v != std::floor(v)) {
                    char text[32];
                    std::snprintf(text, sizeof text, "%.9g", v);
                    numbers.refuse("face " + std::to_string(f) + " names vertex " + text + " of " +
                                   std::to_string(build.source.positions.size()));
                }
                polygon.push_back(static_cast<uint>(v));
            }
            build.addPolygon(polygon);
        }
        ticker.tick(element.count + f, 2 * element.count);
    }
}

}  // namespace

Source readPly(std::span<const std::byte> bytes, const std::string& path, Progress* progress) {
    MeshBuild build(path, "PLY");
    const PlyHeader header = readPlyHeader(bytes, build.file);
    PlyNumbers numbers(header, bytes, build.file);
    Ticker ticker{progress};
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex" && build.source.positions.empty()) {
            readVertices(numbers, element, build.source, ticker);
        } else if (element.properties.empty()) {
            continue;  // takes no bytes, whatever its count says
        } else if (element.name == "face") {
            readFaces(numbers, element, build, ticker);
        } else {
            for (std::size_t i = 0; i < element.count; ++i) {
                for (const PlyProperty& property : element.properties) skip(numbers, property);
            }
        }
    }
    build.source.fileVertices = build.source.positions.size();
    if (!header.picture.empty()) addPicture(build.source, header.picture);
    return build.finish();
}

}  // namespace pelage
