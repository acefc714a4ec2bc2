// animal.h -- the built-in animal: a four-legged creature made by code, at any resolution.
#pragma once

#include <cstddef>

#include "document.h"
#include "source.h"

namespace pelage {

constexpr std::size_t kAnimalTriangles = 60'000;  // where nobody says how many

// A closed, manifold, outward-facing skin with unit normals, UVs without overlap, a base-color
// picture and named segments (head, ears, neck, trunk, legs, feet, tail) with head-to-tail axes.
// About 1 m long, standing on y = 0, looking along +z. `triangles` in [2000, 2000000]; the count
// made is within 10 % of it. The same on every machine.
Source makeAnimal(std::size_t triangles);

// The animal, groomed: short on face and feet, long on the tail, combed from head to tail.
Document groomedAnimal(std::size_t triangles);

}  // namespace pelage
