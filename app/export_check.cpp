// export_check.cpp -- the comparison, vertex by vertex.
#include "app/export_check.h"

#include <cstring>
#include <stdexcept>

namespace pelage {
namespace {

// Bits, not values: -0 is not 0 here.
bool sameBits(const FurVertex& a, const FurVertex& b) {
    return std::memcmp(&a.direction, &b.direction, sizeof a.direction) == 0 &&
           std::memcmp(&a.furLength, &b.furLength, sizeof a.furLength) == 0 &&
           std::memcmp(&a.density, &b.density, sizeof a.density) == 0;
}

}  // namespace

std::string checkExport(const Document& document, const std::string& path, Progress* progress) {
    const Document again = openDocument(readSource(path, progress), progress);
    const std::size_t count = document.groom.fur.size();
    if (again.groom.fur.size() != count)
        throw std::runtime_error(path + ": reads back with " +
                                 std::to_string(again.groom.fur.size()) + " vertices of " +
                                 std::to_string(count));
    for (std::size_t v = 0; v < count; ++v)
        if (!sameBits(document.groom.fur[v], again.groom.fur[v]))
            throw std::runtime_error(path + ": the fur of vertex " + std::to_string(v) + " of " +
                                     std::to_string(count) + " reads back differently");
    if (!(document.fur == again.fur))
        throw std::runtime_error(path + ": the coats read back differently");
    return "; read back: the fur of " + std::to_string(count) +
           " vertices and both coats are equal to the bit";
}

}  // namespace pelage
