// source.cpp -- decides which reader a file is for.
#include "source.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "files.h"
#include "gltf_file.h"
#include "gltf_in.h"
#include "mesh_in.h"

namespace pelage {
namespace {

using Reader = Source (*)(std::span<const std::byte>, const std::string&, Progress*);

std::string_view firstWord(std::string_view text) {
    const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const std::size_t end = text.find_first_of(" \t\r\n#", start);
    return text.substr(start, (end == std::string_view::npos ? text.size() : end) - start);
}

Reader byContent(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                                std::min(bytes.size(), std::size_t{4096}));
    if (text.starts_with("glTF")) return readGltf;
    const std::string_view word = firstWord(text);
    if (word == "ply") return readPly;
    if (word.size() <= 7 && word.ends_with("OFF")) return readOff;
    if (word.starts_with('{') || word.starts_with("\xef\xbb\xbf{")) return readGltf;
    if (isBinaryStl(bytes)) return readStl;
    return nullptr;
}

Reader byExtension(std::string extension) {
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".glb" || extension == ".gltf") return readGltf;
    if (extension == ".obj") return readObj;
    if (extension == ".ply") return readPly;
    if (extension == ".off") return readOff;
    if (extension == ".stl") return readStl;
    return nullptr;
}

}  // namespace

std::vector<uint> partOfVertex(const Source& source) {
    std::vector<uint> part(source.positions.size(), 0);
    for (uint p = 0; p < source.parts.size(); ++p) {
        const SourcePart& run = source.parts[p];
        std::fill_n(part.begin() + run.firstVertex, run.vertexCount, p);
    }
    return part;
}

Source readSource(const std::string& path, Progress* progress) {
    const std::vector<std::byte> bytes = readFile(path, kMaxFileBytes);
    if (bytes.empty()) throw std::runtime_error(path + ": is empty");
    if (progress) progress->report(0.05f);
    Reader reader = byContent(bytes);
    if (!reader) reader = byExtension(std::filesystem::path(path).extension().string());
    if (!reader) {
        throw std::runtime_error(path +
                                 ": is none of .glb, .gltf, .obj, .ply, .off, .stl, neither by its "
                                 "content nor by its name");
    }
    return reader(bytes, path, progress);
}

}  // namespace pelage
