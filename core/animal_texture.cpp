// animal_texture.cpp -- the animal's colors: a fox's coat, painted into the atlas.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "animal_shape.h"
#include "pixels.h"
#include "strand.h"

namespace pelage::animal {
namespace {

// Display-encoded sRGB in [0,255].
constexpr vec3 kRusset{203.0f, 106.0f, 40.0f};
constexpr vec3 kBack{150.0f, 70.0f, 28.0f};
constexpr vec3 kCream{250.0f, 238.0f, 216.0f};
constexpr vec3 kDark{62.0f, 40.0f, 32.0f};
constexpr vec3 kBlack{26.0f, 21.0f, 22.0f};
constexpr vec3 kAmber{176.0f, 104.0f, 28.0f};
constexpr vec3 kGlint{255.0f, 252.0f, 244.0f};
constexpr vec3 kInnerEar{226.0f, 178.0f, 150.0f};

float smoothStep(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

vec3 mix(vec3 a, vec3 b, float share) { return a + share * (b - a); }

float corner(int x, int y, int z) {
    return rand01(uint(x) ^ pcg(uint(y) ^ pcg(uint(z)))) * 2.0f - 1.0f;
}

// Smooth noise in [-1,1] with features of size 1.
float noise(vec3 p) {
    const vec3 cell = glm::floor(p);
    const vec3 f = p - cell;
    const vec3 s = f * f * (3.0f - 2.0f * f);
    const int x = int(cell.x), y = int(cell.y), z = int(cell.z);
    float sum = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const int dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
        sum += corner(x + dx, y + dy, z + dz) * (dx ? s.x : 1.0f - s.x) * (dy ? s.y : 1.0f - s.y) *
               (dz ? s.z : 1.0f - s.z);
    }
    return sum;
}

// An eye: black rim, amber iris, wide pupil and a glint on the side of the light.
vec3 eyeColor(vec3 p, const Part& eye) {
    const vec3 look = vec3(0.50f, 0.10f, 0.86f);
    const vec3 from = (p - eye.a) / eye.radii;
    const vec3 n = from / std::max(std::sqrt(glm::dot(from, from)), 1e-6f);
    const float front = glm::dot(n, look);
    const vec3 iris = mix(kBlack, kAmber, smoothStep(0.62f, 0.70f, front));
    const vec3 lens = mix(iris, kBlack, smoothStep(0.80f, 0.86f, front));
    const vec3 glint = vec3(0.30f, 0.55f, 0.78f);
    return mix(lens, kGlint, smoothStep(0.965f, 0.980f, glm::dot(n, glint)));
}

// Russet with a darker back and cream below; `blur` is a little noise that frays the borders.
vec3 coatColor(vec3 p, vec3 n, float blur) {
    const vec3 upper =
        mix(kRusset, kBack,
            0.8f * smoothStep(0.055f, 0.0f, p.x + 0.02f * blur) * smoothStep(0.3f, 0.9f, n.y));
    return mix(upper, kCream, smoothStep(-0.35f, -0.75f, n.y + 0.15f * blur));
}

vec3 headColor(vec3 p, vec3 n, float blur) {
    // A cream mask: cheeks and the sides of the muzzle, up to the eyes.
    const float top =
        0.588f + 0.10f * std::max(0.345f - p.z, 0.0f) - 0.16f * std::max(p.z - 0.36f, 0.0f);
    const float mask = smoothStep(0.010f, -0.010f, p.y - top + 0.006f * blur) *
                       smoothStep(0.205f, 0.255f, p.z + 0.012f * blur);
    const vec3 upper =
        mix(kRusset, kBack,
            0.45f * smoothStep(0.030f, 0.0f, p.x + 0.01f * blur) * smoothStep(0.1f, 0.8f, n.y));
    return mix(upper, kCream, mask);
}

vec3 partColor(const Part& part, float along, vec3 p, vec3 n, float blur) {
    switch (part.paint) {
        case Paint::trunk:
            return coatColor(p, n, blur);
        case Paint::limb:
            return coatColor(p, vec3(n.x, std::max(n.y, 0.0f), n.z), blur);
        case Paint::neck:  // a cream throat
            return mix(coatColor(p, vec3(n.x, std::max(n.y, 0.0f), n.z), blur), kCream,
                       smoothStep(0.25f, 0.6f, n.z - 0.5f * n.y + 0.12f * blur));
        case Paint::head:
            return headColor(p, n, blur);
        case Paint::ruff:
            return mix(coatColor(p, n, blur), kCream, smoothStep(0.15f, 0.55f, n.z + 0.1f * blur));
        case Paint::ear: {
            const vec3 back = mix(kRusset, kDark, smoothStep(0.25f, 0.60f, along + 0.08f * blur));
            const float inside = smoothStep(0.1f, 0.5f, glm::dot(n, part.facing));
            const vec3 front = mix(kInnerEar, kCream, smoothStep(0.5f, 0.0f, along));
            return mix(back, mix(front, kDark, smoothStep(0.70f, 0.95f, along)), inside);
        }
        case Paint::sock: {
            const float height = p.y + 0.02f * blur;
            return mix(kDark, coatColor(p, vec3(n.x, std::max(n.y, 0.0f), n.z), blur),
                       smoothStep(0.105f, 0.185f, height));
        }
        case Paint::tail: {
            const vec3 fox = mix(kRusset, kBack, smoothStep(0.15f, 0.65f, along + 0.10f * blur));
            return mix(fox, kCream, smoothStep(0.70f, 0.78f, along + 0.06f * blur));
        }
        case Paint::nose:
            return kBlack;
        case Paint::eye:
            return eyeColor(p, part);
    }
    return kRusset;
}

vec3 colorAt(const Shape& shape, vec3 p, vec3 n) {
    const vec3 half(std::abs(p.x), p.y, p.z);
    const vec3 halfNormal(p.x < 0.0f ? -n.x : n.x, n.y, n.z);
    const float blur = noise(p * 90.0f) + 0.5f * noise(p * 210.0f);
    const Blend blend = shape.blend(half);
    if (blend.nearest->paint == Paint::nose || blend.nearest->paint == Paint::eye) {
        return partColor(*blend.nearest, 0.0f, half, halfNormal, blur);
    }
    vec3 color(0.0f);
    float sum = 0.0f;
    for (const Blend::Term& term : blend) {
        if (term.part->paint == Paint::nose || term.part->paint == Paint::eye) continue;
        color += term.weight * partColor(*term.part, term.along, half, halfNormal, blur);
        sum += term.weight;
    }
    // Lids: dark skin around the eyes.
    color /= std::max(sum, 1e-6f);
    for (const Blend::Term& term : blend) {
        if (term.part->paint != Paint::eye) continue;
        const vec3 from = half - term.part->a;
        const float rim = std::sqrt(glm::dot(from, from)) - term.part->radii.x;
        color = mix(kDark, color, smoothStep(0.001f, 0.006f, rim));
    }
    return color * (1.0f + 0.06f * noise(p * 320.0f));
}

struct Texel {
    vec3 position{0.0f}, normal{0.0f};
    bool covered = false;
};

// What each texel of the picture shows: its middle on the surface.
std::vector<Texel> rasterise(const Surface& surface, const Atlas& atlas) {
    std::vector<Texel> texels(std::size_t(kPictureSize) * std::size_t(kPictureSize));
    for (const uvec3& t : atlas.triangles) {
        vec2 q[3];
        for (int i = 0; i < 3; ++i) q[i] = atlas.uvs[t[i]] * float(kPictureSize);
        const float area =
            (q[1].x - q[0].x) * (q[2].y - q[0].y) - (q[2].x - q[0].x) * (q[1].y - q[0].y);
        if (area == 0.0f) continue;
        const int x0 = int(std::min({q[0].x, q[1].x, q[2].x}));
        const int x1 = std::min(int(std::max({q[0].x, q[1].x, q[2].x})), kPictureSize - 1);
        const int y0 = int(std::min({q[0].y, q[1].y, q[2].y}));
        const int y1 = std::min(int(std::max({q[0].y, q[1].y, q[2].y})), kPictureSize - 1);
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                const vec2 p(float(x) + 0.5f, float(y) + 0.5f);
                const float b1 =
                    ((p.x - q[0].x) * (q[2].y - q[0].y) - (q[2].x - q[0].x) * (p.y - q[0].y)) /
                    area;
                const float b2 =
                    ((q[1].x - q[0].x) * (p.y - q[0].y) - (p.x - q[0].x) * (q[1].y - q[0].y)) /
                    area;
                const float b0 = 1.0f - b1 - b2;
                if (b0 < 0.0f || b1 < 0.0f || b2 < 0.0f) continue;
                const uint a = atlas.vertexOf[t.x], b = atlas.vertexOf[t.y],
                           c = atlas.vertexOf[t.z];
                Texel& texel = texels[std::size_t(y) * std::size_t(kPictureSize) + std::size_t(x)];
                texel.position = b0 * surface.positions[a] + b1 * surface.positions[b] +
                                 b2 * surface.positions[c];
                texel.normal =
                    b0 * surface.normals[a] + b1 * surface.normals[b] + b2 * surface.normals[c];
                texel.covered = true;
            }
        }
    }
    return texels;
}

// Grows the colors over the borders of the charts, so that filtering finds no gap there.
void growBorders(std::vector<vec3>& colors, std::vector<char>& known) {
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<char> before = known;
        for (int y = 0; y < kPictureSize; ++y) {
            for (int x = 0; x < kPictureSize; ++x) {
                const auto at = [](int i, int j) {
                    return std::size_t(std::clamp(j, 0, kPictureSize - 1)) *
                               std::size_t(kPictureSize) +
                           std::size_t(std::clamp(i, 0, kPictureSize - 1));
                };
                if (before[at(x, y)]) continue;
                vec3 sum(0.0f);
                float count = 0.0f;
                for (const std::size_t n :
                     {at(x - 1, y), at(x + 1, y), at(x, y - 1), at(x, y + 1)}) {
                    if (!before[n]) continue;
                    sum += colors[n];
                    count += 1.0f;
                }
                if (count == 0.0f) continue;
                colors[at(x, y)] = sum / count;
                known[at(x, y)] = 1;
            }
        }
    }
}

}  // namespace

std::vector<std::byte> paintPicture(const Shape& shape, const Surface& surface,
                                    const Atlas& atlas) {
    const std::vector<Texel> texels = rasterise(surface, atlas);
    std::vector<vec3> colors(texels.size(), kRusset);
    std::vector<char> known(texels.size(), 0);
    tbb::parallel_for(std::size_t(0), texels.size(), [&](std::size_t i) {
        if (!texels[i].covered) return;
        const vec3 n = texels[i].normal;
        colors[i] =
            colorAt(shape, texels[i].position, n / std::sqrt(std::max(glm::dot(n, n), 1e-12f)));
        known[i] = 1;
    });
    growBorders(colors, known);

    std::vector<unsigned char> pixels;
    pixels.reserve(colors.size() * 3);
    for (const vec3& color : colors) {
        for (int i = 0; i < 3; ++i) {
            pixels.push_back(static_cast<unsigned char>(std::clamp(color[i] + 0.5f, 0.0f, 255.0f)));
        }
    }
    return encodePng(ivec2(kPictureSize), 3, pixels);
}

}  // namespace pelage::animal
