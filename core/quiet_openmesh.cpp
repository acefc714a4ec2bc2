// quiet_openmesh.cpp -- turns OpenMesh's own error stream off and on.
#include "quiet_openmesh.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <OpenMesh/Core/System/omstream.hh>
#pragma GCC diagnostic pop

namespace pelage {

Quiet::Quiet() { omerr().disable(); }
Quiet::~Quiet() { omerr().enable(); }

}  // namespace pelage
