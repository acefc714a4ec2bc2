// base_color_test.cpp -- colors of materials at places of the skin.
#include "core/base_color.h"

#include <gtest/gtest.h>

#include "core/animal.h"

namespace pelage {
namespace {

// Colors of every hundredth triangle of an animal, a little off its middle, whose source was
// changed.
template <typename Change>
std::vector<vec3> colorsOf(const Change& change) {
    Source source = makeAnimal(2000);
    change(source);
    const auto skin = makeSkin(std::move(source));
    const BaseColor color(*skin);
    std::vector<vec3> colors;
    for (uint t = 0; t < skin->triangles.size(); t += 100)
        colors.push_back(color.at(t, vec3(0.2f, 0.3f, 0.5f)));
    return colors;
}

TEST(BaseColor, IsFactorTimesVertexColorTimesARepeatingPicture) {
    const std::vector<vec3> plain = colorsOf([](Source&) {});
    EXPECT_NE(plain.front(), plain.back());
    const std::vector<vec3> repeated = colorsOf([](Source& source) {
        for (vec2& uv : source.uvs) uv += vec2(3.0f, -2.0f);
    });
    const std::vector<vec3> tinted = colorsOf([](Source& source) {
        source.materials[0].baseColor = vec4(0.5f, 0.25f, 1.0f, 1.0f);
        source.colors.assign(source.positions.size(), vec4(1.0f, 0.5f, 0.25f, 1.0f));
    });
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_LT(glm::distance(repeated[i], plain[i]), 2e-3f);
        EXPECT_LT(glm::distance(tinted[i], plain[i] * vec3(0.5f, 0.125f, 0.25f)), 1e-6f);
    }
}

TEST(BaseColor, ADamagedPictureAndNoMaterialAreWhite) {
    for (const vec3& color : colorsOf([](Source& source) { source.images[0].bytes.resize(20); }))
        EXPECT_EQ(color, vec3(1.0f));
    for (const vec3& color : colorsOf([](Source& source) { source.parts[0].material = -1; }))
        EXPECT_EQ(color, vec3(1.0f));
}

}  // namespace
}  // namespace pelage
