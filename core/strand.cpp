// strand.cpp -- strand.glsl and fiber.glsl, as C++.
#include "strand.h"

#include "elastica.h"

namespace pelage {

#include "strand_source.h"

}  // namespace pelage
