// ply_header.h -- what the header of a PLY file says about the numbers that follow.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pelage {

enum class PlyFormat { ascii, littleEndian, bigEndian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t byteCount(PlyType type);
bool isInteger(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  // of a list: of its values
    bool isList = false;
    PlyType countType = PlyType::uint8;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::string picture;    // of a "comment TextureFile NAME"
    std::size_t bytes = 0;  // length of the header
    std::size_t lines = 0;
};

// Refuses what is no header, and counts that the bytes after it cannot hold. `file` opens messages.
PlyHeader readPlyHeader(std::span<const std::byte> bytes, const std::string& file);

}  // namespace pelage
