// test_skins.h -- small skins made by code, and a number stream, for tests that paint and query.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/document.h"
#include "core/skin.h"
#include "core/strand.h"

namespace pelage::test {

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// Of the fur and the mask.
inline bool sameBits(const Groom& a, const Groom& b) {
    if (a.fur.size() != b.fur.size()) return false;
    for (std::size_t v = 0; v < a.fur.size(); ++v)
        if (std::memcmp(&a.fur[v], &b.fur[v], sizeof(FurVertex)) != 0 ||
            std::memcmp(&a.mask[v], &b.mask[v], sizeof(float)) != 0)
            return false;
    return true;
}

// The source of one mesh whose mesh space is the world moved by `toWorld`.
inline Source oneMesh(std::vector<vec3> positions, std::vector<uvec3> triangles,
                      mat4 toWorld = mat4(1.0f)) {
    Source source;
    source.positions = std::move(positions);
    source.triangles = std::move(triangles);
    source.fileVertices = source.positions.size();
    SourcePart part;
    part.name = "test";
    part.vertexCount = static_cast<uint>(source.positions.size());
    part.triangleCount = static_cast<uint>(source.triangles.size());
    part.toWorld = toWorld;
    source.parts.push_back(part);
    return source;
}

// A square sheet of 2 x cells x cells triangles with side 1 m in the plane y = height, looking up
// (or down), its middle at x = z = 0. Mirror-symmetric in x as a set of vertices.
inline void addSheet(std::vector<vec3>& positions, std::vector<uvec3>& triangles, uint cells,
                     float height, bool up) {
    const uint first = static_cast<uint>(positions.size());
    const float half = 0.5f * static_cast<float>(cells);
    for (uint z = 0; z <= cells; ++z)
        for (uint x = 0; x <= cells; ++x)
            positions.emplace_back((static_cast<float>(x) - half) / static_cast<float>(cells),
                                   height,
                                   (static_cast<float>(z) - half) / static_cast<float>(cells));
    for (uint z = 0; z < cells; ++z) {
        for (uint x = 0; x < cells; ++x) {
            const uint a = first + z * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
            triangles.push_back(up ? uvec3(a, c, b) : uvec3(a, b, c));
            triangles.push_back(up ? uvec3(b, c, d) : uvec3(b, d, c));
        }
    }
}

inline Source sheet(uint cells, mat4 toWorld = mat4(1.0f)) {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    addSheet(positions, triangles, cells, 0.0f, true);
    return oneMesh(std::move(positions), std::move(triangles), toWorld);
}

// Two sheets back to back, `gap` apart: an ear.
inline Source twoSheets(uint cells, float gap) {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    addSheet(positions, triangles, cells, 0.5f * gap, true);
    addSheet(positions, triangles, cells, -0.5f * gap, false);
    return oneMesh(std::move(positions), std::move(triangles));
}

// A ball of radius 1 m with 20 x 4^times triangles. Mirror-symmetric in x, y and z.
inline Source ball(int times) {
    const float g = 0.5f * (1.0f + std::sqrt(5.0f));
    std::vector<vec3> p{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                        {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<uvec3> t{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                         {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                         {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                         {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (vec3& v : p) v = glm::normalize(v);
    for (int i = 0; i < times; ++i) {
        std::map<std::pair<uint, uint>, uint> middles;
        auto middle = [&](uint a, uint b) {
            const auto [at, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<uint>(p.size()));
            if (fresh) p.push_back(glm::normalize(p[a] + p[b]));
            return at->second;
        };
        std::vector<uvec3> finer;
        for (const uvec3 f : t) {
            const uint ab = middle(f.x, f.y), bc = middle(f.y, f.z), ca = middle(f.z, f.x);
            finer.insert(finer.end(), {{f.x, ab, ca}, {f.y, bc, ab}, {f.z, ca, bc}, {ab, bc, ca}});
        }
        t = std::move(finer);
    }
    return oneMesh(std::move(p), std::move(t));
}

// A groom that is the same at every vertex.
inline Groom evenGroom(const Skin& skin,
                       FurVertex fur = {vec3(0.0f, 0.0f, 0.5f), 0.04f, vec3(1.0f), 0.5f}) {
    return pelage::evenGroom(skin, fur);
}

inline Document evenDocument(Source source) {
    Document document;
    document.skin = makeSkin(std::move(source));
    document.groom = evenGroom(*document.skin);
    document.fur = defaultFur();
    return document;
}

// A stream of numbers that is the same on every machine.
class Draws {
public:
    explicit Draws(uint seed) : state_(pcg(seed)) {}
    uint below(uint bound) { return (state_ = pcg(state_ + 1)) % bound; }
    float in(float least, float greatest) {
        return least + (greatest - least) * static_cast<float>(below(1u << 20)) /
                           static_cast<float>(1u << 20);
    }
    vec3 inBox(float half) { return {in(-half, half), in(-half, half), in(-half, half)}; }

private:
    uint state_;
};

}  // namespace pelage::test
