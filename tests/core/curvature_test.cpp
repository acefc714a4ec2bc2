// curvature_test.cpp -- the promises of curvature.h on shapes whose curvature is known.
#include "core/curvature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_skins.h"

namespace pelage {
namespace {

// A piece of the surface that `at` gives over [-1,1]^2, with the normals that `normal` gives.
template <typename At, typename Normal>
Skin surfaceOf(const At& at, const Normal& normal) {
    Source source = test::sheet(40);
    for (vec3& p : source.positions) p = at(2.0f * p.x, 2.0f * p.z);
    Skin skin = *makeSkin(std::move(source));
    for (SkinVertex& v : skin.vertices) v.normal = normal(v.position);
    return skin;
}

// As they are.
std::vector<vec3> normalsOf(const Skin& skin) { return smoothNormals(skin, 0.0f); }

TEST(Curvature, OfABallIsOneOverItsRadiusInEveryDirection) {
    Skin skin = *makeSkin(test::ball(4));
    for (SkinVertex& v : skin.vertices) {
        v.normal = glm::normalize(v.position);
        v.position *= 2.5f;
    }
    const std::vector<Curvature> curvatures = curvaturesOf(skin, normalsOf(skin));
    for (uint v = 0; v < skin.vertices.size(); v += 17) {
        const vec3 a = anyTangent(skin.vertices[v].normal),
                   b = glm::cross(a, skin.vertices[v].normal);
        for (const vec3 t : {a, b, glm::normalize(a + b), glm::normalize(a - b)})
            EXPECT_NEAR(curvatures[v].along(t), 0.4f, 1e-3f);
        EXPECT_NEAR(curvatures[v].along(skin.vertices[v].normal), 0.0f, 1e-5f);
    }
}

TEST(Curvature, OfATubeIsZeroAlongItAndNegativeInside) {
    const auto tube = [](float x, float z) { return vec3(std::sin(x), std::cos(x), z); };
    for (const float side : {1.0f, -1.0f}) {
        const Skin skin =
            surfaceOf(tube, [=](vec3 p) { return side * glm::normalize(vec3(p.x, p.y, 0.0f)); });
        const std::vector<Curvature> curvatures = curvaturesOf(skin, normalsOf(skin));
        for (uint v = 0; v < skin.vertices.size(); v += 13) {
            const vec3 along(0.0f, 0.0f, 1.0f);
            const vec3 around = glm::cross(along, skin.vertices[v].normal);
            EXPECT_NEAR(curvatures[v].along(along), 0.0f, 1e-3f);
            EXPECT_NEAR(curvatures[v].along(around), side, 1e-2f);
            EXPECT_NEAR(curvatures[v].along(glm::normalize(along + around)), 0.5f * side, 1e-2f);
        }
    }
}

TEST(Curvature, IsZeroWhereTheOneRingHasNoTwoDirections) {
    Source flat = test::sheet(3);
    Source line = test::oneMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
    const auto collinear = makeSkin(std::move(line)), level = makeSkin(std::move(flat));
    for (const Curvature& c : curvaturesOf(*collinear, normalsOf(*collinear)))
        EXPECT_EQ(c.along(vec3(1.0f, 0.0f, 0.0f)), 0.0f);
    for (const Curvature& c : curvaturesOf(*level, normalsOf(*level)))
        EXPECT_NEAR(c.along(vec3(1.0f, 0.0f, 0.0f)), 0.0f, 1e-6f);
}

// A small tilt of one vertex spreads like a bell whose variance each way is the square of what is
// asked for.
TEST(SmoothNormals, AreMeansUnderABellOfThisStandardDeviation) {
    for (const float perSpacing : {1.0f, 2.0f, 4.0f}) {
        Source source = test::sheet(48);
        Skin skin = *makeSkin(std::move(source));
        uint middle = 0;
        for (uint v = 0; v < skin.vertices.size(); ++v)
            if (glm::length(skin.vertices[v].position) <
                glm::length(skin.vertices[middle].position))
                middle = v;
        skin.vertices[middle].normal = glm::normalize(vec3(0.05f, 1.0f, 0.0f));
        const float deviation = perSpacing * skin.spacing;
        const std::vector<vec3> normals = smoothNormals(skin, deviation);
        double sum = 0.0, square = 0.0;
        for (uint v = 0; v < normals.size(); ++v) {
            EXPECT_NEAR(glm::length(normals[v]), 1.0f, 1e-5f);
            const vec3 way = skin.vertices[v].position - skin.vertices[middle].position;
            sum += static_cast<double>(normals[v].x);
            square += static_cast<double>(0.5f * normals[v].x * glm::dot(way, way));
        }
        EXPECT_NEAR(sum, 0.05, 0.002) << perSpacing;
        EXPECT_NEAR(std::sqrt(square / sum) / static_cast<double>(deviation), 1.0, 0.15)
            << perSpacing;
    }
}

TEST(SmoothNormals, OfABumpyBallPointAwayFromItsMiddle) {
    Source source = test::ball(5);
    Skin skin = *makeSkin(std::move(source));
    for (uint v = 0; v < skin.vertices.size(); ++v)
        skin.vertices[v].normal = glm::normalize(
            skin.vertices[v].position + 0.5f * vec3(std::sin(97.0f * static_cast<float>(v)),
                                                    std::cos(53.0f * static_cast<float>(v)),
                                                    std::sin(71.0f * static_cast<float>(v))));
    float worst = 1.0f;
    const std::vector<vec3> normals = smoothNormals(skin, 3.0f * skin.spacing);
    for (uint v = 0; v < normals.size(); ++v)
        worst = std::min(worst, glm::dot(normals[v], glm::normalize(skin.vertices[v].position)));
    EXPECT_GT(worst, 0.98f);
}

TEST(SmoothNormals, StayZeroWhereTheyCancelOut) {
    Source source = test::sheet(2);
    Skin skin = *makeSkin(std::move(source));
    for (SkinVertex& v : skin.vertices) v.normal = vec3(0.0f);
    for (const vec3 n : smoothNormals(skin, 2.0f * skin.spacing)) EXPECT_EQ(n, vec3(0.0f));
}

}  // namespace
}  // namespace pelage
