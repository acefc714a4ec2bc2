// files.h -- files written so that a reader sees the old content or the new one, never half of it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

// Writes beside `path`, fsyncs, renames over it and fsyncs the folder. Keeps the permissions of a
// file that was there, and follows a symbolic link to what it names. Throws std::runtime_error
// "path: what: why"; `path` is then as before and nothing is left beside it, nor when the process
// is killed while it writes (on file systems that have files without names).
void writeFileAtomically(const std::string& path, std::span<const std::byte> bytes);

// With all folders above it, where it is not there yet. Throws std::runtime_error "path: why".
void makeFolder(const std::string& path);

// Whether the name ends in `extension` (".glb", ".fur.json"), in upper or lower case, and is more
// than that.
bool hasExtension(const std::string& path, std::string_view extension);

// What is written is of one format, whatever the name: refuses a name without the extension, so
// that no save goes over the source horse.obj.
// Throws std::runtime_error "\"horse.obj\" does not end in .glb".
void expectExtension(const std::string& path, std::string_view extension);

// The whole file. Throws std::runtime_error "path: why" when it cannot be read, is no regular file
// or is larger than `limit` bytes.
std::vector<std::byte> readFile(const std::string& path, std::size_t limit);

}  // namespace pelage
