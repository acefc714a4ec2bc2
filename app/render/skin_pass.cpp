// skin_pass.cpp -- the skin under the fur.
#include "app/render/skin_pass.h"

#include "app/render/surface.h"

namespace pelage {

SkinPass::SkinPass()
    : plain_(Program::draw("skin.vert", "skin.frag")),
      textured_(Program::draw("skin.vert", "skin.frag", {"TEXTURED"})),
      overlay_(Program::draw("skin.vert", "skin.frag", {"TEXTURED", "OVERLAY"})),
      vertexArray_(cornerArray()) {}

void SkinPass::draw(const Mirror& mirror, const Mirror::Surface& surface,
                    std::span<const Range> ranges, bool shows) const {
    drawSurface(vertexArray_, mirror, surface, ranges, true,
                [&](const Mirror::Part& part) -> const Program& {
                    return shows ? overlay_ : part.layer >= 0.0f ? textured_ : plain_;
                });
}

}  // namespace pelage
