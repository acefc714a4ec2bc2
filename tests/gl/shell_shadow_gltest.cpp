// shell_shadow_gltest.cpp -- the shadows of single hairs in shells: against hairs that are reckoned
// one by one, and what they leave of the light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/shell_data.h"
#include "app/render/shell_tile.h"
#include "tests/gl/furry_scenes.h"
#include "tests/gl/tile_roots.h"

namespace pelage {
namespace {

constexpr float kStraight = 0.45f;  // share of the light that a hair stops

// Light so many degrees from straight above, and turned so far about the axis y.
vec3 lightFrom(float degrees, float turn) {
    const float a = glm::radians(degrees);
    return {std::sin(a) * std::cos(turn), std::cos(a), std::sin(a) * std::sin(turn)};
}

// What a compute shader with the functions of shell_shadow.glsl writes into `results`, a vec4 for
// each of its inputs.
std::vector<vec4> computed(const std::string& body, const std::vector<vec4>& inputs) {
    const gl::ProgramName program =
        test::computeProgram(
            test::shaderHead({"frame.glsl", "strand.glsl", "fiber.glsl", "shell_data.glsl",
                              "shell_ground.glsl", "shell_hair.glsl", "shell_shade.glsl"},
                             {"SHADOWS"}) +
            R"(
layout(local_size_x = 64) in;
layout(std430, binding = 8) readonly buffer Inputs { vec4 inputs[]; };
layout(std430, binding = 9) writeonly buffer Results { vec4 results[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(results.length())) return;
)" + body + "}\n");
    const gl::Buffer in = test::bufferOf(inputs);
    gl::Buffer results;
    results.resize(inputs.size() * sizeof(vec4));
    in.bindStorage(8);
    results.bindStorage(9);
    glUseProgram(program.name());
    glDispatchCompute(static_cast<GLuint>((inputs.size() + 63) / 64), 1, 1);
    return test::valuesOf<vec4>(results.name(), inputs.size());
}

// h tan(theta) (j - i) / N by hand: hair of 4 cm in 16 layers.
TEST(ShellShadows, FallAsFarAsideAsThePaperSays) {
    struct Case {
        float degrees;
        int lower, upper;
        float shift;  // m
    };
    const std::vector<Case> cases = {{0.0f, 0, 16, 0.0f},         {45.0f, 0, 16, 0.04f},
                                     {45.0f, 3, 5, 0.005f},       {60.0f, 0, 16, 0.0692820f},
                                     {60.0f, 8, 9, 0.00433013f},  {30.0f, 12, 16, 0.00577350f},
                                     {75.0f, 15, 16, 0.00933013f}};
    std::vector<vec4> inputs;
    for (const Case& c : cases)
        inputs.emplace_back(lightFrom(c.degrees, 0.5f),
                            0.04f * static_cast<float>(c.upper - c.lower) / 16.0f);
    const std::vector<vec4> shifts = computed(
        "results[i] = vec4(shadowShift(vec3(0.0, 1.0, 0.0), inputs[i].xyz, inputs[i].w), 0.0);",
        inputs);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const vec3 expected = cases[i].shift * vec3(std::cos(0.5f), 0.0f, std::sin(0.5f));
        EXPECT_LT(glm::distance(vec3(shifts[i]), expected), 1e-6f) << cases[i].degrees;
    }
}

// A skin of any curvature turns by a quarter of a radian at most under what a shadow falls aside.
TEST(ShellShadows, FallAsideByAQuarterOfTheSkinsRadiusAtMost) {
    std::vector<vec4> inputs;
    for (const float radius : {0.01f, 0.2f, -0.2f, 3.0f})
        for (const float degrees : {10.0f, 45.0f, 80.0f})
            inputs.emplace_back(lightFrom(degrees, 1.0f), 1.0f / radius);
    const std::vector<vec4> shifts = computed(R"(
    vec3 up = vec3(0.0, 1.0, 0.0);
    float height = shadowHeight(up, inputs[i].xyz, inputs[i].w);
    results[i] = vec4(shadowShift(up, inputs[i].xyz, height), height);
)",
                                              inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const float radius = 1.0f / std::abs(inputs[i].w);
        EXPECT_NEAR(glm::length(vec3(shifts[i])), 0.25f * radius, 1e-4f * radius);
        EXPECT_GT(shifts[i].w, 0.0f);
    }
}

// A coat of one kind of hair on a flat skin: t(1-t) a + t^2 b, m.
struct Coats {
    vec3 a, b;
    float taper;
};

constexpr float kPerArea = 16000.0f, kWidth = 2e-3f, kHeight = 0.064f;

// Light past the hairs of the nearest layers at (root x, root z, t) of each place, as a logarithm:
// by the shader, and of hairs tested one by one.
std::vector<float> logsOfShader(const Coats& coats, vec3 light, const std::vector<vec3>& places,
                                float highest = 1e9f) {
    ShellData data;
    data.over = {tilePeriod(kPerArea), kWidth, coats.taper, 0.0f};
    data.leastWidth = 0.0f;
    const gl::Buffer block = test::bufferOf<ShellData>({data});
    const gl::Buffer tile = test::bufferOf(tileTexels());
    const gl::Texture rows = gl::makeTexture(tile, GL_RG32UI);
    block.bindUniform(binding::shells);
    glBindTextureUnit(6, rows.name());
    const auto text = [](vec3 v) {
        return "vec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " +
               std::to_string(v.z) + ")";
    };
    std::vector<vec4> inputs;
    for (const vec3 place : places) inputs.emplace_back(place, 0.0f);
    const std::vector<vec4> results = computed(
        "Ground g;\ng.density = 1.0;\ng.furLength = 0.0;\nShadowRay ray;\n"
        "ray.root = vec3(inputs[i].x, 0.0, inputs[i].y);\nray.normal = vec3(0.0, 1.0, 0.0);\n"
        "ray.toKey = " +
            text(light) + ";\nHair hair = hairOf(Curve(" + text(coats.a) + ", " + text(coats.b) +
            "), 0.0, ray.normal, 0.0);\nray.aside = asideAt(hair, inputs[i].z);\n"
            "ray.height = heightAt(hair, inputs[i].z);\nray.highest = " +
            std::to_string(highest) +
            ";\n"
            "results[i] = vec4(logPast(ray, hair, shellOver, 0u, g, 1e9));\n",
        inputs);
    std::vector<float> logs;
    for (const vec4 result : results) logs.push_back(result.x);
    return logs;
}

// Hairs with a round cross-section, all straight and alike, between the distances from the light's
// beginning that the shader looks at: 0.6 to 4.6 ways from root to root.
std::vector<float> logsOfHairs(const Coats& coats, vec3 light, const std::vector<vec3>& places) {
    const std::vector<vec2> roots = test::rootsAround(kPerArea);
    const float spacing = tilePeriod(kPerArea) / 32.0f;
    const vec3 along = coats.b;  // from root to tip
    // On the skin, from the root of the hair at its beginning to that of a hair that the light
    // passes at t, for each t.
    const vec3 rate = light * (along.y / light.y) - along;
    const float perT = glm::length(rate);
    const float slant = glm::length(glm::cross(light, along)) / (perT * light.y);
    std::vector<float> logs;
    for (const vec3 place : places) {
        const float from = std::min(1.0f, place.z + std::max(0.6f * spacing, kWidth) / perT);
        const float to = std::min(1.0f, from + 4.0f * spacing / perT);
        float met = 0.0f;
        for (const vec2 root : roots) {
            const vec2 offset = root - vec2(place.x, place.y);
            if (glm::dot(offset, offset) > 36.0f * spacing * spacing) continue;
            // The nearest points of two lines.
            const vec3 w = vec3(offset.x, 0.0f, offset.y) - place.z * along;
            const vec3 n = glm::normalize(glm::cross(light, along));
            const vec3 across = w - glm::dot(w, n) * n;
            // across = s light - u along
            const float bb = glm::dot(along, along), lb = glm::dot(light, along);
            const float u =
                (lb * glm::dot(across, light) - glm::dot(across, along)) / (bb - lb * lb);
            const float radius = 0.5f * kWidth * (1.0f - coats.taper * u);
            if (u >= from && u <= to && std::abs(glm::dot(w, n)) < radius) met += 1.0f;
        }
        const float mean = kPerArea * kWidth * (1.0f - 0.5f * coats.taper * (from + to)) *
                           (to - from) * perT * slant;
        logs.push_back(met * std::log(1.0f - kStraight) + kStraight * mean);
    }
    return logs;
}

// Places on hairs are places anywhere: which hair is its own does not count.
std::vector<vec3> places() {
    std::vector<vec3> result;
    for (uint i = 0; i < 4096; ++i)
        result.emplace_back(0.5f * rand01(3 * i) - 0.25f, 0.5f * rand01(3 * i + 1) - 0.25f,
                            0.9f * rand01(3 * i + 2));
    return result;
}

TEST(ShellShadows, FallWhereTheProjectionOfStraightHairsFalls) {
    const std::vector<vec3> all = places();
    for (const float lean : {0.0f, 0.6f}) {
        const vec3 along = kHeight * vec3(lean, 1.0f, 0.0f);
        for (const float degrees : {20.0f, 45.0f, 65.0f}) {
            const Coats coats{along, along, 0.8f};
            const vec3 light = lightFrom(degrees, 2.0f);
            const std::vector<float> found = logsOfShader(coats, light, all);
            const std::vector<float> hairs = logsOfHairs(coats, light, all);
            int same = 0, shaded = 0;
            double sum = 0.0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                same += std::abs(found[i] - hairs[i]) < 0.1f;
                shaded += hairs[i] < -0.1f;
                sum += static_cast<double>(found[i] - hairs[i]);
            }
            const double count = static_cast<double>(all.size());
            std::printf("%.0f degrees, lean %.1f: %.4f as the hairs, %.3f in shadow, mean %+.4f\n",
                        static_cast<double>(degrees), static_cast<double>(lean), same / count,
                        shaded / count, sum / count);
            EXPECT_GT(shaded, 0.05 * count);
            EXPECT_GT(same, 0.97 * count);
            EXPECT_LT(std::abs(sum / count), 0.01);
        }
    }
}

// Where the skin turns away at once, hair keeps the light of its coat.
TEST(ShellShadows, AreNoneOfHairBeyondTheHeightThatIsLookedAt) {
    const vec3 along(0.0f, kHeight, 0.0f);
    const std::vector<vec3> all = places();
    for (const float each : logsOfShader({along, along, 0.8f}, lightFrom(45.0f, 2.0f), all, 0.0f))
        EXPECT_EQ(each, 0.0f);
}

// Both coats as they are at first on a flat skin, seen slanted.
struct Patch {
    Document document = test::evenDocument(test::sheet(2));
    View view = test::viewFromAbove(80);

    Patch() {
        document.groom = test::evenGroom(
            *document.skin, {glm::normalize(vec3(0.4f, 1.0f, 0.0f)), 0.06f, vec3(1.0f), 1.0f});
        document.fur.hairs = 120000;
        view.camera.pitch = glm::radians(50.0f);
        view.camera.distance *= 0.2f;
        view.shells = Shells::swept;
        view.samples = 8;
    }
};

struct Brightness {
    double mean = 0.0, spread = 0.0;  // standard deviation
};

Brightness brightnessOf(const std::vector<float>& light) {
    Brightness b;
    double squares = 0.0;
    for (const float value : light) {
        b.mean += static_cast<double>(value) / static_cast<double>(light.size());
        squares += static_cast<double>(value * value) / static_cast<double>(light.size());
    }
    b.spread = std::sqrt(std::max(0.0, squares - b.mean * b.mean));
    return b;
}

// Single hairs get darker and lighter, and their mean stays.
TEST(ShellShadows, LeaveTheMeanBrightnessWhatItIs) {
    Patch patch;
    Renderer renderer;
    for (const float pitch : {30.0f, 80.0f}) {
        patch.view.camera.pitch = glm::radians(pitch);
        for (const Shells shells : {Shells::swept, Shells::plain, Shells::instanced}) {
            patch.view.shells = shells;
            patch.view.layers = shells == Shells::swept ? 0u : 32u;
            const auto seen = [&](bool shadows) {
                patch.view.shellShadows = shadows;
                return brightnessOf(
                    test::linear(test::picture(renderer, patch.document, patch.view)));
            };
            const Brightness without = seen(false), with = seen(true);
            std::printf("%.0f degrees, way %d: %.4f as bright, spread %.4f, without %.4f\n",
                        static_cast<double>(pitch), static_cast<int>(shells),
                        with.mean / without.mean, with.spread, without.spread);
            EXPECT_NEAR(with.mean / without.mean, 1.0, 0.01);
            EXPECT_GT(with.spread, 1.015 * without.spread);
        }
    }
}

}  // namespace
}  // namespace pelage
