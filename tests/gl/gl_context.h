// gl_context.h -- the OpenGL context of the tests, compute shaders written in them, and pictures.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/render/gl.h"
#include "app/render/headless.h"
#include "app/render/program.h"
#include "app/render/renderer.h"
#include "core/source_check.h"

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

// Shared files, expanded, under the version line of every shader.
inline std::string shaderHead(const std::vector<std::string>& files) {
    std::string text = "#version 450 core\n";
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

using Pixels = std::vector<unsigned char>;  // RGBA8, as Renderer::pixels

// Draws until the picture is finished.
inline FrameStats finish(Renderer& renderer, const Document& document, const View& view) {
    FrameStats stats;
    do stats = renderer.draw(document, view);
    while (!stats.finished);
    return stats;
}

inline Pixels picture(Renderer& renderer, const Document& document, const View& view) {
    finish(renderer, document, view);
    return renderer.pixels();
}

// The color channels in linear light, three a pixel.
inline std::vector<float> linear(const Pixels& pixels) {
    std::vector<float> values;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (i % 4 != 3) values.push_back(linearFromSrgb(static_cast<float>(pixels[i]) / 255.0f));
    return values;
}

// The share of each pixel that hair covers, whatever its color: what a change of the background
// from black to white leaves the same. Hair must be darker than white.
inline std::vector<float> coverage(Renderer& renderer, const Document& document, View view) {
    view.showSkin = false;
    view.background = vec3(0.0f);
    const std::vector<float> onBlack = linear(picture(renderer, document, view));
    view.background = vec3(1.0f);
    const std::vector<float> onWhite = linear(picture(renderer, document, view));
    std::vector<float> covered;
    for (std::size_t i = 1; i < onBlack.size(); i += 3)
        covered.push_back(1.0f - (onWhite[i] - onBlack[i]));
    return covered;
}

inline double sumOf(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum;
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
