// accuracy_pictures.cpp -- pictures as textures, and frames for the measure.
#include "app/accuracy_pictures.h"

#include <utility>

#include "app/render/reference_view.h"
#include "core/heat_map.h"

namespace pelage {
namespace {

gl::Texture textureOf(const Image& image, vec3 background) {
    gl::Texture texture = gl::makeTexture(image.size, GL_RGBA8);
    const std::vector<unsigned char> bytes = displayed(image.pixels, background);
    glTextureSubImage2D(texture.name(), 0, 0, 0, image.size.x, image.size.y, GL_RGBA,
                        GL_UNSIGNED_BYTE, bytes.data());
    for (const int filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTextureParameteri(texture.name(), static_cast<GLenum>(filter), GL_LINEAR);
    return texture;
}

}  // namespace

void AccuracyPictures::follow(const Accuracy& accuracy, vec3 background) {
    if (version_ == accuracy.version()) return;
    version_ = accuracy.version();
    const AccuracyPoint& view = accuracy.points().front();
    live_ = textureOf(view.live.image, background);
    reference_ = textureOf(view.reference.image, background);
    heat_ = textureOf(heatMap(view.errors.flipMap), background);
}

unsigned AccuracyPictures::texture(AccuracyPicture which) const {
    switch (which) {
        case AccuracyPicture::none:
            return 0;
        case AccuracyPicture::live:
            return live_.name();
        case AccuracyPicture::reference:
            return reference_.name();
        case AccuracyPicture::heat:
            return heat_.name();
    }
    return 0;
}

Accuracy::Draw AccuracyPictures::draw() {
    if (!renderer_) renderer_ = std::make_shared<Renderer>();
    return [renderer = renderer_](const Document& document, const View& view) -> Accuracy::Drawing {
        constexpr int kTimed = 5;
        return [renderer, document, drawing = LiveDrawing(view, kTimed)]() mutable {
            return drawing.step(*renderer, document);
        };
    };
}

}  // namespace pelage
