// outward_test.cpp -- what may be drawn without its back faces.
#include "core/outward.h"

#include <gtest/gtest.h>

#include "core/skin.h"
#include "test_skins.h"

namespace pelage {
namespace {

Source turnedInside(Source source) {
    for (uvec3& t : source.triangles) std::swap(t.y, t.z);
    return source;
}

Source apart(const Source& a, const Source& b) {
    std::vector<vec3> positions = a.positions;
    for (const vec3 p : b.positions) positions.push_back(p + vec3(10.0f, 0.0f, 0.0f));
    std::vector<uvec3> triangles = a.triangles;
    for (const uvec3 t : b.triangles)
        triangles.push_back(t + static_cast<uint>(a.positions.size()));
    return test::oneMesh(positions, triangles);
}

bool facesOutward(const Source& source) {
    Source copy = test::oneMesh(source.positions, source.triangles, source.parts[0].toWorld);
    return makeSkin(std::move(copy))->outward;
}

TEST(Outward, AClosedMeshThatFacesOutwardsIsOutward) {
    EXPECT_TRUE(facesOutward(test::ball(2)));
    EXPECT_TRUE(facesOutward(apart(test::ball(1), test::ball(2))));
}

TEST(Outward, AnInsideOutPartIsNotOutward) {
    EXPECT_FALSE(facesOutward(turnedInside(test::ball(2))));
    EXPECT_FALSE(facesOutward(apart(test::ball(1), turnedInside(test::ball(1)))));
}

TEST(Outward, AMirroredMeshIsNotOutward) {
    Source ball = test::ball(2);
    ball.parts[0].toWorld = mat4(glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    EXPECT_FALSE(facesOutward(ball));
}

TEST(Outward, AnOpenMeshIsNotOutward) {
    Source ball = test::ball(2);
    ball.triangles.pop_back();
    EXPECT_FALSE(facesOutward(ball));
    EXPECT_FALSE(facesOutward(test::sheet(3)));
}

TEST(Outward, DistanceFromTheOriginDoesNotMatter) {
    Source ball = test::ball(2);
    for (vec3& p : ball.positions) p += vec3(1e4f, -2e4f, 3e4f);
    EXPECT_TRUE(facesOutward(ball));
}

}  // namespace
}  // namespace pelage
