// lod.h -- what a view needs of the fur: which clusters of hair, how many of their hairs, how fine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "detail.h"
#include "scatter.h"
#include "tuft.h"
#include "types.h"

namespace pelage {

// From where a frame is seen.
struct Sight {
    mat4 viewProjection{1.0f};  // world to clip, depth in [-1,1]
    vec3 eye{0.0f};
    vec3 forward{0.0f, 0.0f, -1.0f};  // unit
    float pixelsPerMetre = 0.0f;      // perspective: at distance 1 from the eye; else everywhere
    bool perspective = true;
    ivec2 size{0};  // pixels

    // By which widths at a place shrink: m along the view, 1 without perspective.
    float distanceTo(vec3 place) const;
};

// Where a ball lies in the window.
struct Outline {
    vec2 lower{0.0f}, upper{0.0f};  // pixels
    bool known = false;             // false where it reaches to the eye
};
Outline outlineOf(const Sight& sight, vec3 center, float radius);
// Of all that is within `reach` of a box.
Outline outlineOf(const Sight& sight, vec3 lower, vec3 upper, float reach);

// The farthest depth of the skin, tile by tile and in a pyramid over them.
class SkinDepth {
public:
    static constexpr int kTile = 8;  // pixels

    SkinDepth() = default;  // there is no skin
    // Of the window from `corner` (a multiple of kTile) on. A strip is one pixel wide and kTile
    // high; they come in rows of `width`.
    SkinDepth(ivec2 corner, int width, std::span<const float> strips);

    // True if the skin stands before this window depth in every pixel of a rectangle.
    bool hides(vec2 lower, vec2 upper, float depth) const;

private:
    struct Level {
        ivec2 size{0};
        std::vector<float> farthest;
    };
    ivec2 corner_{0};
    std::vector<Level> levels_;
};

// Clusters of which something may be seen, and how many are not.
struct InSight {
    struct Seen {
        uint cluster = 0;
        float distance = 1.0f;  // of its center, as Sight::distanceTo
        float nearest = 1.0f;   // of its nearest root
        float hairs = 0.0f;     // that grow where its density is greatest
        float pixels = 0.0f;    // length of its longest hair on the screen
    };
    std::vector<Seen> clusters;
    std::size_t outside = 0;  // of the view
    std::size_t hidden = 0;   // by the skin
    std::size_t bald = 0;
};

// Leaves out a cluster only if not one of its hairs, wherever it may reach, has its curve before
// the skin and in the window; without a skin only where no hair grows.
InSight lookAt(const Roots& roots, std::span<const Tuft> tufts, const Pelt& pelt,
               const Sight& sight, const SkinDepth* skin);

// Pixels by which edges may be off: what the rule asks for, or what a frame needs to keep to its
// time where that is more; 0 where nothing is asked.
float deviationOf(const Detail& detail, float needed);

// Straight pieces of the hairs.
struct Fineness {
    uint segments = 8;       // of a hair: so many, or at most so many where they adapt
    float tolerance = 0.3f;  // pixels by which chords may miss their curve
    bool adapts = false;     // to the tolerance
};
// What is asked for, where edges may be off by `deviation` pixels; `otherwise` is for rules that
// ask for nothing.
Fineness finenessOf(const Detail& detail, float deviation, const Fineness& otherwise);

// Share of the hairs that is drawn where hairs are `pixels` wide on average and `widest` at most.
float shareKept(const Detail& detail, float pixels, float widest, float deviation);

// How the hair that is seen is drawn.
struct Choice {
    struct Drawn {
        uint cluster = 0;
        float lod = 1.0f;     // share of its hairs, by which their widths are divided
        float fade = 1.0f;    // rank at which a hair of density 1 has faded out, >= lod
        uint hairs = 0;       // a prefix of its roots
        bool narrow = false;  // no hair is wide enough to look round
    };
    std::vector<Drawn> clusters;
    Fineness fineness;
    std::size_t small = 0;  // clusters so small on the screen that none of their hairs is drawn
    std::size_t hairs = 0;
    double work = 0.0;  // as workOf
};

// Pixels; a frame that is bound by time deviates no further.
constexpr float kMostDeviation = 8.0f;

// The detail that is asked for, coarsened until edges are off by `deviation` pixels.
Choice choose(const Roots& roots, const InSight& seen, const Sight& sight, const Pelt& pelt,
              const Detail& detail, float deviation, const Fineness& otherwise);

// What drawing costs, in units of one segment of a hair.
double workOf(const InSight& seen, const Sight& sight, const Pelt& pelt, const Detail& detail,
              float deviation, const Fineness& otherwise);
// The least deviation whose work is no more than `work`; kMostDeviation where there is none.
float deviationWithin(double work, const InSight& seen, const Sight& sight, const Pelt& pelt,
                      const Detail& detail, const Fineness& otherwise);

}  // namespace pelage
