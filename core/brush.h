// brush.h -- strokes: how a brush that moves over the skin changes what is painted.
//
// The effect of a stroke is a function of the groom before it and of its coverage: at each vertex
// the largest falloff along the path. So it does not depend on how often the pointer was sampled,
// and overlaps do not add up. Comb sums directions along a path resampled at a fixed spacing; part
// and clump look at the nearest point of the path.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "averages.h"
#include "body.h"
#include "groom.h"
#include "skin_query.h"

namespace pelage {

enum class Tool {
    length,
    cut,
    density,
    comb,
    part,
    twist,
    clump,
    puff,
    flatten,
    smooth,
    tint,
    mask,
    segment
};
inline constexpr std::size_t kToolCount = 13;
enum class Mode { add, subtract, set };
enum class Falloff { smooth, linear, sharp, constant };

// Row of the tool table: what buttons, keys, scripts and help are made from.
struct ToolInfo {
    Tool tool;
    const char* name;      // in scripts: "length"
    const char* label;     // in the panel: "Length"
    const char* help;      // one sentence
    const char* add;       // what Mode::add and Mode::subtract do, in a word or two; null where the
    const char* subtract;  // tool works one way only
    bool hasSet;           // Mode::set tends to Brush::value
    bool ofLength;         // the value is in m, else from 0 to 1
    bool needsPath;        // works by where the stroke went: no flood
    float least, greatest;  // of Brush::value; lengths: in multiples of the skin's size
};
std::span<const ToolInfo> tools();
const ToolInfo& toolInfo(Tool tool);
std::span<const char* const> modeNames();     // in scripts, in the order of Mode
std::span<const char* const> falloffNames();  // in the order of Falloff

struct Brush {
    Tool tool = Tool::comb;
    Mode mode = Mode::add;
    Falloff falloff = Falloff::smooth;
    float radius = 0.05f;   // m, world, > 0; below 1/1000 of the skin's size it counts as that
    float strength = 0.5f;  // [0,1]
    float value = 0.0f;     // for Mode::set: m (length, cut) or [0,1] (density, mask)
    vec3 color{1.0f};       // of tint: linear RGB, each in [0,1]
    std::string segment{};  // that segment paints, as segmentNamed takes it (body.h); empty = none
    bool mirrorX = false;   // the same on the other side of the skin's own x = 0 plane (world)
    bool facingOnly =
        true;  // skip vertices whose normal points away from the skin under the cursor
};

struct Touching;  // tools.h

// Weight of a vertex at `distance` from the middle of a brush, [0,1]; 1 at 0, 0 from radius on.
float falloffWeight(Falloff falloff, float distance, float radius);

// A stroke in progress: make it at press, dab it at every move, keep the groom's edit at release.
class Stroke {
public:
    // `before` is the groom when the pointer went down. `query` must outlive the stroke. Throws
    // std::runtime_error where the brush names a body segment that is not there.
    Stroke(const SkinQuery& query, Groom before, Brush brush);

    // Covers the path from the last point to this one (the first call: the point alone) and writes
    // the touched vertices of `groom`. `normal` is that of the skin under the cursor. Cost grows
    // with the footprint and not with the mesh. A mirrored brush dabs both sides. Points that are
    // not finite or farther than two sizes from the middle of the skin are no part of the path.
    void dab(Groom& groom, vec3 position, vec3 normal);

    const Brush& brush() const { return brush_; }

    // The stroke as one script line, without its newline: it can be replayed bit for bit.
    std::string line() const;

private:
    struct Sample {
        vec3 position, normal;
    };
    // What the path so far did to a vertex.
    struct Touch {
        vec3 combed{0.0f};      // sum of weight x direction of the path, world
        float coverage = 0.0f;  // [0,1] largest falloff along the path
        float mirrored = 0.0f;  // the same of the path's mirror image
        float nearest = std::numeric_limits<float>::infinity();  // m, from the path
        float ties = 0.0f;  // how many points of the path are that near
        vec3 offset{0.0f};  // sum of the ways from them to the vertex, m, world
    };
    // A stretch of the path that is short enough for one radius query.
    struct Piece {
        Sample from, to;
        std::vector<Sample> steps;  // of the comb; `normal` holds the direction of the path there
        bool mirrored = false;
    };

    float radius() const;
    static void mirror(Sample& sample);
    std::vector<Sample> combSteps(vec3 from, vec3 to);
    void cover(Groom& groom, const Piece& piece);
    bool touch(const SkinVertex& vertex, const Piece& piece, Touch& touched) const;
    Touching touching(uint v, const Touch& touched);

    const SkinQuery* query_;
    Groom before_;
    Brush brush_;
    Chunked<Touch> touched_;            // one per skin vertex
    std::optional<Averages> averages_;  // of smooth
    std::vector<Sample> samples_;       // as they came
    vec3 lastStep_{0.0f};               // last place at which the comb looked at its direction
    double sinceStep_ = 0.0;            // m of path since then
    std::vector<uint> found_;           // kept between dabs for its memory

    std::optional<SegmentPaint> segments_;  // of segment
};

// The same tool over the entire skin at full coverage; masked vertices keep their values by the
// share of the mask. For comb: `direction` (world) is laid onto the tangent plane of each vertex.
// Smooth evens out as a stroke does, over 1/40 of the skin's size or over one-rings where those are
// wider (averages.h), so that its effect hardly depends on how dense the mesh is. A tool that needs
// a path does nothing.
void flood(const SkinQuery& query, Groom& groom, const Brush& brush, vec3 direction = vec3(0.0f));

// Takes back all that the tool's channels were painted with: length, density and direction as in
// initialGroom, tint 1, mask 0, segments of the source; smooth stands for all that it evens out.
// Masked vertices keep their values by the share of the mask.
void reset(const Skin& skin, Groom& groom, Tool tool);

}  // namespace pelage
