// camera_gltest.cpp -- the promises of app/render/camera.h; needs no context.
#include "app/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

bool finite(const mat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

TEST(Camera, TargetLiesInTheMiddleOfThePictureAtItsDistance) {
    for (const float yaw : {-3.0f, 0.0f, 0.5f, 2.0f})
        for (const float pitch : {-1.5707964f, -0.4f, 0.0f, 1.0f, 1.5707964f}) {
            Camera camera;
            camera.target = vec3(1, 2, 3);
            camera.distance = 4.0f;
            camera.yaw = yaw;
            camera.pitch = pitch;
            const vec4 seen = camera.view() * vec4(camera.target, 1.0f);
            EXPECT_NEAR(seen.x, 0.0f, 1e-5f);
            EXPECT_NEAR(seen.y, 0.0f, 1e-5f);
            EXPECT_NEAR(seen.z, -4.0f, 1e-5f);
            EXPECT_NEAR(glm::distance(camera.eye(), camera.target), 4.0f, 1e-5f);
        }
}

TEST(Camera, YawZeroLooksAlongMinusZAndGrowsToTheAnimalsLeft) {
    Camera camera;
    EXPECT_NEAR(glm::distance(camera.forward(), vec3(0, 0, -1)), 0.0f, 1e-6f);
    camera.yaw = 0.5f;  // the animal looks along +z: its left is +x
    EXPECT_GT(camera.eye().x, 0.0f);
    camera.pitch = 0.5f;
    EXPECT_GT(camera.eye().y, 0.0f);
}

TEST(Camera, FramedSeesTheWholeBallInEveryShapeOfPicture) {
    for (const float aspect : {0.3f, 1.0f, 2.5f}) {
        const Camera camera = framed(vec3(5, 0, 0), 2.0f, 0.7f, 0.3f, aspect);
        const mat4 toClip = camera.projection(aspect, vec3(5, 0, 0), 2.0f) * camera.view();
        float widest = 0.0f;
        for (int i = 0; i < 400; ++i) {
            const float a = 0.0157f * static_cast<float>(i);
            for (const vec3 side : {camera.right(), camera.up()}) {
                const vec3 point =
                    vec3(5, 0, 0) + 2.0f * (std::cos(a) * side + std::sin(a) * camera.forward());
                const vec4 clip = toClip * vec4(point, 1.0f);
                widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
            }
        }
        EXPECT_LE(widest, 1.001f) << aspect;
        EXPECT_GE(widest, 0.98f) << "wasted space at aspect " << aspect;
    }
}

TEST(Camera, DepthRangeHoldsTheBallFromOutsideAndFromWithin) {
    for (const bool orthographic : {false, true})
        for (const float distance : {0.01f, 1.0f, 3.0f, 1000.0f}) {
            Camera camera;
            camera.distance = distance;
            camera.orthographic = orthographic;
            const mat4 toClip = camera.projection(1.5f, vec3(0), 1.0f) * camera.view();
            ASSERT_TRUE(finite(toClip));
            const vec4 back = toClip * vec4(-1.0f * vec3(0, 0, 1), 1.0f);
            EXPECT_LE(back.z, back.w * 1.0001f) << distance;
            if (distance > 1.0f || orthographic) {
                const vec4 front = toClip * vec4(0, 0, 1, 1);
                EXPECT_GE(front.z, -front.w * 1.001f - 1e-4f) << distance;
            }
        }
}

}  // namespace
}  // namespace pelage
