// base_colors.cpp -- the base-color pictures of a source as one array texture.
#include "app/render/base_colors.h"

#include <algorithm>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace pelage {
namespace {

constexpr int kLargestSide = 2048;
constexpr int kLargestDecoded = 16384;

struct Decoded {
    gl::Texture texture;
    ivec2 size{0};
};

Decoded decode(const SourceImage& image) {
    const auto* bytes = reinterpret_cast<const stbi_uc*>(image.bytes.data());
    const int count = static_cast<int>(std::min<std::size_t>(image.bytes.size(), 1u << 30));
    ivec2 size(0);
    int channels = 0;
    Decoded result;
    if (!stbi_info_from_memory(bytes, count, &size.x, &size.y, &channels) ||
        std::max(size.x, size.y) > kLargestDecoded)
        return result;
    stbi_uc* pixels = stbi_load_from_memory(bytes, count, &size.x, &size.y, &channels, 4);
    if (!pixels) return result;
    result.size = size;
    result.texture = gl::makeTexture(size, GL_SRGB8_ALPHA8);
    glTextureSubImage2D(result.texture.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels);
    stbi_image_free(pixels);
    return result;
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
    std::vector<Decoded> pictures;
    ivec2 size(1);
    for (const SourceImage& image : source.images) {
        pictures.push_back(decode(image));
        size = glm::max(size, pictures.back().size);
    }
    size = glm::min(size, ivec2(kLargestSide));

    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    BaseColors result;
    result.texture = gl::Texture(name);
    const int layers = std::max<int>(1, static_cast<int>(pictures.size()));
    glTextureStorage3D(name, 1, GL_SRGB8_ALPHA8, size.x, size.y, layers);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (int layer = 0; layer < static_cast<int>(pictures.size()); ++layer)
        if (pictures[static_cast<std::size_t>(layer)].texture)
            blitToLayer(pictures[static_cast<std::size_t>(layer)], name, layer, size);

    for (const SourceMaterial& material : source.materials) {
        MaterialData data;
        data.color = vec3(material.baseColor);
        if (material.image >= 0 && pictures[static_cast<std::size_t>(material.image)].texture)
            data.layer = static_cast<float>(material.image);
        result.materials.push_back(data);
    }
    result.materials.emplace_back();
    return result;
}

}  // namespace pelage
