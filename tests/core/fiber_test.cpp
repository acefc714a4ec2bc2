// fiber_test.cpp -- energy and symmetry of the light that a hair scatters (shaders/fiber.glsl).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/coat.h"
#include "core/strand_inline.h"
#include "tests/figures.h"

namespace pelage {
namespace {

constexpr double kPi = 3.14159265358979323846;

// From a hair along x: so far from its normal plane, and so far around it.
vec3 direction(double degrees, double around) {
    const double angle = degrees * kPi / 180.0;
    return vec3(std::sin(angle), std::cos(angle) * std::cos(around),
                std::cos(angle) * std::sin(around));
}

const vec3 kAlong(1, 0, 0);

FiberLight lit(const Coat& coat, vec3 toKey, vec3 toEye) {
    Strand s{};
    s.tone = 1.0f;
    return fiberLitBy(s, coat, toKey, {1.0f, vec3(0.0f)}, vec3(1.0f), 1.0f, kAlong, toEye);
}

Coat whiteCoat(float shininess) {
    Coat coat = defaultFur().over;
    coat.ambient = vec3(0.0f);
    coat.diffuse = coat.specular = coat.rootColor = coat.tipColor = vec3(1.0f);
    coat.shininess = shininess;
    return coat;
}

// The lobe of Kajiya and Kay: what it sends into all directions, per light that the hair
// intercepts, is pi^2 of its color; half of it is used. Shaded by a normal that turns around the
// hair, the other half adds 1/pi of that.
TEST(Fiber, DiffuseLightIsAsMuchAsTheLobeOfKajiyaAndKayHas) {
    const Coat coat = whiteCoat(16.0f);
    double away = 0.0, turning = 0.0;
    for (double inclination = -85.0; inclination <= 85.0; inclination += 5.0) {
        const vec3 toKey = direction(inclination, 0.3);
        const double intercepted = std::cos(inclination * kPi / 180.0);
        double lobe = 0.0, all = 0.0;
        for (int o = -90; o < 90; ++o) {
            const vec3 toEye = direction(o + 0.5, 0.0);
            FiberLight f = lit(coat, toKey, toEye);
            f.specular = vec3(0.0f);
            const double cosine = std::cos((o + 0.5) * kPi / 180.0);
            const double area = 2.0 * kPi * cosine * cosine * kPi / 180.0;  // of the ring, seen
            lobe += radianceOf(f, -toKey, toKey).x * area / intercepted;
            for (int k = 0; k < 90; ++k)
                all += radianceOf(f, direction(0.0, k * kPi / 45.0), toKey).x * area /
                       (90.0 * intercepted);
        }
        away = std::max(away, std::abs(lobe / (0.5 * kPi * kPi) - 1.0));
        turning = std::max(turning, std::abs(all / (0.5 * kPi * kPi * (1.0 + 1.0 / kPi)) - 1.0));
    }
    using test::reached;
    reached("S3", "diffuse light of a hair, relative, light up to 85 degrees off", away, 1e-3);
    reached("S3", "the same with shading normals all around the hair", turning, 1e-3);
}

TEST(Fiber, LobesAreTheSameWithLightAndEyeExchanged) {
    double worst = 0.0;
    for (const float shininess : {1.0f, 16.0f, 256.0f})
        for (double a = -89.0; a <= 89.0; a += 8.9)
            for (double b = -89.0; b <= 89.0; b += 8.9)
                for (const double around : {0.0, 1e-7, 1e-3, 1.0, 2.0, kPi - 1e-3, kPi}) {
                    const vec3 l = direction(a, 0.0), v = direction(b, around);
                    const Coat coat = whiteCoat(shininess);
                    const FiberLight there = lit(coat, l, v), back = lit(coat, v, l);
                    // The diffuse lobe is this over the sine of the light.
                    const float off =
                        std::max(std::abs(there.specular.x - back.specular.x),
                                 std::abs(there.sine * there.diffuse.x / sineBetween(kAlong, l) -
                                          back.sine * back.diffuse.x / sineBetween(kAlong, v)));
                    worst = std::max(worst, static_cast<double>(off));
                }
    test::reached("S4", "lobes with light and eye exchanged, as drawn (no others are modelled)",
                  worst, 1e-6);
}

TEST(Fiber, LightAlongTheHairIsNoBrighterThanItsColors) {
    double brightest = 0.0;
    for (const float shininess : {1.0f, 256.0f})
        for (const double off : {0.0, 1e-7, 1e-3, 1.0})
            for (const double a : {90.0 - off, off - 90.0})
                for (const double b : {90.0 - off, off - 90.0, 0.0}) {
                    const vec3 l = direction(a, 0.0), v = direction(b, 2.0);
                    const FiberLight f = lit(whiteCoat(shininess), l, v);
                    const double seen = radianceOf(f, direction(0.0, 1.0), l).x;
                    ASSERT_TRUE(std::isfinite(seen));
                    brightest = std::max(brightest, seen);
                }
    test::reached("S5", "light and eye along the hair: radiance, of diffuse and specular 1",
                  brightest, 2.0);
}

}  // namespace
}  // namespace pelage
