// shell_choice.cpp -- pictures for shells: made when they are chosen, shown layer by layer.
#include "app/shell_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/render/gl.h"
#include "core/pixels.h"

namespace pelage {

struct ShellPreview {
    gl::Texture photo, layers;
    int columns = 1, rows = 1;
};

namespace {

gl::Texture uploaded(ivec2 size, const std::vector<unsigned char>& rgba) {
    gl::Texture texture = gl::makeTexture(size, GL_RGBA8);
    glTextureSubImage2D(texture.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        rgba.data());
    for (const int filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTextureParameteri(texture.name(), static_cast<GLenum>(filter), GL_LINEAR);
    return texture;
}

// One square out of the middle of the photograph for each layer.
gl::Texture layerSheet(const PhotoLayers& layers, const Pixels& photo, ivec2 grid) {
    const int side = std::min(layers.size.x, layers.size.y);
    const ivec2 corner = (layers.size - side) / 2;
    const ivec2 size = kPreviewSide * grid;
    std::vector<unsigned char> sheet(4 * pixelCount(size));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const int k = y / kPreviewSide * grid.x + x / kPreviewSide + 1;
            const ivec2 in = corner + ivec2(x, y) % kPreviewSide * side / kPreviewSide;
            const auto place =
                static_cast<std::size_t>(in.y) * static_cast<std::size_t>(layers.size.x) +
                static_cast<std::size_t>(in.x);
            const int layer = layers.layerOfPixel[place];
            if (layer == 0 || layer > k || k > layers.layers) continue;
            std::copy_n(photo.rgba.begin() + static_cast<std::ptrdiff_t>(4 * place), 4,
                        sheet.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * size.x + x));
        }
    return uploaded(size, sheet);
}

}  // namespace

bool readsFile(const ShellChoice& choice, const ShellRecipe& recipe) {
    return (recipe.from == ShellRecipe::From::photo || recipe.from == ShellRecipe::From::picture) &&
           !samePicture(recipe, choice.recipe);
}

void choose(ShellChoice& choice, const ShellRecipe& recipe, Progress* progress) {
    ShellChoice other = choice;
    other.recipe = recipe;
    if (recipe.from == ShellRecipe::From::hairs)
        other.picture = {};
    else if (!samePicture(recipe, choice.recipe))
        other.picture = shellPicture(recipe, progress);
    if (recipe.from != ShellRecipe::From::photo)
        other.layers = {};
    else if (!samePicture(recipe, choice.recipe) || !(recipe.photo == choice.recipe.photo))
        other.layers = photoLayers(other.picture, recipe.photo);
    else
        return void(choice = std::move(other));  // its pictures are still right
    other.preview = nullptr;
    choice = std::move(other);
}

ShellTextures texturesOf(ShellChoice& choice) {
    if (choice.layers.layers == 0) return {};
    if (!choice.preview) {
        const Pixels photo = displayPixels(choice.picture.photo);
        const int columns = std::min(choice.layers.layers, 16);
        const int rows = (choice.layers.layers + columns - 1) / columns;
        choice.preview = std::make_shared<ShellPreview>(
            ShellPreview{uploaded(photo.size, photo.rgba),
                         layerSheet(choice.layers, photo, {columns, rows}), columns, rows});
    }
    const ShellPreview& preview = *choice.preview;
    return {preview.photo.name(), preview.layers.name(), preview.columns, preview.rows};
}

}  // namespace pelage
