// shell_pass.h -- fur in shells: layers of the same hair that strands are, marched behind each
// pixel.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/render/canvas.h"
#include "app/render/fin_pass.h"
#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/program.h"
#include "app/render/renderer.h"
#include "app/render/shell_ground.h"
#include "app/render/shell_pictures.h"

namespace pelage {

class ShellPass {
public:
    ShellPass();
    // Draws the fur before the skin into a canvas that holds the skin's color and depth, drawn of
    // that surface. Clumps, curls and frizz are left out.
    void draw(Mirror& mirror, const Mirror::Surface& skin, const Document& document,
              const View& view, const FrameData& frame, const gl::Buffer& frameBlock,
              const Canvas& canvas);

    // Of the last draw: layers, bytes of the tile of roots or the pictures, all levels, and fins.
    uint layers() const { return layers_; }
    std::size_t textureBytes() const { return textureBytes_; }
    uint fins() const { return finned_ ? fins_->count() : 0; }
    std::size_t bytes() const;

private:
    struct Peel {  // the surface over the fur that comes next behind each pixel
        gl::Texture found, depth;
        gl::Framebuffer target, march;
    };
    void resize(ivec2 size);
    void find(const Mirror& mirror, const Program& program, const Mirror::Surface& surface,
              const Peel& peel, const Peel& before) const;
    void leaveOutSeen() const;
    struct March {
        Program fromOver, fromSkin;
    };
    const March& marchFor(std::vector<std::string> defines);
    void march(const Program& program, const Peel& peel, const Mirror::Surface& surface,
               const Canvas& canvas) const;
    void drawMarched(const Mirror& mirror, const Mirror::Surface& skin, const Canvas& canvas,
                     const std::vector<std::string>& defines);
    void usePicture(const ShellSource& source);
    void drawMap(const Mirror& mirror, const ShellSource& source, uint coat);
    void drawLayer(const Mirror& mirror, const Program& program, float t) const;
    void drawLayers(const Mirror& mirror, uint coats, const View& view);
    void drawFins(const std::shared_ptr<const Skin>& atRest, uint coats, const Canvas& canvas);

    ShellGround ground_;
    Program over_, skin_, show_, seenOut_;
    // Made when they are first needed: a layer without shadows and with them, and marches.
    std::optional<Program> layer_[2], map_;
    std::map<std::vector<std::string>, March> marches_;
    std::optional<FinPass> fins_;
    bool finned_ = false;
    gl::VertexArray cornerArray_;
    gl::Buffer tile_, block_, mapBlock_;
    ivec2 size_{0};
    Peel peels_[2], visible_;  // of the surface over the fur, and of the skin
    std::vector<gl::Query> anyFound_;
    gl::Texture tileRows_, seen_, hairColor_, hairDepth_;
    ShellPictures pictures_;
    uint layers_ = 0;
    std::size_t textureBytes_ = 0;
};

}  // namespace pelage
