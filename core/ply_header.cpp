// ply_header.cpp -- parses the header of a PLY file.
#include "ply_header.h"

#include <stdexcept>

#include "text.h"
#include "text_scan.h"

namespace pelage {
namespace {

PlyType typeNamed(const TextScan& scan, std::string_view name) {
    struct Row {
        std::string_view name, other;
        PlyType type;
    };
    static constexpr Row kRows[] = {
        {"char", "int8", PlyType::int8},        {"uchar", "uint8", PlyType::uint8},
        {"short", "int16", PlyType::int16},     {"ushort", "uint16", PlyType::uint16},
        {"int", "int32", PlyType::int32},       {"uint", "uint32", PlyType::uint32},
        {"float", "float32", PlyType::float32}, {"double", "float64", PlyType::float64}};
    for (const Row& row : kRows) {
        if (name == row.name || name == row.other) return row.type;
    }
    scan.refuse(inQuotes(name) + " is not a type of PLY");
}

PlyProperty readProperty(TextScan& scan) {
    PlyProperty property;
    std::string_view type = scan.word();
    if (type == "list") {
        property.isList = true;
        property.countType = typeNamed(scan, scan.word());
        if (!isInteger(property.countType)) scan.refuse("a list cannot be counted in fractions");
        type = scan.word();
    }
    property.type = typeNamed(scan, type);
    property.name = scan.word();
    return property;
}

// The least number of bytes that one row takes.
std::size_t leastRow(const PlyElement& element, PlyFormat format) {
    std::size_t sum = 0;
    for (const PlyProperty& property : element.properties) {
        sum += format == PlyFormat::ascii
                   ? 2
                   : byteCount(property.isList ? property.countType : property.type);
    }
    return sum;
}

void checkCounts(const PlyHeader& header, std::size_t left, const std::string& file) {
    for (const PlyElement& element : header.elements) {
        const std::size_t row = leastRow(element, header.format);
        // The last number of a text may lack its blank.
        if (row == 0 || element.count <= (left + 1) / row) continue;
        throw std::runtime_error(file + ": says " + std::to_string(element.count) + " of element " +
                                 inQuotes(element.name) + ", but only " + std::to_string(left) +
                                 " bytes follow the header");
    }
}

}  // namespace

std::size_t byteCount(PlyType type) {
    constexpr std::size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kBytes[static_cast<std::size_t>(type)];
}

bool isInteger(PlyType type) { return type < PlyType::float32; }

PlyHeader readPlyHeader(std::span<const std::byte> bytes, const std::string& file) {
    PlyHeader header;
    TextScan scan(file, bytes);
    if (scan.word() != "ply") scan.refuse("is not \"ply\"");
    scan.nextLine();
    bool known = false;
    while (scan.nextContent()) {
        const std::string_view key = scan.word();
        if (key == "end_header") {
            if (!known) scan.refuse("the header names no format");
            scan.nextLine();
            header.bytes = bytes.size() - scan.bytesLeft();
            header.lines = scan.line() - 1;
            checkCounts(header, scan.bytesLeft(), file);
            return header;
        }
        if (key == "format") {
            const std::string_view name = scan.word();
            known = true;
            if (name == "ascii")
                header.format = PlyFormat::ascii;
            else if (name == "binary_little_endian")
                header.format = PlyFormat::littleEndian;
            else if (name == "binary_big_endian")
                header.format = PlyFormat::bigEndian;
            else
                scan.refuse(inQuotes(name) + " is not a format of PLY");
        } else if (key == "element") {
            PlyElement element;
            element.name = scan.word();
            const std::int64_t count = scan.integer("a count");
            if (count < 0 || count > 0x7fffffff)
                scan.refuse("count " + std::to_string(count) + " is out of range");
            element.count = static_cast<std::size_t>(count);
            header.elements.push_back(std::move(element));
        } else if (key == "property") {
            if (header.elements.empty()) scan.refuse("a property stands before every element");
            header.elements.back().properties.push_back(readProperty(scan));
        } else if (key == "comment") {
            if (scan.word() == "TextureFile" && header.picture.empty())
                header.picture = scan.rest();
        } else if (key != "obj_info") {
            scan.refuse(inQuotes(key) + " is not a line of a PLY header");
        }
        scan.nextLine();
    }
    scan.refuse("the header has no end: the file is truncated");
}

}  // namespace pelage
