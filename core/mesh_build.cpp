// mesh_build.cpp -- fans, pictures, and the one part of a source that is no glTF.
#include "mesh_build.h"

#include <filesystem>
#include <stdexcept>

#include "beside.h"
#include "source_check.h"
#include "text.h"

namespace pelage {
namespace {

constexpr std::size_t kMaxPictureBytes = std::size_t{1} << 28;

// True when some triangle of the fan turns against the polygon as a whole.
bool foldsOver(std::span<const uint> corners, const std::vector<vec3>& positions) {
    for (const uint c : corners) {
        if (c >= positions.size()) return false;
    }
    const vec3 first = positions[corners[0]];
    const auto normal = [&](std::size_t i) {
        return glm::cross(positions[corners[i]] - first, positions[corners[i + 1]] - first);
    };
    vec3 sum(0.0f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += normal(i);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        if (glm::dot(normal(i), sum) < 0.0f) return true;
    }
    return false;
}

}  // namespace

MeshBuild::MeshBuild(const std::string& path, const char* format)
    : file(path.empty() ? format : path) {
    source.path = path;
}

void MeshBuild::addPolygon(std::span<const uint> corners) {
    if (corners.size() < 3) {
        ++cornerless;
        return;
    }
    if (corners.size() > 3 && foldsOver(corners, source.positions)) ++concave;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        source.triangles.emplace_back(corners[0], corners[i], corners[i + 1]);
    }
}

Source MeshBuild::finish() {
    if (concave > 0) {
        source.warnings.push_back(std::to_string(concave) +
                                  " faces are concave; their fans of triangles overlap");
    }
    if (cornerless > 0) {
        source.warnings.push_back(std::to_string(cornerless) +
                                  " faces have fewer than three corners and hold no surface");
    }
    SourcePart part;
    part.name = std::filesystem::path(source.path).stem().string();
    part.vertexCount = static_cast<uint>(source.positions.size());
    part.triangleCount = static_cast<uint>(source.triangles.size());
    part.material = source.materials.empty() ? -1 : 0;
    source.parts.push_back(std::move(part));
    finishSource(source, file);
    return std::move(source);
}

void addPicture(Source& source, const std::string& reference) {
    if (source.path.empty()) return;
    std::vector<std::byte> bytes;
    try {
        bytes = readBeside(source.path, reference, kMaxPictureBytes);
    } catch (const std::runtime_error& error) {
        source.warnings.push_back(error.what());
        return;
    }
    if (!isPicture(bytes)) {
        source.warnings.push_back("picture " + inQuotes(reference) +
                                  " is neither PNG nor JPEG, so it is not shown");
        return;
    }
    if (source.materials.empty()) source.materials.emplace_back();
    source.materials[0].image = static_cast<int>(source.images.size());
    source.images.push_back(
        {std::filesystem::path(reference).filename().string(), std::move(bytes)});
}

}  // namespace pelage
