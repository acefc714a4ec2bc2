// animal.cpp -- the built-in animal as a source, as if it had been read from a file.
#include "animal.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "animal_shape.h"

namespace pelage {
namespace {

constexpr std::size_t kLeast = 2000, kMost = 2000000;

// The segment of the piece that lies nearest, on the vertex's side of the body.
uint segmentAt(const animal::Shape& shape, vec3 p) {
    const animal::Part& part = *shape.blend(vec3(std::abs(p.x), p.y, p.z)).nearest;
    return part.segment + (part.sided && p.x < 0.0f ? 1u : 0u);
}

}  // namespace

Source makeAnimal(std::size_t triangles) {
    if (triangles < kLeast || triangles > kMost) {
        throw std::runtime_error("animal: " + std::to_string(triangles) +
                                 " triangles wanted, from " + std::to_string(kLeast) + " to " +
                                 std::to_string(kMost) + " can be made");
    }
    const animal::Surface surface = animal::polygonise(triangles);
    const animal::Shape shape(surface.cell);
    animal::Atlas atlas = animal::unwrap(surface);

    Source source;
    source.images.push_back({"animal", animal::paintPicture(shape, surface, atlas)});
    source.materials.push_back({"animal", vec4(1.0f), 0});
    source.segments = animal::bodySegments();
    std::vector<uint> segments(surface.positions.size());
    tbb::parallel_for(std::size_t(0), segments.size(),
                      [&](std::size_t v) { segments[v] = segmentAt(shape, surface.positions[v]); });
    for (const uint v : atlas.vertexOf) {
        source.positions.push_back(surface.positions[v]);
        source.normals.push_back(surface.normals[v]);
        source.segmentOf.push_back(segments[v]);
    }
    source.uvs = std::move(atlas.uvs);
    source.triangles = std::move(atlas.triangles);
    source.fileVertices = source.positions.size();
    SourcePart part;
    part.name = "animal";
    part.vertexCount = uint(source.positions.size());
    part.triangleCount = uint(source.triangles.size());
    part.material = 0;
    source.parts.push_back(part);
    return source;
}

}  // namespace pelage
