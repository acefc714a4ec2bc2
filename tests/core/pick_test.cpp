// pick_test.cpp -- what the eyedropper reads.
#include "core/pick.h"

#include <gtest/gtest.h>

#include "canvas.h"

namespace pelage {
namespace {

TEST(Pick, IsTheBarycentricMeanInTheWorld) {
    test::Canvas canvas(test::sheet(4, mat4(mat3(10.0f))));  // one mesh unit is 10 m
    test::shuffle(canvas, 9);
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v)
        canvas.groom.mask.edit(v) = canvas.groom.fur[v].density;
    const auto hit = canvas.query.cast({1.3f, 5.0f, -0.7f}, {0.0f, -1.0f, 0.0f});
    ASSERT_TRUE(hit);
    const Picked picked = pickedAt(*canvas.skin, canvas.groom, *hit);
    const uvec3 corners = canvas.skin->triangles[hit->triangle];
    const float weights[] = {1.0f - hit->u - hit->v, hit->u, hit->v};
    float length = 0.0f, density = 0.0f;
    vec3 tint(0.0f);
    for (int i = 0; i < 3; ++i) {
        const FurVertex& fur = canvas.groom.fur[corners[i]];
        length += weights[i] * 10.0f * fur.furLength;
        density += weights[i] * fur.density;
        tint += weights[i] * fur.tint;
    }
    EXPECT_NEAR(picked.fur.furLength, length, 1e-6f);
    EXPECT_NEAR(picked.fur.density, density, 1e-6f);
    EXPECT_NEAR(picked.mask, density, 1e-6f);
    EXPECT_LT(glm::distance(picked.fur.tint, tint), 1e-6f);
}

TEST(Pick, AtACornerItHasTheCornersOwnValues) {
    test::Canvas canvas(test::ball(1));
    test::shuffle(canvas, 2);
    SkinHit hit;
    hit.triangle = 7;
    hit.v = 1.0f;
    const uint v = canvas.skin->triangles[7].z;
    const Picked picked = pickedAt(*canvas.skin, canvas.groom, hit);
    EXPECT_EQ(picked.fur.furLength, canvas.groom.fur[v].furLength);
    EXPECT_EQ(picked.fur.density, canvas.groom.fur[v].density);
    EXPECT_EQ(picked.fur.tint, canvas.groom.fur[v].tint);
}

}  // namespace
}  // namespace pelage
