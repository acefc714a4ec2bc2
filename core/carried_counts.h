// carried_counts.h -- how much a glTF carries beside its skin; all of it goes through to the
// export.
#pragma once

#include <cstddef>

#include "source.h"

namespace pelage {

struct CarriedCounts {
    std::size_t nodes = 0;
    std::size_t joints = 0;  // nodes that any skin names, each once
    std::size_t animations = 0;
    std::size_t morphTargets = 0;  // of the mesh that has most
    std::size_t materials = 0;
    std::size_t images = 0;
};

// All 0 for a source that is not glTF.
CarriedCounts carriedCounts(const Source& source);

}  // namespace pelage
