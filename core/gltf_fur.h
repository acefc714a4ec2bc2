// gltf_fur.h -- fur that an earlier groom left in a glTF: fields on vertices and the block in
// extras.
#pragma once

#include "gltf_file.h"
#include "source.h"

namespace pelage {

// Reads fur_length, fur_density, fur_direction and fur_tint of the part into source.fur, which is
// made when the first is found. Names are compared without case and without leading underscores,
// because Blender adds one and three.js lowers the case. Floats are kept bit for bit; what no fur
// can have (NaN, negative or infinite lengths) becomes 0, in a tint 1, and is counted in a warning.
void readFurFields(GltfFile& file, Source& source, const SourcePart& part,
                   const JsonPlace& primitive);

// Warns of the primitives that lack a field which other primitives have, and says what counts
// there: length 0, density 1, direction along the normal, tint 1. `source` holds all parts.
void warnMissingFields(GltfFile& file, const Source& source);

// The body segments that an earlier groom left: the list of extras.fur and _FUR_SEGMENT of the
// parts, -1 for none. False when there is no list.
bool readFurSegments(GltfFile& file, Source& source);

// The extras.fur of the first mesh that has one, else of the first node, else of the asset, as
// JSON; "" for none. Only objects count.
std::string furBlock(const GltfFile& file);

}  // namespace pelage
