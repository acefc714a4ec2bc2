// shell_map.h -- tiles that say how high hair stands at each place, and whose it is: what layers of
// fur are cut from.
//
// A layer at t, a share of the hair's length in (0,1], is the places where hair reaches up to t:
// the hair cut at that height. A hair that tapers is a cone, and the higher it is cut the fewer
// places it holds. Tiles repeat without a seam. After Papaioannou, "A Simple and Fast Technique for
// Fur Rendering", whose opacity maps these layers are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image.h"

namespace pelage {

struct ShellTexel {
    std::uint16_t height = 0;  // 0 = bare, else hair stands up to height/65535 of its length
    std::uint16_t id = 0;      // of the hair, uniform: a share s of all hairs are below 65536 s
};

// Whether there is hair at the height t in (0,1].
inline bool reaches(ShellTexel texel, float t) {
    return texel.height > 0 && static_cast<float>(texel.height) >= 65535.0f * t;
}

struct ShellLevel {
    ivec2 size{0};
    std::vector<ShellTexel> texels;  // rows from the top
};

// Share of the texels that hair covers at the height t.
double coverage(const ShellLevel& level, float t);

// The tile, then ever smaller ones for the distance, down to one texel. Averages alone would make
// fur bald from afar, so that the averages of each level are only put in order, and the heights of
// the tile dealt out in that order: every layer of every level covers what it covers in the tile,
// to half a texel of its level. An id is that of the highest hair below.
struct ShellMap {
    std::vector<ShellLevel> levels;
};

// Half of each side, rounded down, at least 1: the size of the next level, as OpenGL has it.
ivec2 halfSize(ivec2 size);

// Texels of all levels.
std::size_t texelsWithLevels(ivec2 size);

// How the hairs of a picture thin out: the layer at t covers coverage x (1 - taper t)^2.
struct ShellCut {
    float coverage = 0.5f;  // at the root, (0,1]
    float taper = 1.0f;     // [0,1]; 1 = to a point

    bool operator==(const ShellCut&) const = default;
};

// Round hairs of one size, straight up from roots that are spread evenly over the tile; so are
// those of the lowest ids, whatever share of all they are.
struct HairPattern {
    uint seed = 1;
    int side = 256;         // texels, 1 to 8192
    uint hairs = 1024;      // 1 to 65536
    float radius = 0.012f;  // at the root, as a share of the tile, (0,0.5]
    float taper = 1.0f;     // [0,1]; 1 = to a point
};

// A layer is the discs of radius x (1 - taper t) around the roots; a place in several of them
// belongs to the nearest root.
ShellMap hairMap(const HairPattern& pattern);

// The two hairs whose roots are nearest to the middle of a texel, by number; the same one twice
// where there is only one. Number h of n has the id (2 h + 1) 32768 / n.
struct RootTexel {
    std::uint16_t nearest = 0, next = 0;
};

// What a ray asks to test the exact shape of hairs. With two texels across a hair at its root, the
// two nearest roots of the texels on the way leave out less than 0.001 of what hairs cover (at
// optical depths around 1), and heights more than 0.03 at 45 degrees: tips are finer than texels.
struct RootMap {
    ivec2 size{0};
    std::vector<RootTexel> texels;  // rows from the top
    std::vector<vec2> roots;        // by number, in tiles, [0,1)^2; y goes down
};
RootMap rootMap(const HairPattern& pattern);

// A random grey picture of 8 bits, each place averaged with those around it, over the edge too;
// [0,1]. The same on every machine.
struct NoisePattern {
    uint seed = 1;
    int side = 256;        // texels, 1 to 8192
    int mask = 5;          // texels of each side of the averaging mask: 1, 3, 5, 7 or 9
    bool weighted = true;  // binomial weights; else all alike

    bool operator==(const NoisePattern&) const = default;
};
Plane noisePicture(const NoisePattern& pattern);

// Any picture, bright where hair is long. Only the order of its values counts, so that the layers
// cover exactly what the cut says, to half a texel; equal values come in an order of chance. Each
// peak of the picture is one hair, and owns the places from which the steepest way up leads to it.
ShellMap rankedMap(const Plane& picture, const ShellCut& cut, uint seed);

// The values of the picture as heights, clamped to [0,1]; 0 and NaN are bare. Hairs as above.
ShellMap rawMap(const Plane& picture, uint seed);

}  // namespace pelage
