// strand_pass.h -- hairs over the skin, by a visibility raster in compute shaders.
#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/program.h"
#include "core/lod.h"

namespace pelage {

// Which hairs a frame draws; chosen on the CPU before anything is shaped. Hairs are numbered
// through all runs, so that groups of 32 are full however few hairs a cluster gives.
struct StrandPlan {
    struct Run {         // a prefix of a cluster of roots, as in shaders/strand_raster.comp
        uint first = 0;  // into the roots
        uint begin = 0, end = 0;          // numbers of its hairs, the last one excluded
        float lod = 1.0f;                 // share of the cluster's hairs that is drawn
        float fade = 1.0f;                // rank at which a hair of density 1 has faded out, >= lod
        float phase = 0.0f, step = 1.0f;  // of the ranks, see rankOf
        uint pad = 0;
    };
    std::vector<Run> runs;
    std::vector<uint> groups;       // of 32 hairs: the run that the first one belongs to
    uint wideEnd = 0;               // hairs below it may be wide enough to look round,
    uint narrowBegin = 0, end = 0;  // these are not; begins a group
    bool thinRibbonsAreLines = false;
};

// `adapts` where narrow ribbons may be drawn as polylines.
StrandPlan planStrands(const Roots& roots, const Choice& choice, bool adapts);

// Of the hairs of one program that are not hidden, as in shaders/strand_raster.comp: groups of 32
// as glDispatchComputeIndirect reads them, hairs and their segments.
struct SeenList {
    uint wide = 0, high = 0, deep = 1, count = 0, segments = 0;
};

class StrandPass {
public:
    StrandPass();
    // Begins a frame of the hair over a skin of this depth. Hair stays in the window that is given
    // in pixels; the answer is how far away the skin is there. Waits for the GPU.
    SkinDepth begin(const gl::Texture& skinDepth, const gl::Buffer& frameBlock, ivec2 size,
                    ivec2 lower, ivec2 upper);
    // Draws into `picture` (RGBA16F) the hairs that stand before the skin, of `coats` (bit 0: over,
    // bit 1: under).
    void draw(const Mirror& mirror, const Fur& fur, uint coats, const StrandPlan& plan,
              const gl::Buffer& frameBlock, const gl::Texture& picture,
              const gl::Texture& skinDepth);

    struct Counts {
        std::size_t tried = 0;     // hairs for which an invocation was started, in each pass
        std::size_t hairs = 0;     // that were found not hidden
        std::size_t segments = 0;  // of those
    };
    Counts counts() const;  // of the last draw; waits for the GPU
    std::size_t bytes() const {
        return keys_.bytes() + strips_.bytes() + runs_.bytes() + groups_.bytes() + seen_.bytes() +
               rodTable_.bytes();
    }

private:
    // The two passes of hair of one style, and the coats that they draw.
    struct Pair {
        Program depth, color;
    };
    struct Part {
        const Pair* programs;
        uint coats;
        uint begin, end;  // numbers of hairs
        uint seen = 0;    // where those not hidden begin in their buffer
    };
    // Style; whether it is shaped, rods, shaded as round, thin.
    using Kind = std::tuple<uint, bool, bool, bool, bool>;
    const Pair& programsOf(uint style, const Coat& coat, bool thin);
    void addParts(std::vector<Part>& parts, const Fur& fur, uint coats, const StrandPlan& plan,
                  bool thin);

    Program keyProgram_;
    std::map<Kind, Pair> programs_;
    gl::Buffer keys_, strips_, runs_, groups_, counters_;
    gl::Buffer seen_;      // numbers of the hairs that are not hidden
    gl::Buffer rodTable_;  // filled when a coat first needs it
    std::size_t tried_ = 0;
};

}  // namespace pelage
