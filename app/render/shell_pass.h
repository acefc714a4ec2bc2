// shell_pass.h -- fur in shells: layers of the same hair that strands are, marched behind each
// pixel.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/program.h"
#include "app/render/renderer.h"

namespace pelage {

class ShellPass {
public:
    ShellPass();
    // Draws the fur before the skin into the bound framebuffer, which holds the skin's color and
    // depth. Clumps, curls and frizz are left out.
    void draw(const Mirror& mirror, const Document& document, const View& view,
              const FrameData& frame, const gl::Buffer& frameBlock);

    uint layers() const { return layers_; }                     // of the last draw
    std::size_t textureBytes() const { return tile_.bytes(); }  // of the tile of roots, all levels
    std::size_t bytes() const;

private:
    void makeTile();
    void findCurves(const Mirror& mirror, const Fur& fur);
    void updateSkin(const Mirror& mirror, const Skin& atRest);
    // Of a way of drawing, without and with a base-color texture.
    struct Pair {
        Program plain, textured;
    };
    const Pair& programsOf(const char* fragment, const std::vector<std::string>& defines);
    void drawWith(const Mirror& mirror, const Pair& programs) const;
    void drawMarched(const Mirror& mirror, bool plain);
    void drawLayers(const Mirror& mirror, uint coats);

    Program curves_, rodCurves_;
    std::map<std::string, Pair> programs_;  // made when they are first needed
    gl::VertexArray vertexArray_;
    gl::Buffer tile_, block_, vertices_, rest_, curvatures_, rodTable_;
    uint layers_ = 0;
    std::shared_ptr<const Skin> skin_;  // whose curvatures are known
};

}  // namespace pelage
