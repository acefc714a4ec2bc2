// picture.cpp -- pictures without a window.
#include "app/cli/picture.h"

#include "app/session.h"
#include "core/pixels.h"
#include "core/skin_query.h"

namespace pelage {

Camera framedCamera(const Document& document, float yaw, float pitch, ivec2 size) {
    const Skin& skin = *document.skin;
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    return framed(skin.center(), modelRadius(skin), yaw, pitch, aspect);
}

Camera zoomed(const Document& document, Camera camera, float share) {
    if (share < 1.0f) {
        const SkinQuery query(document.skin);
        if (const auto hit = query.cast(camera.eye(), camera.forward()))
            camera.target = hit->position;
    }
    camera.distance *= share;
    return camera;
}

void writePicture(const std::string& path, const Renderer& renderer, ivec2 size) {
    writePng(path, size, renderer.pixels());
}

}  // namespace pelage
