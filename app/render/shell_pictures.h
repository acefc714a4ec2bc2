// shell_pictures.h -- the pictures that shells are cut from, as textures.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>

#include "app/render/gl.h"
#include "core/shell_source.h"

namespace pelage {

// The uniform block of shaders/shell_map.glsl, as C++.
struct ShellMapData {
    vec4 tones{0.0f};
    float side = 1.0f;
    uint photo = 0, layers = 1, pad0 = 0;
    float coverage = 1.0f, taper = 1.0f, gap = 1.0f;
    uint pad1 = 0;
};
static_assert(sizeof(ShellMapData) == 48);
ShellMapData mapData(const ShellSource& source);

class ShellPictures {
public:
    // Uploaded when it is first asked for. Repeats, mixed linearly between texels and levels.
    const gl::Texture& textureOf(const std::shared_ptr<const ShellTexture>& picture);
    // Drops what none of these uses; bytes of the rest.
    std::size_t keep(const std::array<ShellSource, 2>& used);
    std::size_t bytes() const;

private:
    std::map<std::shared_ptr<const ShellTexture>, gl::Texture> textures_;
};

}  // namespace pelage
