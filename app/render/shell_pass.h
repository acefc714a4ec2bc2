// shell_pass.h -- fur in shells: layers of the same hair that strands are, marched behind each
// pixel.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/render/canvas.h"
#include "app/render/fin_pass.h"
#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/program.h"
#include "app/render/renderer.h"
#include "app/render/shell_pictures.h"

namespace pelage {

class ShellPass {
public:
    ShellPass();
    // Draws the fur before the skin into a canvas that holds the skin's color and depth. Clumps,
    // curls and frizz are left out.
    void draw(const Mirror& mirror, const Document& document, const View& view,
              const FrameData& frame, const gl::Buffer& frameBlock, const Canvas& canvas);

    // Of the last draw: layers, bytes of the tile of roots or the pictures, all levels, and fins.
    uint layers() const { return layers_; }
    std::size_t textureBytes() const { return textureBytes_; }
    uint fins() const { return finned_ ? fins_->count() : 0; }
    std::size_t bytes() const;

private:
    void makeTile();
    void findCurves(const Mirror& mirror, const Document& document, uint coats, float seconds);
    void updateTriangles(const Mirror& mirror, const std::shared_ptr<const Skin>& atRest);
    void updateSkin(const Mirror& mirror);
    struct CurveKey {  // what the mean hair depends on
        std::shared_ptr<const Skin> shown;
        Groom groom;
        Fur fur;
        uint coats;
        float seconds;
        bool operator==(const CurveKey&) const = default;
    };
    struct Peel {  // the surface over the fur that comes next behind each pixel
        gl::Texture found, depth;
        gl::Framebuffer target, march;
    };
    void resize(ivec2 size);
    void find(const Mirror& mirror, const Program& program, std::size_t offset, const Peel& peel,
              const Peel& before) const;
    void leaveOutSeen() const;
    void march(const Program& program, const Peel& peel, const Canvas& canvas) const;
    void drawMarched(const Mirror& mirror, const Canvas& canvas, bool plain);
    // From pictures, layer by layer in any case.
    void drawMap(const Mirror& mirror, const ShellSource& source, uint coat);
    void drawLayer(const Mirror& mirror, const Program& program, float t) const;
    void drawLayers(const Mirror& mirror, uint coats);
    void drawFins(const Mirror& mirror, const std::shared_ptr<const Skin>& atRest, uint coats,
                  const Canvas& canvas);

    struct March {
        Program fromOver, fromSkin;
    };
    Program curves_, rodCurves_, over_, skin_, show_, seenOut_;
    std::optional<Program> layer_, map_;  // made when they are first needed, as what follows
    std::optional<March> swept_, plain_;
    std::optional<FinPass> fins_;
    bool finned_ = false;
    gl::VertexArray layerArray_, surfaceArray_;
    gl::Buffer tile_, block_, mapBlock_, vertices_, corners_, indices_, rest_, curvatures_,
        rodTable_;
    ivec2 size_{0};
    Peel peels_[2], visible_;  // of the surface over the fur, and of the skin
    std::vector<gl::Query> anyFound_;
    gl::Texture vertexRows_, cornerRows_, indexRows_, tileRows_;
    gl::Texture seen_, hairColor_, hairDepth_;
    ShellPictures pictures_;
    uint layers_ = 0;
    std::size_t textureBytes_ = 0;
    std::optional<CurveKey> curvesOf_;
    std::shared_ptr<const Skin> atRest_;  // whose triangles are known
    std::shared_ptr<const Skin> shown_;   // whose curvatures are
};

}  // namespace pelage
