// gltf_accessor.h -- the numbers that a glTF accessor stands for, in whatever form they are stored.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gltf_file.h"
#include "types.h"

namespace pelage {

struct AccessorShape {
    std::size_t count = 0;
    std::size_t components = 0;  // 1 for SCALAR, 16 for MAT4
};

// Count and width of an accessor; checks that all its values lie in its buffer.
AccessorShape accessorShape(const GltfFile& file, std::size_t accessor);

// The first `most` elements as floats, one after the other: normalized integers in [-1,1], others
// as they are, floats bit for bit, sparse values put in place, zeros where there is no buffer
// view. Refuses an accessor that has not `components` components.
std::vector<float> accessorFloats(GltfFile& file, std::size_t accessor, std::size_t components,
                                  std::size_t most = ~std::size_t{0});

// The same for unsigned integers (indices, joints); refuses any other component type.
std::vector<uint> accessorIntegers(GltfFile& file, std::size_t accessor, std::size_t components);

}  // namespace pelage
