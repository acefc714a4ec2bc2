// shell_pictures.cpp -- the pictures that shells are cut from, as textures.
#include "app/render/shell_pictures.h"

#include <algorithm>

namespace pelage {

ShellMapData mapData(const ShellSource& source) {
    ShellMapData data;
    data.tones = vec4(source.tones[0], source.tones[1]);
    data.side = source.side;
    data.photo = source.texture->photo ? 1 : 0;
    data.layers = source.layers;
    data.coverage = source.cut.coverage;
    data.taper = source.cut.taper;
    data.gap = source.gap;
    return data;
}

const gl::Texture& ShellPictures::textureOf(const std::shared_ptr<const ShellTexture>& picture) {
    const auto known = textures_.find(picture);
    if (known != textures_.end()) return known->second;
    const auto levels = static_cast<GLsizei>(picture->levels.size());
    gl::Texture texture =
        gl::makeTexture(picture->size, picture->photo ? GL_RGBA8 : GL_RG16, levels);
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    ivec2 size = picture->size;
    for (int level = 0; level < levels; ++level, size = halfSize(size))
        glTextureSubImage2D(texture.name(), level, 0, 0, size.x, size.y,
                            picture->photo ? GL_RGBA : GL_RG,
                            picture->photo ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT,
                            picture->levels[static_cast<std::size_t>(level)].data());
    return textures_.emplace(picture, std::move(texture)).first->second;
}

std::size_t ShellPictures::keep(const std::array<ShellSource, 2>& used) {
    std::erase_if(textures_, [&](const auto& held) {
        return std::ranges::find(used, held.first, &ShellSource::texture) == used.end();
    });
    return bytes();
}

std::size_t ShellPictures::bytes() const {
    std::size_t sum = 0;
    for (const auto& [picture, texture] : textures_) sum += picture->bytes();
    return sum;
}

}  // namespace pelage
