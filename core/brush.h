// brush.h -- strokes: how a brush that moves over the skin changes what is painted.
//
// The effect of a stroke is a function of the groom before it and of its coverage: at each vertex
// the largest falloff x pressure along the path. So it does not depend on how often the pointer was
// sampled, and overlaps do not add up. Comb sums directions along a path resampled at a fixed
// spacing; part and clump look at the nearest point of the path.
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
#include "brush_path.h"
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
enum class Mode { add, subtract, set, scale };
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
    bool hasScale;         // Mode::scale tends to Brush::factor times what was there
    bool ofLength;         // the value is in m, else from 0 to 1
    bool needsPath;        // works by where the stroke went: no flood
    float least, greatest;  // of Brush::value; lengths: in multiples of the skin's size
};
std::span<const ToolInfo> tools();
const ToolInfo& toolInfo(Tool tool);
std::span<const char* const> modeNames();     // in scripts, in the order of Mode
std::span<const char* const> falloffNames();  // in the order of Falloff

inline constexpr float kGreatestFactor = 10.0f;  // by which a brush scales

struct Brush {
    Tool tool = Tool::comb;
    Mode mode = Mode::add;
    Falloff falloff = Falloff::smooth;
    float radius = 0.05f;   // m, world, > 0; below 1/1000 of the skin's size it counts as that
    float strength = 0.5f;  // [0,1]
    float value = 0.0f;     // for Mode::set: m (length, cut) or [0,1] (density, mask)
    float factor = 0.5f;    // for Mode::scale: [0, kGreatestFactor]
    vec3 color{1.0f};       // of tint: linear RGB, each in [0,1]
    std::string segment{};  // that segment paints, as segmentNamed takes it (body.h); empty = none
    // The same on the other sides of the planes x = 0, y = 0 and z = 0 of the skin's own space: up
    // to eight images of the path, each moved onto the nearest skin (brush_path.h).
    glm::bvec3 mirror{false};
    // Distances are along the skin, so that an ear is not painted with the head behind it; else in
    // a straight line.
    bool alongSurface = true;
    // Skip vertices whose normal points away from the skin under the cursor.
    bool facingOnly = true;
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
    // the touched vertices of `groom`. `normal` is that of the skin under the cursor. `pressure`,
    // [0,1], scales the coverage; between two points it changes evenly. Cost grows with the
    // footprint and not with the mesh. Points that are not finite or farther than two sizes from
    // the middle of the skin are no part of the path.
    void dab(Groom& groom, vec3 position, vec3 normal, float pressure = 1.0f);

    const Brush& brush() const { return brush_; }

    // The stroke as one script line, without its newline: it can be replayed bit for bit.
    std::string line() const;

private:
    // What the path so far did to a vertex.
    struct Touch {
        vec3 combed{0.0f};      // sum of weight x direction of the path, world
        float coverage = 0.0f;  // [0,1] largest falloff x pressure along the path
        float turned = 0.0f;    // the same of the images that exchange left and right
        float nearest = std::numeric_limits<float>::infinity();  // m, from the path
        uint ties = 0;      // the images of the path that are that near, a bit each
        vec3 offset{0.0f};  // sum of the ways from them to the vertex, m, world
    };
    // A place where the comb looks at the direction of the path.
    struct CombStep {
        float along = 0.0f;    // [0,1] of the piece
        vec3 direction{0.0f};  // of the path since the step before, world
    };

    void advance(Groom& groom, const PathPoint& from, const PathPoint& to);
    std::vector<CombStep> combSteps(vec3 from, vec3 to);
    void cover(Groom& groom, std::size_t image, const std::vector<CombStep>& steps);
    bool touch(uint v, std::size_t image, const std::vector<CombStep>& steps, Touch& touched) const;
    float coverage(const PathImage& image, const Beside& place) const;
    Touching touching(uint v, const Touch& touched);

    const SkinQuery* query_;
    Groom before_;
    Brush brush_;
    float radius_;                      // m, as it works
    Chunked<Touch> touched_;            // one per skin vertex
    std::optional<Averages> averages_;  // of smooth
    std::vector<Mirroring> mirrorings_;
    std::vector<PathImage> images_;   // by each of the mirrorings
    std::vector<PathPoint> samples_;  // as they came, without feet
    vec3 lastStep_{0.0f};             // last place at which the comb looked at its direction
    double sinceStep_ = 0.0;          // m of path since then
    std::vector<uint> found_;         // kept between dabs for its memory

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
