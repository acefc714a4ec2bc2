// embedded.h -- files that travel inside the program (cmake/embed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace pelage {

struct EmbeddedFile {
    std::string_view name, text;
};

std::span<const EmbeddedFile> embeddedPresets();  // assets/presets/*.json
std::span<const EmbeddedFile> embeddedShaders();  // shaders/*; only with pelage_render

}  // namespace pelage
