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
#include "app/render/shell_pictures.h"

namespace pelage {

class ShellPass {
public:
    ShellPass();
    // Draws the fur before the skin into the bound framebuffer, which holds the skin's color and
    // depth. Clumps, curls and frizz are left out.
    void draw(const Mirror& mirror, const Document& document, const View& view,
              const FrameData& frame, const gl::Buffer& frameBlock);

    // Of the last draw: layers, and bytes of the tile of roots or the pictures, all levels.
    uint layers() const { return layers_; }
    std::size_t textureBytes() const { return textureBytes_; }
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
    void drawMarched(const Mirror& mirror, const char* fragment, std::vector<std::string> defines);
    // Layer k of n of a coat, at t of its hair.
    struct Layer {
        uint coat, k;
        float t;
    };
    void drawLayer(const Mirror& mirror, const Pair& programs, const Layer& layer) const;
    void drawRoots(const Mirror& mirror, const View& view, uint coats);
    void drawMap(const Mirror& mirror, const ShellSource& source, uint coat, Shells shells);

    Program curves_, rodCurves_;
    std::map<std::string, Pair> programs_;  // made when they are first needed
    gl::VertexArray vertexArray_;
    gl::Buffer tile_, block_, mapBlock_, vertices_, rest_, curvatures_, rodTable_;
    ShellPictures pictures_;
    uint layers_ = 0;
    std::size_t textureBytes_ = 0;
    std::shared_ptr<const Skin> skin_;  // whose curvatures are known
};

}  // namespace pelage
