// bench_animal.h -- the groomed animal at a number of triangles, made once for all benchmarks.
#pragma once

#include <cstddef>
#include <map>
#include <memory>

#include "core/animal.h"
#include "core/skin_query.h"

namespace pelage::bench {

struct Animal {
    Document document;
    SkinQuery query;

    explicit Animal(std::size_t triangles)
        : document(groomedAnimal(triangles)), query(document.skin) {}
    double triangles() const { return static_cast<double>(document.skin->triangles.size()); }
};

// Only the last one is kept: two million triangles are large.
inline const Animal& animal(std::size_t triangles) {
    static std::size_t kept = 0;
    static std::unique_ptr<Animal> last;
    if (kept != triangles) {
        last.reset();
        last = std::make_unique<Animal>(triangles);
        kept = triangles;
    }
    return *last;
}

}  // namespace pelage::bench
