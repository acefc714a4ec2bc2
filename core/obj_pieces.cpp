// obj_pieces.cpp -- runs of triangles that share their names.
#include "obj_pieces.h"

#include "segment_parts.h"

namespace pelage {

void ObjPieces::begin(Kind kind, std::string_view name, std::size_t triangle) {
    auto& numbers = numbers_[kind];
    auto known = numbers.find(name);
    if (known == numbers.end())
        known = numbers.emplace(std::string(name), static_cast<uint>(numbers.size())).first;
    if (now_[kind] == known->second) return;
    now_[kind] = known->second;
    runs_.push_back({triangle, now_});
}

void ObjPieces::nameSegments(Source& source) const {
    for (const Kind kind : {kMaterial, kObject, kGroup}) {
        Pieces pieces;
        pieces.names.resize(numbers_[kind].size());
        for (const auto& [name, number] : numbers_[kind]) pieces.names[number] = name;
        pieces.of.assign(source.positions.size(), kNoSegment);
        for (std::size_t r = 0; r < runs_.size(); ++r) {
            const std::size_t end =
                r + 1 < runs_.size() ? runs_[r + 1].firstTriangle : source.triangles.size();
            for (std::size_t t = runs_[r].firstTriangle; t < end; ++t)
                for (int c = 0; c < 3; ++c) {
                    uint& of = pieces.of[source.triangles[t][c]];
                    if (of == kNoSegment) of = runs_[r].of[kind];
                }
        }
        if (segmentsFromPieces(source, pieces, "group")) return;
    }
}

}  // namespace pelage
