// fin_pass.h -- fins: fur on the edges of the skin near the silhouette, of the hair of shells.
#pragma once

#include <cstddef>
#include <memory>

#include "app/render/canvas.h"
#include "app/render/program.h"
#include "core/skin.h"

namespace pelage {

class FinPass {
public:
    FinPass();
    // Draws the fins of these coats before and behind what is in a canvas whose skin's depth is
    // kept. Needs what ShellPass::draw has bound. An edge whose normal is at right angles to the
    // view has a fin of all hairs near it; the further from that the fewer, down to none at 70
    // degrees; of short edges fewer have fins, which are longer.
    void draw(const std::shared_ptr<const Skin>& atRest, uint coats, const Canvas& canvas);

    uint count() const;  // of the last draw; waits for it
    std::size_t bytes() const { return edges_.bytes() + fins_.bytes(); }

private:
    void updateEdges(const std::shared_ptr<const Skin>& atRest);
    const gl::Texture& keptDepth(const Canvas& canvas);

    Program choose_, draw_;
    gl::VertexArray array_;
    gl::Buffer edges_, fins_;
    std::shared_ptr<const Skin> edgesOf_;
    uint edgeCount_ = 0;
    gl::Texture depth_;  // of what was drawn before
    ivec2 size_{0};
};

}  // namespace pelage
