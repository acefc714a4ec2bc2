// headless.h -- an OpenGL context without a window (EGL surfaceless), and pictures to files.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/types.h"

namespace pelage {

// Current on this thread while it lives. Throws std::runtime_error without an EGL 4.5 context.
class HeadlessContext {
public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

// RGBA8 rows from the top as a JPEG file without alpha.
std::vector<std::byte> encodeJpeg(ivec2 size, const std::vector<unsigned char>& rgba);
// RGBA8 rows from the top to a PNG file, atomically. Throws std::runtime_error naming the file.
void writePng(const std::string& path, ivec2 size, const std::vector<unsigned char>& rgba);

}  // namespace pelage
