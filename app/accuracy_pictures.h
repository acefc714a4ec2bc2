// accuracy_pictures.h -- what the Accuracy panel needs of OpenGL: a renderer and three textures.
#pragma once

#include <cstddef>
#include <memory>

#include "app/accuracy.h"
#include "app/render/gl.h"

namespace pelage {

// Has to go before the OpenGL context does.
class AccuracyPictures {
public:
    // Makes the textures those of what is measured. They are over this background.
    void follow(const Accuracy& accuracy, vec3 background);

    // 0 until there is one.
    unsigned texture(AccuracyPicture which) const;

    // Draws with a renderer of its own, so that the animal's buffers stay as they are.
    Accuracy::Draw draw();

private:
    std::shared_ptr<Renderer> renderer_;
    gl::Texture live_, reference_, heat_;
    std::size_t version_ = 0;
};

}  // namespace pelage
