// brush.h -- strokes: how a brush that moves over the skin changes what is painted.
//
// The effect of a stroke is a function of the groom before it and of its coverage: at each vertex
// the largest falloff along the path. So it does not depend on how often the pointer was sampled,
// and overlaps do not add up. Comb sums directions along a path resampled at a fixed spacing.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "groom.h"
#include "skin_query.h"

namespace pelage {

enum class Tool { length, density, comb, smooth, mask };
enum class Mode { add, subtract, set };
enum class Falloff { smooth, linear, sharp, constant };

// Row of the tool table: what buttons, keys, scripts and help are made from.
struct ToolInfo {
    Tool tool;
    const char* name;   // in scripts: "length"
    const char* label;  // in the panel: "Length"
    const char* help;   // one sentence
    bool hasModes;      // add, subtract, set make sense
    float least, greatest;  // of Brush::value; length: in multiples of the skin's size
};
std::span<const ToolInfo> tools();
const ToolInfo& toolInfo(Tool tool);

struct Brush {
    Tool tool = Tool::comb;
    Mode mode = Mode::add;
    Falloff falloff = Falloff::smooth;
    float radius = 0.05f;    // m, world, > 0
    float strength = 0.5f;   // [0,1]
    float value = 0.0f;      // for Mode::set: m (length) or [0,1] (density, mask)
    bool mirrorX = false;    // the same on the other side of the skin's own x = 0 plane (world)
    bool facingOnly = true;  // skip vertices whose normal points away from the skin under the cursor
};

// Weight of a vertex at `distance` from the middle of a brush, [0,1]; 1 at 0, 0 from radius on.
float falloffWeight(Falloff falloff, float distance, float radius);

// A stroke in progress: make it at press, dab it at every move, keep the groom's edit at release.
class Stroke {
public:
    // `before` is the groom when the pointer went down. `query` must outlive the stroke.
    Stroke(const SkinQuery& query, Groom before, Brush brush);

    // Covers the path from the last point to this one (the first call: the point alone) and writes
    // the touched vertices of `groom`. `normal` is that of the skin under the cursor. Cost grows
    // with the footprint and not with the mesh. A mirrored brush dabs both sides.
    void dab(Groom& groom, vec3 position, vec3 normal);

    // The stroke as one script line, without its newline: it can be replayed bit for bit.
    std::string line() const;

private:
    struct Sample { vec3 position, normal; };
    // (the rest is the implementation's)
};

// The same tool over the entire skin at full coverage; masked vertices keep their values by the
// share of the mask. For comb: `direction` (world) is laid onto the tangent plane of each vertex.
void flood(const Skin& skin, Groom& groom, const Brush& brush, vec3 direction = vec3(0.0f));

}  // namespace pelage
