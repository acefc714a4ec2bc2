// hard_cases.h -- meshes, furs and grooms that break careless code.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "test_skins.h"

namespace pelage::test {

struct HardMesh {
    std::string name;
    Source source;
};

// Slivers, faces of no area, turned, twice or crossing, sizes and places far from 1 m, and nodes
// that mirror, stretch and flatten.
std::vector<HardMesh> hardMeshes();

// Moves a parameter to an end of its range or into it, whichever is drawn.
void drawParameter(Fur& fur, Coat Fur::*coat, const Parameter& row, Draws& draws);

// A fur of which every parameter but the number of hairs is drawn so.
Fur drawnFur(Draws& draws);

// A groom with hair along and against the normal and gravity, of no, tiny, usual and huge length,
// on bald, thin and full skin. Lengths are shares of `size`, m.
Groom drawnGroom(const Skin& skin, float size, Draws& draws);

}  // namespace pelage::test
