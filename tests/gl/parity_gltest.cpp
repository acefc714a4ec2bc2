// parity_gltest.cpp -- the GPU and the CPU agree about every hair.
//
// Both compile strand.glsl and fiber.glsl. Drivers may round sqrt, sin, pow and exp differently,
// and fuse multiplications with additions, so positions and colors agree within tolerances: a
// little, and some times what the last bits of the input change in a hair (one that stands upright
// and is floppy falls elsewhere for less). Decisions are precise and agree bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdio>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "app/render/frame_data.h"
#include "core/coat.h"
#include "core/elastica.h"
#include "core/strand.h"
#include "tests/core/test_skins.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

constexpr uint kHairs = 8192;  // of each fur
constexpr std::array<float, 4> kPlaces{0.0f, 0.3f, 0.7f, 1.0f};
constexpr float kAutoWidth = 1e-4f;
constexpr float kSeconds = 1.7f;  // of wind

struct Result {  // as in the shader below
    Strand strand;
    std::array<vec4, 4> points, tangents, normals, colors;  // w of a color: depth in the coat
    uint hash, id, over, pad;
    vec4 weights;  // w: rand01
};

const char* const kShader = R"(
struct Result {
    Strand strand;
    vec4 points[4]; vec4 tangents[4]; vec4 normals[4]; vec4 colors[4];
    uint hash; uint id; uint over; uint pad;
    vec4 weights;
};
const float kSeconds = 1.7;
layout(local_size_x = 64) in;
layout(std140, binding = 1) uniform FurBlock { Fur fur; };
layout(std430, binding = 0) readonly buffer A { SkinVertex skinVertices[]; };
layout(std430, binding = 1) readonly buffer B { FurVertex furVertices[]; };
layout(std430, binding = 2) readonly buffer C { uvec4 triangles[]; };
layout(std430, binding = 3) readonly buffer L { Light light; };
layout(std430, binding = 7) readonly buffer D { Root roots[]; };
layout(std430, binding = 8) writeonly buffer E { Result results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(roots.length())) return;
    Root root = roots[i];
    uvec4 t = triangles[root.triangle];
    FurVertex fa = furVertices[t.x];
    Strand s = growStrand(root, skinVertices[t.x], skinVertices[t.y], skinVertices[t.z], fa,
                          furVertices[t.y], furVertices[t.z], fur, 1e-4, kSeconds);
    Coat coat = fur.under;
    if (s.coat == 0u) coat = fur.over;
    if (coat.clump > 0.0) {
        Root of = roots[root.guide];
        uvec3 g = triangles[of.triangle].xyz;
        s = gatherStrand(s, growStrand(of, skinVertices[g.x], skinVertices[g.y], skinVertices[g.z],
                                       furVertices[g.x], furVertices[g.y], furVertices[g.z], fur,
                                       1e-4, kSeconds), coat);
    }
    float places[4] = float[4](0.0, 0.3, 0.7, 1.0);
    for (int k = 0; k < 4; ++k) {
        float at = places[k];
        vec3 tangent = strandTangent(s, at);
        float depth = depthInCoat(fur, 1e5, s.spineLength, 1e-4, 2e-5, s.coat, at);
        results[i].points[k] = vec4(strandPoint(s, at), strandWidth(s, coat.taper, at));
        results[i].tangents[k] = vec4(tangent, 0.0);
        results[i].normals[k] = vec4(strandNormal(s, tangent), 0.0);
        results[i].colors[k] = vec4(
            fiberRadiance(s, coat, light, vec3(0.9, 0.5, 0.2), at, vec3(0.0, 0.6, 0.8), depth),
            depth);
    }
    results[i].strand = s;
    results[i].hash = pcg(root.id);
    results[i].id = hairId(root.triangle, i, fur.seed);
    results[i].over = isOvercoat(root.id, fur.share) ? 1u : 0u;
    results[i].pad = 0u;
    results[i].weights = vec4(baryWeights(root.bary), rand01(root.id));
}
)";

// A crumpled ball with fur that no brush would leave: hard numbers beside ordinary ones.
struct Scene {
    std::vector<SkinVertex> skin;
    std::vector<FurVertex> fur;
    std::vector<glm::uvec4> triangles;
    std::vector<Root> roots;
};

Scene randomScene(uint seed) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kHard[] = {0.0f,   1.0f,  -1.0f, kNan, std::numeric_limits<float>::infinity(),
                               1e-30f, 1e-6f, 1e6f,  3e38f};
    test::Draws draws(seed);
    const auto hard = [&] { return kHard[draws.below(std::size(kHard))]; };
    const auto ball = makeSkin(test::ball(3));
    Scene scene;
    for (SkinVertex v : ball->vertices) {
        v.position += draws.inBox(0.03f);
        const uint kind = draws.below(16);
        if (kind == 0) v.normal = vec3(0.0f);
        if (kind == 1) v.normal = glm::normalize(draws.inBox(1.0f) + vec3(0.0f, 0.01f, 0.0f));
        scene.skin.push_back(v);
        FurVertex f{draws.inBox(1.0f), draws.in(0.0f, 0.1f), vec3(1.0f), draws.in(0.0f, 1.0f)};
        if (draws.below(64) == 0) f.direction = vec3(hard(), hard(), hard());
        if (draws.below(64) == 0) f.furLength = hard();
        if (draws.below(64) == 0) f.density = hard();
        if (kind == 2) f.direction = vec3(0.0f);
        scene.fur.push_back(f);
    }
    for (const uvec3& t : ball->triangles) scene.triangles.emplace_back(t, 0u);
    for (uint i = 0; i < kHairs; ++i) {
        const uint triangle = draws.below(static_cast<uint>(scene.triangles.size()));
        const uint a = draws.below(65536), b = draws.below(65536 - a);
        scene.roots.push_back({triangle, a | (b << 16u), pcg(seed ^ pcg(i)), draws.below(i + 1)});
    }
    return scene;
}

// Every parameter at random in its range, every fourth at an end of it. Without `shaped` hair is
// its spine.
Fur randomFur(uint seed, uint droop, bool shaped) {
    test::Draws draws(seed);
    Fur fur = defaultFur();
    const auto value = [&](const Parameter& row) {
        const auto one = [&] {
            const uint kind = draws.below(8);
            return kind == 0   ? row.least
                   : kind == 1 ? row.greatest
                               : draws.in(row.least, row.greatest);
        };
        const float x = one(), y = one();
        return vec3(x, y, one());
    };
    for (const Parameter& row : coatParameters()) {
        setParameter(fur.over, row, value(row));
        setParameter(fur.under, row, value(row));
    }
    for (const Parameter& row : furParameters()) setParameter(fur, row, value(row));
    for (Coat* coat : {&fur.over, &fur.under}) {
        coat->droop = droop;
        if (!shaped) coat->clump = coat->curlRadius = coat->frizz = 0.0f;
    }
    return fur;
}

Light testLight() {
    Light light{};
    light.toKey = glm::normalize(vec3(0.3f, 0.8f, -0.4f));
    light.key = 1.9f;
    light.sky = vec3(0.62f, 0.68f, 0.78f);
    light.ground = vec3(0.26f, 0.23f, 0.20f);
    return light;
}

Result onCpu(const Scene& scene, const Fur& fur, const Light& light, uint i) {
    const auto grow = [&](const Root& root) {
        const glm::uvec4 t = scene.triangles[root.triangle];
        return growStrand(root, scene.skin[t.x], scene.skin[t.y], scene.skin[t.z], scene.fur[t.x],
                          scene.fur[t.y], scene.fur[t.z], fur, kAutoWidth, kSeconds);
    };
    const Root& root = scene.roots[i];
    Result r{};
    r.strand = grow(root);
    const Coat& coat = r.strand.coat == 0 ? fur.over : fur.under;
    if (coat.clump > 0.0f) r.strand = gatherStrand(r.strand, grow(scene.roots[root.guide]), coat);
    const Strand& s = r.strand;
    for (std::size_t k = 0; k < 4; ++k) {
        const float at = kPlaces[k];
        const vec3 tangent = strandTangent(s, at);
        const float depth = depthInCoat(fur, 1e5f, s.spineLength, 1e-4f, 2e-5f, s.coat, at);
        r.points[k] = vec4(strandPoint(s, at), strandWidth(s, coat.taper, at));
        r.tangents[k] = vec4(tangent, 0.0f);
        r.normals[k] = vec4(strandNormal(s, tangent), 0.0f);
        r.colors[k] = vec4(fiberRadiance(s, coat, light, vec3(0.9f, 0.5f, 0.2f), at,
                                         vec3(0.0f, 0.6f, 0.8f), depth),
                           depth);
    }
    r.hash = pcg(root.id);
    r.id = hairId(root.triangle, i, fur.seed);
    r.over = isOvercoat(root.id, fur.share) ? 1u : 0u;
    r.weights = vec4(baryWeights(root.bary), rand01(root.id));
    return r;
}

std::vector<Result> onGpu(const gl::ProgramName& program, const Scene& scene, const Fur& fur,
                          const Light& light) {
    const gl::Buffer skin = test::bufferOf(scene.skin), vertices = test::bufferOf(scene.fur),
                     triangles = test::bufferOf(scene.triangles),
                     roots = test::bufferOf(scene.roots), block = test::bufferOf<Fur>({fur}),
                     lights = test::bufferOf<Light>({light});
    gl::Buffer rods;
    rods.upload(std::span(rodTable(), kRodNodes * kRodNodes * kRodTexels));
    gl::Buffer results;
    results.resize(scene.roots.size() * sizeof(Result));
    block.bindUniform(binding::fur);
    skin.bindStorage(0);
    vertices.bindStorage(1);
    triangles.bindStorage(2);
    lights.bindStorage(3);
    rods.bindStorage(binding::rodTable);
    roots.bindStorage(7);
    results.bindStorage(8);
    glUseProgram(program.name());
    glDispatchCompute((kHairs + 63) / 64, 1, 1);
    return test::valuesOf<Result>(results.name(), scene.roots.size());
}

// The scene in which the last bits of every number are others: of places (about 1 m) as a sum of
// three corners loses them, which gusts of .1 mm magnify; of directions as a GPU's sine does.
Scene nudged(Scene scene, uint seed) {
    test::Draws draws(seed);
    const auto nudge = [&](float& x, float by) {
        x *= 1.0f + 3e-7f * draws.in(-0.5f, 0.5f);
        x += by * draws.in(-1.0f, 1.0f);
    };
    for (SkinVertex& v : scene.skin) {
        for (int k = 0; k < 3; ++k) nudge(v.position[k], 2e-7f);
        for (int k = 0; k < 3; ++k) nudge(v.normal[k], 1e-6f);
    }
    for (FurVertex& v : scene.fur) {
        for (int k = 0; k < 3; ++k) nudge(v.direction[k], 1e-6f);
        nudge(v.furLength, 0.0f);
    }
    return scene;
}

bool finite(const vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// m by which the points of a hair may differ. Sines of many turns, powers and what a guide far away
// adds differ more; and the plane in which a nearly straight hair curls is known badly.
float allowedOf(const Strand& s) {
    // What a rod reads from its table moves by up to ten times as much as where it reads.
    const bool rod = s.droop == kDroopElastica;
    if (!isShaped(s)) return (rod ? 5e-6f : 1e-6f) * s.spineLength + 1e-6f;
    const float size = s.spineLength + glm::length(s.guideOffset) + glm::length(s.guideWeightless);
    const float bend = std::max(glm::distance(s.weightless, s.end), 1e-6f);
    return 2e-5f * size + 1e-6f + 2e-6f * (s.curl + s.frizz) / bend;
}

double apart(vec4 a, vec4 b) { return static_cast<double>(glm::distance(vec3(a), vec3(b))); }

// How far a hair may move, in times of what nudging its input moves it.
constexpr double kSways = 8.0;

// What tangents and colors may differ by, colors relative to 1 and themselves.
struct Allowed {
    double tangent, color;
};

// The largest differences over all hairs, as shares of what is allowed.
struct Differences {
    double point = 0.0, tangent = 0.0, color = 0.0, depth = 0.0;
    std::size_t hairs = 0, decisions = 0, notFinite = 0;
    std::size_t points = 0;  // hairs whose points differ by more than is allowed

    // `sways` are the hair of the CPU from scenes that are nudged.
    void compare(const Result& gpu, const Result& cpu, std::span<const Result> sways,
                 const Allowed& allowed) {
        ++hairs;
        const auto bits = [](float x) { return std::bit_cast<uint>(x); };
        decisions += gpu.hash != cpu.hash || gpu.id != cpu.id || gpu.over != cpu.over ||
                     gpu.strand.coat != cpu.strand.coat ||
                     bits(gpu.strand.keep) != bits(cpu.strand.keep) ||
                     bits(gpu.weights.w) != bits(cpu.weights.w) || gpu.weights != cpu.weights ||
                     (gpu.strand.spineLength > 0.0f) != (cpu.strand.spineLength > 0.0f);
        double worst = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            for (const Result* r : {&gpu, &cpu})
                notFinite += !finite(r->points[k]) || !finite(r->tangents[k]) ||
                             !finite(r->normals[k]) || !finite(r->colors[k]);
            const auto share = [&](std::array<vec4, 4> Result::*of, double least) {
                double sway = 0.0;
                for (const Result& r : sways)
                    sway = std::max(sway, apart((r.*of)[k], (cpu.*of)[k]));
                return apart((gpu.*of)[k], (cpu.*of)[k]) / (least + kSways * sway);
            };
            worst =
                std::max(worst, share(&Result::points, static_cast<double>(allowedOf(cpu.strand))));
            tangent = std::max(tangent, share(&Result::tangents, allowed.tangent));
            const double bright = 1.0 + static_cast<double>(glm::length(vec3(cpu.colors[k])));
            color = std::max(color, share(&Result::colors, allowed.color * bright));
            depth =
                std::max(depth, static_cast<double>(std::abs(gpu.colors[k].w - cpu.colors[k].w) /
                                                    (1.0f + std::abs(cpu.colors[k].w))));
        }
        points += worst > 1.0;
        point = std::max(point, worst);
    }
};

void differences(uint droop, bool shaped, const Allowed& allowed) {
    const std::vector<std::string> defines(droop == kDroopElastica ? 1 : 0, "RODS");
    const gl::ProgramName program = test::computeProgram(
        test::shaderHead({"types.glsl", "strand.glsl", "fiber.glsl"}, defines) + kShader);
    const Light light = testLight();
    Differences d;
    for (uint seed = 1; seed <= 12; ++seed) {
        const Scene scene = randomScene(seed);
        const std::array<Scene, 2> others = {nudged(scene, 2 * seed), nudged(scene, 2 * seed + 1)};
        const Fur fur = randomFur(seed, droop, shaped);
        const std::vector<Result> gpu = onGpu(program, scene, fur, light);
        for (uint i = 0; i < kHairs; ++i) {
            const std::array<Result, 2> sways = {onCpu(others[0], fur, light, i),
                                                 onCpu(others[1], fur, light, i)};
            d.compare(gpu[i], onCpu(scene, fur, light, i), sways, allowed);
        }
    }
    std::printf(
        "%zu hairs, of what is allowed: points %.3g (%zu hairs beyond), tangents %.3g, "
        "colors %.3g; depths %.3g\n",
        d.hairs, d.point, d.points, d.tangent, d.color, d.depth);
    EXPECT_GE(d.hairs, 50000u);
    EXPECT_EQ(d.decisions, 0u);
    EXPECT_EQ(d.notFinite, 0u);
    EXPECT_LE(d.point, 1.0);
    EXPECT_LE(d.tangent, 1.0);
    EXPECT_LE(d.color, 1.0);
    EXPECT_LE(d.depth, 1e-5);
}

TEST(Parity, GpuAndCpuAgreeAboutEveryHair) { differences(kDroopPaper, false, {1e-5, 2e-3}); }

TEST(Parity, GpuAndCpuAgreeAboutEveryRod) { differences(kDroopElastica, false, {1e-4, 2e-3}); }

// A tangent of frizz that is as steep as it may be is known badly.
TEST(Parity, GpuAndCpuAgreeAboutClumpsCurlsAndFrizz) {
    differences(kDroopPaper, true, {5e-3, 5e-3});
    differences(kDroopElastica, true, {5e-3, 5e-3});
}

}  // namespace
}  // namespace pelage
