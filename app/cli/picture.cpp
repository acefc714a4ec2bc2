// picture.cpp -- pictures without a window.
#include "app/cli/picture.h"

#include "core/pixels.h"

namespace pelage {

void writePicture(const std::string& path, const Renderer& renderer, ivec2 size) {
    writePng(path, size, renderer.pixels());
}

}  // namespace pelage
