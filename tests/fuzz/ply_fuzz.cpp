// ply_fuzz.cpp -- no bytes, read as a PLY file, may crash, hang or take memory without bound.
#include "core/mesh_in.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pelage::fuzz::readMesh(pelage::readPly, data, size);
}
