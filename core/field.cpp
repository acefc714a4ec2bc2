// field.cpp -- the built-in field as a source, as if it had been read from a file, and its grass.
#include "field.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "strand.h"

namespace pelage {
namespace {

constexpr std::size_t kLeast = 2000, kMost = 2000000;
constexpr float kSide = 2.0f;   // m
constexpr float kHigh = 0.1f;   // m
constexpr float kFall = 0.15f;  // m, at the middle of an edge

float groundAt(float x, float z) {
    const float hills = 0.9f * spaceNoise({0.9f * x + 0.4f, 0.3f, 0.9f * z + 0.4f});
    const float x3 = x * x * x, z3 = z * z * z;
    return kHigh * (hills + 0.1f * spaceNoise({2.3f * x, 7.3f, 2.3f * z})) -
           kFall * (x3 * x3 + z3 * z3);
}

vec3 normalAt(float x, float z) {
    constexpr float kStep = 0.01f;
    const float slopeX = (groundAt(x + kStep, z) - groundAt(x - kStep, z)) / (2.0f * kStep);
    const float slopeZ = (groundAt(x, z + kStep) - groundAt(x, z - kStep)) / (2.0f * kStep);
    return glm::normalize(vec3(-slopeX, 1.0f, -slopeZ));
}

// Grass grows longer in some places, and leans somewhere everywhere.
FurVertex grassAt(vec3 p, vec3 n) {
    const float patch = spaceNoise({1.7f * p.x, 20.0f, 1.7f * p.z});
    const float tuft = spaceNoise({6.0f * p.x, 30.0f, 6.0f * p.z});
    const vec3 aside(spaceNoise({2.5f * p.x, 40.0f, 2.5f * p.z}), 0.0f,
                     spaceNoise({2.5f * p.x, 50.0f, 2.5f * p.z}));
    const float dry = 0.5f + 0.5f * spaceNoise({1.3f * p.x, 60.0f, 1.3f * p.z});
    FurVertex fur;
    fur.direction = 0.8f * (aside - glm::dot(aside, n) * n);
    fur.furLength = 0.08f * (1.0f + 0.35f * patch + 0.25f * tuft);
    fur.tint = glm::mix(vec3(0.6f, 0.85f, 0.6f), vec3(1.0f, 0.95f, 0.7f), dry);
    fur.density = 1.0f;
    return fur;
}

}  // namespace

Source makeField(std::size_t triangles) {
    if (triangles < kLeast || triangles > kMost) {
        throw std::runtime_error("field: " + std::to_string(triangles) +
                                 " triangles wanted, from " + std::to_string(kLeast) + " to " +
                                 std::to_string(kMost) + " can be made");
    }
    const auto cells =
        static_cast<uint>(std::lround(std::sqrt(static_cast<double>(triangles) / 2)));
    Source source;
    for (uint row = 0; row <= cells; ++row) {
        for (uint column = 0; column <= cells; ++column) {
            const vec2 uv = vec2(column, row) / static_cast<float>(cells);
            const vec2 place = kSide * (uv - 0.5f);
            source.positions.emplace_back(place.x, groundAt(place.x, place.y), place.y);
            source.normals.push_back(normalAt(place.x, place.y));
            source.uvs.push_back(uv);
        }
    }
    for (uint row = 0; row < cells; ++row) {
        for (uint column = 0; column < cells; ++column) {
            const uint a = row * (cells + 1) + column, b = a + 1, c = a + cells + 1, d = c + 1;
            source.triangles.emplace_back(a, c, b);
            source.triangles.emplace_back(b, c, d);
        }
    }
    source.materials.push_back({"earth", vec4(0.11f, 0.075f, 0.045f, 1.0f), -1});
    source.fileVertices = source.positions.size();
    SourcePart part;
    part.name = "field";
    part.vertexCount = static_cast<uint>(source.positions.size());
    part.triangleCount = static_cast<uint>(source.triangles.size());
    part.material = 0;
    source.parts.push_back(part);
    return source;
}

Document groomedField(std::size_t triangles) {
    Document document;
    document.skin = makeSkin(makeField(triangles));
    document.groom = evenGroom(*document.skin, kBareFur);
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const SkinVertex& skin = document.skin->vertices[v];
        document.groom.fur.edit(v) = grassAt(skin.position, skin.normal);
    }
    document.fur = defaultFur();
    applyPreset(document.fur, presetNamed("grass"));
    return document;
}

}  // namespace pelage
