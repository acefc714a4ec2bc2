// stl_fuzz.cpp -- no bytes, read as an STL file, may crash, hang or take memory without bound.
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>

#include "core/mesh_in.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // No path: no file beside it is opened.
        pelage::readStl(std::as_bytes(std::span(data, size)), "");
    } catch (const std::runtime_error& error) {
        // Bad input is refused in this way and in no other, with one line.
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) __builtin_trap();
    }
    return 0;
}
