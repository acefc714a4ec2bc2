// framing.cpp -- around the middle of the skin, or at what is in the middle of the picture.
#include "app/render/framing.h"

#include "core/skin_query.h"

namespace pelage {

float modelRadius(const Skin& skin) { return skin.radius + firstLength(skin); }

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

}  // namespace pelage
