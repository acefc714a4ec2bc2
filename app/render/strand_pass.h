// strand_pass.h -- hairs over the skin, by a visibility raster in compute shaders.
#pragma once

#include <cstddef>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/program.h"

namespace pelage {

// How many hairs of which clusters a frame draws; chosen on the CPU before anything is shaped.
struct StrandPlan {
    struct Job {  // as in shaders/strand_raster.comp
        uint first = 0, count = 0;
        float lod = 1.0f, fade = 1.0f;
        uint seen = 0, pad[3] = {};
    };
    std::vector<Job> jobs;
    std::size_t hairs = 0;  // sum of the counts
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
    void draw(const Mirror& mirror, const FrameData& frame, const StrandPlan& plan,
              const gl::Buffer& frameBlock, const gl::Texture& picture,
              const gl::Texture& skinDepth);
    // Hairs that the last draw found not hidden; waits for the GPU.
    std::size_t hairsDrawn() const;
    std::size_t bytes() const { return keys_.bytes() + jobs_.bytes(); }

private:
    Program keyProgram_, depthProgram_, colorProgram_;
    gl::Buffer keys_, jobs_, counters_;
};

}  // namespace pelage
