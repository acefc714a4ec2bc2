// swatch.cpp -- the ball and its groom.
#include "swatch.h"

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

constexpr float kRadius = 0.13f;      // m
constexpr float kLength = 0.045f;     // m, about that of the animal's trunk
constexpr double kAnimalArea = 1.07;  // m^2, of the built-in animal

// A cube blown up to a ball; corners that faces share are equal to the bit.
Source ball() {
    constexpr uint kCells = 24;  // along each edge of the cube
    Source source;
    for (uint face = 0; face < 6; ++face) {
        const auto first = static_cast<uint>(source.positions.size());
        const float side = face < 3 ? 1.0f : -1.0f;
        const auto along = [&](uint i) {
            return static_cast<float>(2 * static_cast<int>(i) - static_cast<int>(kCells)) / kCells;
        };
        for (uint y = 0; y <= kCells; ++y) {
            for (uint x = 0; x <= kCells; ++x) {
                vec3 p;
                p[static_cast<int>(face % 3)] = side;
                p[static_cast<int>((face + 1) % 3)] = side * along(x);
                p[static_cast<int>((face + 2) % 3)] = along(y);
                source.positions.push_back(kRadius * glm::normalize(p));
            }
        }
        for (uint y = 0; y < kCells; ++y) {
            for (uint x = 0; x < kCells; ++x) {
                const uint a = first + y * (kCells + 1) + x, c = a + kCells + 1;
                source.triangles.insert(source.triangles.end(), {{a, a + 1, c + 1}, {a, c + 1, c}});
            }
        }
    }
    source.fileVertices = source.positions.size();
    source.materials.push_back({"skin", vec4(0.1f, 0.09f, 0.085f, 1.0f), -1});
    SourcePart part;
    part.material = 0;
    part.vertexCount = static_cast<uint>(source.positions.size());
    part.triangleCount = static_cast<uint>(source.triangles.size());
    source.parts.push_back(part);
    return source;
}

Document bareBall() {
    Document document;
    document.skin = makeSkin(ball());
    document.groom = initialGroom(*document.skin);
    for (std::size_t v = 0; v < document.groom.fur.size(); ++v)
        document.groom.fur.edit(v).furLength = kLength;
    return document;
}

}  // namespace

Document swatch(const Fur& fur) {
    static const Document ball = bareBall();
    Document document = ball;
    document.fur = fur;
    document.fur.skinColor = 0.0f;
    document.fur.hairs =
        static_cast<uint>(std::lround(fur.hairs * std::min(ball.skin->area / kAnimalArea, 1.0)));
    return document;
}

}  // namespace pelage
