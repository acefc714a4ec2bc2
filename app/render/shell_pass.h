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

// The uniform block and the buffer of shaders/shell_data.glsl, as C++.
struct ShellVertex {
    vec3 overA{0.0f};
    float top = 0.0f;
    vec3 overB{0.0f};
    uint pad0 = 0;
    vec3 underA{0.0f};
    uint pad1 = 0;
    vec3 underB{0.0f};
    uint pad2 = 0;
};
struct RestVertex {
    vec3 position{0.0f};
    uint pad0 = 0;
    vec4 turn{0.0f, 0.0f, 0.0f, 1.0f};
};
struct ShellCoat {
    float period = 1.0f, width = 0.0f, taper = 0.0f, stray = 0.0f;
};
struct ShellData {
    ShellCoat over, under;
    uint layers = 0;
    float leastWidth = 1.0f;
    uint layer = 0;
    uint coats = 3;
};

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
