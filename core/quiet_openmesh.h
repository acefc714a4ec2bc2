// quiet_openmesh.h -- keeps OpenMesh from telling std::cerr of each face that it refuses.
#pragma once

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <OpenMesh/Core/System/omstream.hh>
#pragma GCC diagnostic pop

namespace pelage {

// We count them instead.
class Quiet {
public:
    Quiet() { omerr().disable(); }
    ~Quiet() { omerr().enable(); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

}  // namespace pelage
