// gl_context.h -- the OpenGL context of the tests, compute shaders written in them, and pictures.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/render/gl.h"
#include "app/render/frames.h"
#include "app/render/headless.h"
#include "app/render/mirror.h"
#include "app/render/program.h"
#include "app/render/renderer.h"
#include "core/srgb.h"

namespace pelage::test {

// One context for the whole process, current while any test runs.
class GlEnvironment : public ::testing::Environment {
public:
    void SetUp() override { context_ = std::make_unique<HeadlessContext>(); }
    void TearDown() override { context_.reset(); }

private:
    std::unique_ptr<HeadlessContext> context_;
};
inline ::testing::Environment* const kGlEnvironment =
    ::testing::AddGlobalTestEnvironment(new GlEnvironment);

// Shared files, expanded, under the version line of every shader and what it defines.
inline std::string shaderHead(const std::vector<std::string>& files,
                              const std::vector<std::string>& defines = {}) {
    std::string text = "#version 450 core\n";
    for (const std::string& define : defines) text += "#define " + define + "\n";
    for (const std::string& file : files) text += expandShader(file).text;
    return text;
}

inline gl::ProgramName computeProgram(const std::string& text) {
    const char* source = text.c_str();
    gl::ProgramName program(glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source));
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    char log[4096] = "";
    glGetProgramInfoLog(program.name(), sizeof log, nullptr, log);
    if (!good) throw std::runtime_error(log);
    return program;
}

template <typename T>
gl::Buffer bufferOf(const std::vector<T>& values) {
    gl::Buffer buffer;
    buffer.upload(std::span<const T>(values));
    return buffer;
}

// The first `count` values of a buffer, after all that shaders wrote.
template <typename T>
std::vector<T> valuesOf(GLuint buffer, std::size_t count) {
    std::vector<T> values(count);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(count * sizeof(T)), values.data());
    return values;
}

// What the mirror uploaded to a binding of frame.glsl.
template <typename T>
std::vector<T> uploaded(const Mirror& mirror, GLuint binding, std::size_t count) {
    mirror.bind();
    GLint name = 0;
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, binding, &name);
    return valuesOf<T>(static_cast<GLuint>(name), count);
}

using Pixels = std::vector<unsigned char>;  // RGBA8, as Renderer::pixels

inline Pixels picture(Renderer& renderer, const Document& document, const View& view) {
    drawFinished(renderer, document, view);
    return renderer.pixels();
}

// The color channels in linear light, three a pixel.
inline std::vector<float> linear(const Pixels& pixels) {
    std::vector<float> values;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (i % 4 != 3) values.push_back(linearFromSrgb(static_cast<float>(pixels[i]) / 255.0f));
    return values;
}

// Pixels that hair covers, mean of `view.samples` pictures whose camera is moved by parts of a
// pixel. Each is a single sample, in which a pixel is either hair or the background, so that the
// eight bits of the picture do not round. Hair must not be pure green.
inline double coveredPixels(Renderer& renderer, const Document& document, View view) {
    view.showSkin = false;
    view.background = vec3(0.0f, 1.0f, 0.0f);
    const float pixel = 2.0f * view.camera.distance * std::tan(0.5f * view.camera.fieldOfView) /
                        static_cast<float>(view.size.y);
    const vec3 target = view.camera.target;
    const int pictures = std::exchange(view.samples, 1);
    std::size_t covered = 0;
    for (int i = 0; i < pictures; ++i) {
        const auto shift = [&](double step) {
            return pixel * static_cast<float>(std::fmod(i * step, 1.0));
        };
        view.camera.target = target + shift(0.7548776662466927) * view.camera.right() +
                             shift(0.5698402909980532) * view.camera.up();
        const Pixels seen = picture(renderer, document, view);
        for (std::size_t p = 0; p < seen.size(); p += 4)
            covered += !(seen[p] == 0 && seen[p + 1] == 255 && seen[p + 2] == 0);
    }
    return static_cast<double>(covered) / pictures;
}

// Root of the mean square of the differences.
inline double distanceOf(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace pelage::test
