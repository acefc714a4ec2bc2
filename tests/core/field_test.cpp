// field_test.cpp -- the promises of field.h.
#include "core/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/core/reading.h"

namespace pelage {
namespace {

TEST(Field, IsASquareOfTwoMetresFromAbove) {
    for (const std::size_t wanted : {std::size_t{2000}, std::size_t{70000}}) {
        const auto skin = makeSkin(makeField(wanted));
        EXPECT_NEAR(static_cast<double>(skin->triangles.size()), static_cast<double>(wanted),
                    0.1 * static_cast<double>(wanted));
        for (const vec3 corner : {skin->lower, skin->upper}) {
            EXPECT_EQ(std::abs(corner.x), 1.0f);
            EXPECT_EQ(std::abs(corner.z), 1.0f);
            EXPECT_LE(corner.y, 0.1f);
            EXPECT_GE(corner.y, -0.5f);
        }
        EXPECT_GT(skin->upper.y - skin->lower.y, 0.04f);
        for (const uvec3 t : skin->triangles) {
            const vec3 a = skin->vertices[t.x].position;
            const vec3 face = glm::normalize(
                glm::cross(skin->vertices[t.y].position - a, skin->vertices[t.z].position - a));
            EXPECT_GT(face.y, 0.4f);
            EXPECT_GT(glm::dot(face, skin->vertices[t.x].normal), 0.95f);
        }
        for (const SkinVertex& v : skin->vertices) EXPECT_NEAR(glm::length(v.normal), 1.0f, 1e-5f);
    }
}

TEST(Field, AWrongCountIsRefused) {
    EXPECT_EQ(test::refusal([] { makeField(1999); }),
              "field: 1999 triangles wanted, from 2000 to 2000000 can be made");
}

TEST(Field, IsGroomedWithGrass) {
    const Document document = groomedField(2000);
    Fur grass = defaultFur();
    applyPreset(grass, presetNamed("grass"));
    EXPECT_EQ(document.fur, grass);
    float least = 1.0f, most = 0.0f;
    for (std::size_t v = 0; v < document.skin->vertices.size(); ++v) {
        least = std::min(least, document.groom.fur[v].furLength);
        most = std::max(most, document.groom.fur[v].furLength);
    }
    EXPECT_GT(least, 0.02f);
    EXPECT_GT(most, 1.5f * least);
    EXPECT_LT(most, 0.2f);
}

}  // namespace
}  // namespace pelage
