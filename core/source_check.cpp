// source_check.cpp -- the last step of every reader.
#include "source_check.h"

#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "text.h"

namespace pelage {
namespace {

template <typename T>
void complete(std::vector<T>& values, std::size_t size, T missing) {
    if (!values.empty()) values.resize(size, missing);
}

void checkPlaces(const Source& source, const std::string& file) {
    for (const SourcePart& part : source.parts) {
        for (uint v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const mat4& matrix =
                source.vertexToWorld.empty() ? part.toWorld : source.vertexToWorld[v];
            const vec3 place = vec3(matrix * vec4(source.positions[v], 1.0f));
            const vec3 size = glm::abs(place);
            if (size.x <= kMaxCoordinate && size.y <= kMaxCoordinate && size.z <= kMaxCoordinate)
                continue;
            const bool finite =
                std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
            const std::string where = part.name.empty() ? "" : "mesh " + inQuotes(part.name) + ": ";
            throw std::runtime_error(
                file + ": " + where + "vertex " + std::to_string(v - part.firstVertex) +
                (finite ? " is more than 1e12 from the origin" : " is not at a finite place"));
        }
    }
}

}  // namespace

void finishSource(Source& source, const std::string& file) {
    if (source.triangles.empty()) throw std::runtime_error(file + ": holds no triangle");
    const std::size_t count = source.positions.size();
    complete(source.normals, count, vec3(0.0f));
    complete(source.uvs, count, vec2(0.0f));
    complete(source.colors, count, vec4(1.0f));
    complete(source.segmentOf, count, kNoSegment);
    complete(source.vertexToWorld, count, mat4(1.0f));
    if (source.fur) {
        complete(source.fur->length, count, 0.0f);
        complete(source.fur->density, count, 1.0f);
        complete(source.fur->direction, count, vec3(0.0f));
        complete(source.fur->tint, count, vec3(1.0f));
    }
    checkPlaces(source, file);
    for (const SourcePart& part : source.parts) {
        assert(part.firstVertex + part.vertexCount <= count);
        assert(part.firstTriangle + part.triangleCount <= source.triangles.size());
    }
}

bool isPicture(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.starts_with("\x89PNG") || text.starts_with("\xff\xd8\xff");
}

}  // namespace pelage
