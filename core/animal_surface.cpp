// animal_surface.cpp -- the animal's solid as triangles, on a lattice fine enough for their count.
//
// Marching tetrahedra on a body-centred cubic lattice: every edge of the lattice carries at most
// one vertex and the tetrahedra fill space, so the mesh is closed and manifold whatever the solid.
// The lattice covers x >= 0 and has a flat wall at x = 0; the mirror image is the other half.
// Lattice points have doubled integer coordinates: all even (corners), all odd (centers), or
// x = 0 with odd y and z (middles of the wall's faces).
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "animal_half.h"
#include "animal_shape.h"

namespace pelage::animal {
namespace {

constexpr int kBlock = 8;  // cells along the edge of a block
constexpr int kSamples = kBlock + 1;
constexpr float kOutside = 1e3f;         // value of a lattice point that is far from the surface
constexpr float kTrianglesAt1 = 17.35f;  // triangles * cell^2, m^2, of this animal; a first guess

struct Point {
    int x, y, z;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

// A vertex of the mesh by the lattice edge it lies on: the sum of the edge's ends names the edge.
using EdgeKey = std::uint64_t;
EdgeKey edgeKey(Point a, Point b) {
    const Point sum = a + b;
    return (EdgeKey(sum.z + 4) << 42) | (EdgeKey(sum.y + 4) << 21) | EdgeKey(sum.x + 4);
}

struct Edge {
    Point a, b;
};

// The ends of the edge, from their sum alone; parity tells which kind of edge it is.
Edge edgeOf(EdgeKey key) {
    constexpr EdgeKey kMask = (EdgeKey(1) << 21) - 1;
    const int sum[3] = {int(key & kMask) - 4, int((key >> 21) & kMask) - 4, int(key >> 42) - 4};
    int a[3], b[3];
    const auto split = [&](int axis) {  // into an even and an odd number that differ by 1
        const int half = (sum[axis] - 1) / 2;
        a[axis] = half % 2 == 0 ? half : half + 1;
        b[axis] = sum[axis] - a[axis];
    };
    const bool oddY = sum[1] % 2 != 0;
    if (oddY && sum[0] != 0) {  // corner to center
        for (int axis = 0; axis < 3; ++axis) split(axis);
    } else if (oddY) {  // along the wall
        a[0] = b[0] = 0;
        split(1);
        split(2);
    } else if (sum[0] == 1) {  // from the wall to a center
        a[0] = 0;
        b[0] = 1;
        for (const int axis : {1, 2}) a[axis] = b[axis] = sum[axis] / 2;
    } else {  // two corners or two centers along an axis: the one whose half has another parity
        const int odd =
            std::abs(sum[0] / 2 % 2) + std::abs(sum[1] / 2 % 2) + std::abs(sum[2] / 2 % 2);
        const int wanted = odd == 1 ? 1 : 0;
        for (int axis = 0; axis < 3; ++axis) {
            const int half = sum[axis] / 2;
            const int step = std::abs(half % 2) == wanted ? 1 : 0;
            a[axis] = half - step;
            b[axis] = half + step;
        }
    }
    return {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}};
}

constexpr float kHeadCell = 0.6f;  // size of a cell at the head; 1 at the trunk

// A coordinate that runs evenly before `from`, and kHeadCell times as fast after from + 0.14 m.
float squeezed(float u, float from) {
    constexpr float kWay = 0.14f;
    const float t = std::clamp((u - from) / kWay, 0.0f, 1.0f);
    const float after = std::max(u - from - kWay, 0.0f);
    return std::min(u, from) + kWay * (t - 0.5f * (1.0f - kHeadCell) * t * t) + kHeadCell * after;
}

// Where the lattice lies in space. Shifted a little, so that flat paws meet no lattice plane, and
// denser at the head (high and in front), which has the finest shapes.
struct Lattice {
    const Shape* shape;
    float cell;  // m, the largest
    vec3 origin() const { return vec3(0.0f, kLower.y - 1.37f * cell, kLower.z - 1.21f * cell); }
    vec3 place(Point p) const {
        const vec3 u = origin() + 0.5f * cell * vec3(float(p.x), float(p.y), float(p.z));
        return {u.x, squeezed(u.y, 0.42f), squeezed(u.z, 0.10f)};
    }
    float value(Point p) const { return shape->sample(place(p)).distance; }
};

// The solid's values in one block of cells, and the triangles that cross it.
class BlockMarcher {
public:
    // `first` is the block's first cell. Only cells near the surface are evaluated.
    BlockMarcher(const Lattice& lattice, Point first) : lattice_(lattice), first_(first) {
        corners_.fill(kOutside);
        centers_.fill(kOutside);
        // Cells in which no point can lie on the surface keep kOutside at their center.
        const float reach = Shape::kLipschitz * 1.75f * lattice_.cell;
        for (int z = -1; z < kBlock; ++z) {
            for (int y = -1; y < kBlock; ++y) {
                for (int x = -1; x < kBlock; ++x) {
                    if (first_.x + x < 0) continue;
                    const float value = lattice_.value(center(x, y, z));
                    if (std::abs(value) > reach) continue;
                    centers_[index(x + 1, y + 1, z + 1)] = value;
                }
            }
        }
    }

    void march(std::vector<EdgeKey>& triangles) {
        for (int z = 0; z < kBlock; ++z) {
            for (int y = 0; y < kBlock; ++y) {
                for (int x = 0; x < kBlock; ++x) {
                    if (centers_[index(x + 1, y + 1, z + 1)] == kOutside) continue;
                    for (int axis = 0; axis < 3; ++axis) face(x, y, z, axis, triangles);
                }
            }
        }
    }

private:
    static std::size_t index(int x, int y, int z) {
        return std::size_t((z * kSamples + y) * kSamples + x);
    }
    Point corner(int x, int y, int z) const {
        return {2 * (first_.x + x), 2 * (first_.y + y), 2 * (first_.z + z)};
    }
    Point center(int x, int y, int z) const { return corner(x, y, z) + Point{1, 1, 1}; }
    float cornerValue(int x, int y, int z) {
        float& value = corners_[index(x, y, z)];
        if (value == kOutside) value = lattice_.value(corner(x, y, z));
        return value;
    }

    struct Corner {
        Point point;
        float value;
    };

    // The four tetrahedra around the face at the low end of a cell along an axis.
    void face(int x, int y, int z, int axis, std::vector<EdgeKey>& triangles) {
        const Corner here{center(x, y, z), centers_[index(x + 1, y + 1, z + 1)]};
        Corner there;
        if (axis == 0 && first_.x + x == 0) {
            there.point = here.point + Point{-1, 0, 0};
            there.value = lattice_.value(there.point);
        } else {
            const int dx = axis == 0, dy = axis == 1, dz = axis == 2;
            there.point = here.point + Point{-2 * dx, -2 * dy, -2 * dz};
            there.value = centers_[index(x + 1 - dx, y + 1 - dy, z + 1 - dz)];
            if (there.value == kOutside) return;
        }
        // The face's corners in circular order, seen from the cell behind it.
        constexpr int kRing[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        std::array<Corner, 4> ring;
        for (std::size_t i = 0; i < 4; ++i) {
            int step[3] = {0, 0, 0};
            step[(axis + 1) % 3] = kRing[i][0];
            step[(axis + 2) % 3] = kRing[i][1];
            const int cx = x + step[0], cy = y + step[1], cz = z + step[2];
            ring[i] = {corner(cx, cy, cz), cornerValue(cx, cy, cz)};
        }
        for (std::size_t i = 0; i < 4; ++i) {
            tetrahedron({there, here, ring[i], ring[(i + 1) % 4]}, triangles);
        }
    }

    // Corners such that the last three turn counter-clockwise seen from outside, opposite the
    // first.
    static void tetrahedron(const std::array<Corner, 4>& t, std::vector<EdgeKey>& triangles) {
        std::array<std::size_t, 4> in{}, out{};
        std::size_t ins = 0, outs = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (t[i].value < 0.0f) {
                in[ins++] = i;
            } else {
                out[outs++] = i;
            }
        }
        if (ins == 0 || outs == 0) return;
        const auto key = [&](std::size_t i, std::size_t j) {
            return edgeKey(t[i].point, t[j].point);
        };
        const auto emit = [&](EdgeKey a, EdgeKey b, EdgeKey c, bool turned) {
            triangles.push_back(a);
            triangles.push_back(turned ? c : b);
            triangles.push_back(turned ? b : c);
        };
        // Parity of the permutation (lone, rest...) decides the turn.
        if (ins == 1 || outs == 1) {
            const std::size_t lone = ins == 1 ? in[0] : out[0];
            const auto& rest = ins == 1 ? out : in;
            const bool turned = (lone % 2 == 1) != (outs == 1);
            emit(key(lone, rest[0]), key(lone, rest[1]), key(lone, rest[2]), turned);
            return;
        }
        // Two and two: a quad whose corners lie on the four mixed edges.
        const std::size_t order = in[0] * 4 + in[1];
        const bool turned = order == 0 * 4 + 2 || order == 1 * 4 + 3;
        const EdgeKey a = key(in[0], out[0]), b = key(in[0], out[1]), c = key(in[1], out[1]),
                      d = key(in[1], out[0]);
        emit(a, b, c, turned);
        emit(a, c, d, turned);
    }

    const Lattice& lattice_;
    Point first_;
    std::array<float, kSamples * kSamples * kSamples> corners_, centers_;  // centers from cell -1
};

// Every block of cells that the surface may cross, in a fixed order.
std::vector<Point> blocksNearSurface(const Lattice& lattice) {
    const float edge = float(kBlock) * lattice.cell;
    const vec3 extent = (kLower + (kUpper - kLower) / kHeadCell - lattice.origin()) / edge;
    const Point count{int(extent.x) + 1, int(extent.y) + 1, int(extent.z) + 1};
    // Whether a cube of blocks, 2^level along an edge, can hold a part of the surface.
    const auto mayCross = [&](Point p, int level) {
        const int size = kBlock * (1 << level);
        const Point first{2 * kBlock * p.x, 2 * kBlock * p.y, 2 * kBlock * p.z};
        const vec3 lower = lattice.place(first);
        const vec3 upper = lattice.place(first + Point{2 * size, 2 * size, 2 * size});
        const float reach = Shape::kLipschitz * 0.5f * glm::length(upper - lower);
        const float value = lattice.shape->sample(0.5f * (lower + upper)).distance;
        return std::abs(value) < reach + 2.0f * lattice.cell;
    };
    int level = 0;
    while ((1 << level) < std::max({count.x, count.y, count.z})) ++level;
    std::vector<Point> blocks{{0, 0, 0}};
    for (; level >= 0; --level) {
        std::vector<Point> kept;
        for (const Point& p : blocks) {
            if (p.x >= count.x || p.y >= count.y || p.z >= count.z || !mayCross(p, level)) continue;
            if (level == 0) {
                kept.push_back(p);
                continue;
            }
            const int half = 1 << (level - 1);
            for (int child = 0; child < 8; ++child) {
                kept.push_back(
                    p + Point{(child & 1) * half, (child >> 1 & 1) * half, (child >> 2) * half});
            }
        }
        blocks = std::move(kept);
    }
    return blocks;
}

// Three edges of the lattice for each triangle of the half x >= 0.
std::vector<EdgeKey> marchHalf(const Lattice& lattice) {
    const std::vector<Point> blocks = blocksNearSurface(lattice);
    std::vector<std::vector<EdgeKey>> found(blocks.size());
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t i) {
        const Point& p = blocks[i];
        BlockMarcher(lattice, {p.x * kBlock, p.y * kBlock, p.z * kBlock}).march(found[i]);
    });
    std::vector<EdgeKey> all;
    for (const auto& keys : found) all.insert(all.end(), keys.begin(), keys.end());
    return all;
}

// Vertices in the order of their edges, so that the mesh is the same on every machine.
Half connect(const Lattice& lattice, const std::vector<EdgeKey>& corners) {
    struct Use {
        EdgeKey key;
        uint corner;
        bool operator<(const Use& other) const {
            return key != other.key ? key < other.key : corner < other.corner;
        }
    };
    std::vector<Use> uses(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) uses[i] = {corners[i], uint(i)};
    tbb::parallel_sort(uses.begin(), uses.end());
    Half half;
    half.triangles.resize(corners.size() / 3);
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (i == 0 || uses[i].key != uses[i - 1].key) edges.push_back(edgeOf(uses[i].key));
        half.triangles[uses[i].corner / 3][int(uses[i].corner % 3)] = uint(edges.size() - 1);
    }
    half.positions.resize(edges.size());
    half.onWall.resize(edges.size());
    for (std::size_t v = 0; v < edges.size(); ++v) {
        half.onWall[v] = edges[v].a.x == 0 && edges[v].b.x == 0;
    }
    tbb::parallel_for(std::size_t(0), edges.size(), [&](std::size_t v) {
        const float a = lattice.value(edges[v].a), b = lattice.value(edges[v].b);
        const float t = std::clamp(a / (a - b), 0.02f, 0.98f);
        half.positions[v] = (1.0f - t) * lattice.place(edges[v].a) + t * lattice.place(edges[v].b);
    });
    return half;
}

}  // namespace

Surface polygonise(std::size_t triangles) {
    // The count goes with 1/cell^2 but for details that the coarsest lattices miss.
    float cell = std::sqrt(kTrianglesAt1 / float(triangles));
    for (int attempt = 0;; ++attempt) {
        const Shape shape(cell);
        const Lattice lattice{&shape, cell};
        const std::vector<EdgeKey> corners = marchHalf(lattice);
        const float made = float(corners.size() / 3 * 2);
        const float excess = made / float(triangles);
        if ((excess > 0.95f && excess < 1.05f) || attempt == 12) {
            Half half = connect(lattice, corners);
            relax(shape, half, cell);
            return mirrored(std::move(half), cell);
        }
        cell *= std::sqrt(excess);
    }
}

}  // namespace pelage::animal
