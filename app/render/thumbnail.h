// thumbnail.h -- small pictures of coats, on a furry ball, drawn a sample at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/render/renderer.h"

namespace pelage {

inline constexpr int kThumbnailSide = 192;  // pixels

// Has a renderer of its own, so that the animal's buffers stay as they are.
class Thumbnailer {
public:
    // Draws one more sample of the coat; the picture as a JPEG, which takes a sixth of the bytes of
    // a PNG here, once it is finished. Another coat than that of the call before begins anew.
    std::optional<std::vector<std::byte>> draw(const Fur& fur);

private:
    Renderer renderer_;
    std::optional<Fur> fur_;
    Document ball_;
};

}  // namespace pelage
