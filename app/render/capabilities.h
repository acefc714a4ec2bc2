// capabilities.h -- what the graphics driver must offer.
#pragma once

namespace pelage {

// Of the current context. Throws std::runtime_error that names what is missing.
void requireCapabilities();

}  // namespace pelage
