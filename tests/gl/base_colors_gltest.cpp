// base_colors_gltest.cpp -- pictures arrive on the GPU with their colors.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "app/render/base_colors.h"
#include "core/files.h"
#include "tests/gl/test_pictures.h"

namespace pelage {
namespace {

// Linear color of a layer at a texture coordinate, as shaders see it.
std::vector<vec4> sampled(const BaseColors& colors, const std::vector<vec4>& places) {
    const gl::ProgramName program = test::computeProgram(R"(#version 450 core
        layout(local_size_x = 1) in;
        layout(binding = 0) uniform sampler2DArray baseColors;
        layout(std430, binding = 0) buffer Values { vec4 values[]; };  // uv, layer; then color
        void main() {
            uint i = gl_GlobalInvocationID.x;
            values[i] = textureLod(baseColors, values[i].xyz, 0.0);
        })");
    const gl::Buffer values = test::bufferOf(places);
    values.bindStorage(0);
    glBindTextureUnit(0, colors.texture.name());
    glUseProgram(program.name());
    glDispatchCompute(static_cast<GLuint>(places.size()), 1, 1);
    return test::valuesOf<vec4>(values.name(), places.size());
}

void expectEncoded(vec4 linear, glm::ivec3 encoded) {
    for (int c = 0; c < 3; ++c) {
        const float low =
            linearFromSrgb(std::max(0.0f, static_cast<float>(encoded[c] - 2) / 255.0f));
        const float high =
            linearFromSrgb(std::min(1.0f, static_cast<float>(encoded[c] + 2) / 255.0f));
        EXPECT_GE(linear[c], low) << "channel " << c;
        EXPECT_LE(linear[c], high) << "channel " << c;
    }
}

Source withImages(std::vector<std::vector<std::byte>> images) {
    Source source;
    for (auto& bytes : images) {
        SourceMaterial material;
        material.image = static_cast<int>(source.images.size());
        material.baseColor = vec4(0.5f, 0.25f, 1.0f, 1.0f);
        source.images.push_back({"picture", std::move(bytes)});
        source.materials.push_back(material);
    }
    return source;
}

constexpr glm::ivec3 kOrange(230, 120, 17), kTeal(3, 140, 150);

TEST(BaseColors, AColorComesOutRight) {
    const auto png = test::twoColorPng(ivec2(16), kOrange, kTeal);
    const BaseColors colors = makeBaseColors(withImages({png}));
    ASSERT_EQ(colors.materials.size(), 2u);  // and the white one
    EXPECT_EQ(colors.materials[0].layer, 0.0f);
    EXPECT_EQ(colors.materials[0].color, vec3(0.5f, 0.25f, 1.0f));
    const auto seen =
        sampled(colors, {{0.25f, 0.5f, 0, 0}, {0.75f, 0.1f, 0, 0}, {1.25f, -3.5f, 0, 0}});
    expectEncoded(seen[0], kOrange);
    expectEncoded(seen[1], kTeal);
    expectEncoded(seen[2], kOrange);  // pictures repeat
}

TEST(BaseColors, TheFirstRowIsAtTheTop) {
    std::vector<unsigned char> rgba;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            rgba.insert(rgba.end(), {static_cast<unsigned char>(y < 8 ? 255 : 0), 0, 0, 255});
    const BaseColors colors = makeBaseColors(withImages({test::pngOf(ivec2(16), rgba)}));
    const auto seen = sampled(colors, {{0.5f, 0.2f, 0, 0}, {0.5f, 0.8f, 0, 0}});
    EXPECT_FLOAT_EQ(seen[0].x, 1.0f);  // v = 0 is the top
    EXPECT_FLOAT_EQ(seen[1].x, 0.0f);
}

TEST(BaseColors, AnUndecodablePictureCountsAsWhite) {
    auto broken = test::twoColorPng(ivec2(16), kOrange, kTeal);
    broken.resize(broken.size() / 2);
    const BaseColors colors =
        makeBaseColors(withImages({broken, test::twoColorPng(ivec2(16), kOrange, kTeal), {}}));
    ASSERT_EQ(colors.materials.size(), 4u);
    EXPECT_LT(colors.materials[0].layer, 0.0f);
    EXPECT_EQ(colors.materials[0].color, vec3(0.5f, 0.25f, 1.0f));  // its factor is kept
    EXPECT_EQ(colors.materials[1].layer, 1.0f);
    EXPECT_LT(colors.materials[2].layer, 0.0f);
    expectEncoded(sampled(colors, {{0.25f, 0.5f, 1, 0}})[0], kOrange);
}

TEST(BaseColors, PicturesOfSeveralSizesAreScaledToTheLargest) {
    const BaseColors colors =
        makeBaseColors(withImages({test::twoColorPng(ivec2(8), kOrange, kTeal),
                                   test::twoColorPng(ivec2(32, 16), kTeal, kOrange)}));
    GLint width = 0, height = 0;
    glGetTextureLevelParameteriv(colors.texture.name(), 0, GL_TEXTURE_WIDTH, &width);
    glGetTextureLevelParameteriv(colors.texture.name(), 0, GL_TEXTURE_HEIGHT, &height);
    EXPECT_EQ(ivec2(width, height), ivec2(32, 16));
    const auto seen = sampled(colors, {{0.2f, 0.5f, 0, 0}, {0.8f, 0.5f, 0, 0}, {0.2f, 0.5f, 1, 0}});
    expectEncoded(seen[0], kOrange);
    expectEncoded(seen[1], kTeal);
    expectEncoded(seen[2], kTeal);
}

TEST(BaseColors, ManyLargePicturesShareABoundedArray) {
    const auto large = test::twoColorPng(ivec2(1024), kOrange, kTeal);
    const BaseColors colors =
        makeBaseColors(withImages(std::vector<std::vector<std::byte>>(100, large)));
    GLint size[3];
    glGetTextureLevelParameteriv(colors.texture.name(), 0, GL_TEXTURE_WIDTH, &size[0]);
    glGetTextureLevelParameteriv(colors.texture.name(), 0, GL_TEXTURE_HEIGHT, &size[1]);
    glGetTextureLevelParameteriv(colors.texture.name(), 0, GL_TEXTURE_DEPTH, &size[2]);
    EXPECT_LE(size[0] * size[1] * size[2] * 4, 1 << 28);
    const auto seen = sampled(colors, {{0.2f, 0.5f, 0, 0}, {0.8f, 0.5f, 99, 0}});
    expectEncoded(seen[0], kOrange);
    expectEncoded(seen[1], kTeal);
}

TEST(BaseColors, PicturesPastTheLayersCountAsWhite) {
    const auto small = test::twoColorPng(ivec2(2), kOrange, kTeal);
    const BaseColors colors =
        makeBaseColors(withImages(std::vector<std::vector<std::byte>>(2100, small)));
    EXPECT_EQ(colors.materials[2047].layer, 2047.0f);
    EXPECT_LT(colors.materials[2048].layer, 0.0f);
}

TEST(BaseColors, AHeaderThatPromisesMoreThanItsBytesHoldCountsAsWhite) {
    auto picture = test::twoColorPng(ivec2(2), kOrange, kTeal);
    // Width and height, big-endian, 16384 each.
    for (const std::size_t at : {18u, 22u}) picture[at] = std::byte{0x40};
    for (const std::size_t at : {19u, 23u}) picture[at] = std::byte{0};
    const BaseColors colors = makeBaseColors(withImages({picture}));
    EXPECT_LT(colors.materials[0].layer, 0.0f);
    GLint width = 0;
    glGetTextureLevelParameteriv(colors.texture.name(), 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 1);
}

TEST(BaseColors, NoPicturesGiveOneWhiteMaterial) {
    const BaseColors colors = makeBaseColors(Source{});
    ASSERT_EQ(colors.materials.size(), 1u);
    EXPECT_LT(colors.materials[0].layer, 0.0f);
    EXPECT_EQ(colors.materials[0].color, vec3(1.0f));
    EXPECT_TRUE(colors.texture);
}

}  // namespace
}  // namespace pelage
