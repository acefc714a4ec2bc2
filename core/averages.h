// averages.h -- the mean of the fur around a vertex: what the smooth tool tends to.
//
// Where vertices are sparse it is the mean over the one-ring. Where many lie within the reach it is
// the mean over the reach, so that a brush evens out a dense mesh as it does a coarse one. That
// mean is kept on a grid of points in space, each summing the vertices around it, separately for
// the six directions they may face, so that the two sides of a thin sheet do not mix (the ambient
// cube of McTaggart, Half-Life 2 / Valve Source Shading, GDC 2004, used for sums instead of light).
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "chunked.h"
#include "groom.h"
#include "skin_query.h"

namespace pelage {

// a + share x (b - a), channel by channel: what is the same in both keeps its bits.
FurVertex towards(const FurVertex& a, const FurVertex& b, float share);

class Averages {
public:
    // Of the groom as it was; `reach` in m, world, > 0. `query` must outlive this.
    Averages(const SkinQuery& query, Groom before, float reach);

    // The mean around vertex v, in the world. An even field has its own value as mean, bit for bit.
    // Sums the grid on the way, near v only; what was asked once costs nothing.
    const FurVertex& around(uint v);

private:
    // Of weight x value.
    struct Sum {
        double weight = 0.0, length = 0.0, density = 0.0;
        glm::dvec3 direction{0.0}, tint{0.0};

        void add(double share, const Sum& other);
    };
    using Cube = std::array<Sum, 6>;  // +x -x +y -y +z -z
    using Key = std::uint64_t;
    struct Mean {
        FurVertex fur{};
        bool known = false;
    };

    glm::ivec3 cellOf(vec3 position) const;
    void enter(glm::ivec3 cell);
    void sumCell(glm::ivec3 cell);
    FurVertex meanAround(uint v);

    const SkinQuery* query_;
    Groom before_;
    float reach_;
    std::unordered_map<Key, Cube> points_;  // of the grid, by the cell they are the least corner of
    std::unordered_set<Key> summed_;        // cells whose vertices are in
    bool inside_ = false;
    glm::ivec3 cell_{0};              // of the last vertex; neighbours in memory share it
    std::array<Cube*, 8> corners_{};  // its grid points
    std::vector<uint> found_;
    Chunked<Mean> means_;  // of each vertex
};

// The mean over the one-ring of v, in the world; the vertex's own values where it has no ring.
FurVertex ringMean(const Skin& skin, const Groom& groom, uint v);

}  // namespace pelage
