// quiet_openmesh.h -- keeps OpenMesh from telling std::cerr of each face that it refuses.
#pragma once

namespace pelage {

// While it lives. We count those faces instead.
class Quiet {
public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

}  // namespace pelage
