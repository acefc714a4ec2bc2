// obj_pieces.h -- the materials, objects and groups of an OBJ as segments of a body.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "source.h"

namespace pelage {

// Follows the lines of the file.
class ObjPieces {
public:
    enum Kind { kMaterial, kObject, kGroup };

    // The triangles from this one on are of the material, object or group of that name.
    void begin(Kind kind, std::string_view name, std::size_t triangle);

    // Makes segments of the materials, else the objects, else the groups, by segmentsFromPieces. A
    // vertex belongs where the first triangle that uses it does.
    void nameSegments(Source& source) const;

private:
    using Numbers = std::array<uint, 3>;  // by Kind, kNoSegment before the first
    struct Run {
        std::size_t firstTriangle;
        Numbers of;
    };

    std::array<std::map<std::string, uint, std::less<>>, 3> numbers_;
    Numbers now_{kNoSegment, kNoSegment, kNoSegment};
    std::vector<Run> runs_;
};

}  // namespace pelage
