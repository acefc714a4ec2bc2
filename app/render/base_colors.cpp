// base_colors.cpp -- the base-color pictures of a source as one array texture.
#include "app/render/base_colors.h"

#include <algorithm>

#include "app/render/decoded.h"

namespace pelage {
namespace {

constexpr int kLargestSide = 2048;
constexpr int kLargestDecoded = 16384;
constexpr int kMostLayers = 2048;                            // what every OpenGL 4.5 can
constexpr std::size_t kLargestArray = std::size_t{1} << 28;  // bytes

// The common size of the layers.
ivec2 layerSize(const std::vector<ivec2>& sizes, std::size_t layers) {
    ivec2 size(1);
    for (const ivec2 each : sizes) size = glm::max(size, each);
    size = glm::min(size, ivec2(kLargestSide));
    const auto bytes = [&] {
        return 4 * layers * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    };
    while (bytes() > kLargestArray) size = glm::max(size / 2, ivec2(1));
    return size;
}

// Scales a picture into one layer of the array, in linear light.
void blitToLayer(const Decoded& picture, GLuint array, int layer, ivec2 size) {
    GLuint names[2];
    glCreateFramebuffers(2, names);
    const gl::Framebuffer from(names[0]), to(names[1]);
    glNamedFramebufferTexture(names[0], GL_COLOR_ATTACHMENT0, picture.texture.name(), 0);
    glNamedFramebufferTextureLayer(names[1], GL_COLOR_ATTACHMENT0, array, 0, layer);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(names[0], names[1], 0, 0, picture.size.x, picture.size.y, 0, 0, size.x,
                           size.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace

BaseColors makeBaseColors(const Source& source) {
    std::vector<ivec2> sizes;
    std::vector<int> layerOf;  // of each image, -1 for none
    int layers = 0;
    for (const SourceImage& image : source.images) {
        sizes.push_back(decodedSize(image.bytes, kLargestDecoded));
        layerOf.push_back(sizes.back().x > 0 && layers < kMostLayers ? layers++ : -1);
    }
    const ivec2 size = layerSize(sizes, static_cast<std::size_t>(layers));

    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    BaseColors result;
    result.texture = gl::Texture(name);
    glTextureStorage3D(name, 1, GL_SRGB8_ALPHA8, size.x, size.y, std::max(layers, 1));
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (std::size_t i = 0; i < source.images.size(); ++i) {
        if (layerOf[i] < 0) continue;
        // One at a time: they may be large.
        const Decoded picture = decodePicture(source.images[i].bytes, GL_SRGB8_ALPHA8);
        if (picture.texture)
            blitToLayer(picture, name, layerOf[i], size);
        else
            layerOf[i] = -1;
    }

    for (const SourceMaterial& material : source.materials) {
        MaterialData data;
        data.color = vec3(material.baseColor);
        if (material.image >= 0)
            data.layer = static_cast<float>(layerOf[static_cast<std::size_t>(material.image)]);
        result.materials.push_back(data);
    }
    result.materials.emplace_back();
    return result;
}

}  // namespace pelage
