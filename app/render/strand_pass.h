// strand_pass.h -- hairs over the skin, by a visibility raster in compute shaders.
#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/program.h"

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
    struct Group {     // of 32 hairs
        uint run = 0;  // that its first hair belongs to
        uint seen = 0;
    };
    std::vector<Run> runs;
    std::vector<Group> groups;
    uint hairs = 0;
};

// Leaves out clusters outside the view, and of the others all hairs beyond the share that is
// wanted: `share`, times the paper's rule with `byDistance`: as many as are a pixel wide.
// `reach` is the length of the longest hair, m.
StrandPlan planStrands(const Roots& roots, const FrameData& frame, float rootWidth, float reach,
                       float share, bool byDistance);

class StrandPass {
public:
    StrandPass();
    // Draws into `picture` (RGBA16F) the hairs that stand before `skinDepth`.
    void draw(const Mirror& mirror, const Fur& fur, const FrameData& frame, const StrandPlan& plan,
              const gl::Buffer& frameBlock, const gl::Texture& picture,
              const gl::Texture& skinDepth);
    // Hairs that the last draw found not hidden; waits for the GPU.
    std::size_t hairsDrawn() const;
    std::size_t bytes() const { return keys_.bytes() + runs_.bytes() + groups_.bytes() + rodTable_.bytes(); }

private:
    // The two passes of hair of one style, and the coats that they draw.
    struct Pair {
        Program depth, color;
    };
    struct Part {
        const Pair* programs;
        uint coats;
    };
    using Kind = std::tuple<uint, bool, bool>;  // style, whether it is shaped, whether it is rods
    const Pair& programsOf(const Coat& coat);
    std::vector<Part> partsOf(const Fur& fur, uint coats);

    Program keyProgram_;
    std::map<Kind, Pair> programs_;
    gl::Buffer keys_, runs_, groups_, counters_;
    gl::Buffer rodTable_;  // filled when a coat first needs it
};

}  // namespace pelage
