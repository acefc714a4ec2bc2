# Writes OUT, a C++ file with a function FUNCTION that returns every file of SOURCES byte for byte.
# Run by the build: cmake -DOUT=... -DFUNCTION=... "-DSOURCES=a.glsl;b.glsl" -P embed.cmake
set(arrays "")
set(table "")
foreach(path IN LISTS SOURCES)
    get_filename_component(name "${path}" NAME)
    string(MAKE_C_IDENTIFIER "${name}" id)
    file(READ "${path}" hex HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    string(APPEND arrays "constexpr unsigned char ${id}[] = {${bytes}};\n")
    string(APPEND table "    {\"${name}\", {reinterpret_cast<const char*>(${id}), sizeof ${id}}},\n")
endforeach()
file(WRITE "${OUT}" "// Written by embed.cmake; do not edit.
#include \"core/embedded.h\"

namespace pelage {
namespace {
${arrays}}  // namespace

std::span<const EmbeddedFile> ${FUNCTION}() {
    static const EmbeddedFile files[] = {
${table}    };
    return files;
}

}  // namespace pelage
")
