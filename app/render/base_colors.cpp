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
constexpr int kMostLayers = 2048;                            // what every OpenGL 4.5 can
constexpr std::size_t kLargestArray = std::size_t{1} << 28;  // bytes

const stbi_uc* encoded(const SourceImage& image) {
    return reinterpret_cast<const stbi_uc*>(image.bytes.data());
}

int encodedSize(const SourceImage& image) {
    return static_cast<int>(std::min<std::size_t>(image.bytes.size(), 1u << 30));
}

// Pixels as the header says; 0 where the picture is not one that is decoded.
ivec2 sizeOf(const SourceImage& image) {
    ivec2 size(0);
    int channels = 0;
    if (image.bytes.empty() ||
        !stbi_info_from_memory(encoded(image), encodedSize(image), &size.x, &size.y, &channels))
        return ivec2(0);
    // A byte of PNG holds at most 8 * 1032 pixels, one of JPEG far fewer.
    const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const bool plausible = pixels <= (std::size_t{1} << 20) + 8256 * image.bytes.size();
    return plausible && std::max(size.x, size.y) <= kLargestDecoded ? size : ivec2(0);
}

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

struct Decoded {
    gl::Texture texture;
    ivec2 size{0};
};

Decoded decode(const SourceImage& image) {
    Decoded result;
    int channels = 0;
    ivec2 size(0);
    stbi_uc* pixels =
        stbi_load_from_memory(encoded(image), encodedSize(image), &size.x, &size.y, &channels, 4);
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
    std::vector<ivec2> sizes;
    std::vector<int> layerOf;  // of each image, -1 for none
    int layers = 0;
    for (const SourceImage& image : source.images) {
        sizes.push_back(sizeOf(image));
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
        const Decoded picture = decode(source.images[i]);  // one at a time: they may be large
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
