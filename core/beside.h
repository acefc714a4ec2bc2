// beside.h -- the only way by which a mesh file may name another file: one in its own folder.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

// The path of the file that `owner` means by the relative reference `uri`. Percent escapes are
// decoded first. Throws std::runtime_error that begins with `owner` when the reference is empty,
// absolute, has a scheme, a "..", a character of shells or queries, or leads out of the folder of
// `owner` through a symbolic link; and always when `owner` is empty. The file need not exist.
std::string pathBeside(const std::string& owner, std::string_view uri);

// Bytes of that file. Throws std::runtime_error as pathBeside and readFile do.
std::vector<std::byte> readBeside(const std::string& owner, std::string_view uri,
                                  std::size_t limit);

}  // namespace pelage
