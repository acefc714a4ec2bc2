// base_color.cpp -- the color of the skin's material at a place.
#include "base_color.h"

#include <algorithm>
#include <cmath>

#include "srgb.h"

namespace pelage {
namespace {

constexpr int kLargestDecoded = 16384;

template <typename T>
T mixed(const std::vector<T>& values, uvec3 corners, vec3 weights) {
    return weights.x * values[corners.x] + weights.y * values[corners.y] +
           weights.z * values[corners.z];
}

// x into [0, size), as a picture that repeats.
int wrapped(int x, int size) { return (x % size + size) % size; }

}  // namespace

BaseColor::BaseColor(const Skin& skin)
    : source_(skin.source.get()), materialOf_(skin.triangles.size(), -1), linear_(256) {
    for (const SourcePart& part : source_->parts)
        std::fill_n(materialOf_.begin() + part.firstTriangle, part.triangleCount, part.material);
    for (const SourceImage& image : source_->images) {
        const bool decoded = decodedSize(image.bytes, kLargestDecoded).x > 0;
        pictures_.push_back(decoded ? decodePixels(image.bytes) : Pixels{});
    }
    for (std::size_t i = 0; i < linear_.size(); ++i)
        linear_[i] = linearFromSrgb(static_cast<float>(i) / 255.0f);
}

vec3 BaseColor::texel(const Pixels& picture, ivec2 at) const {
    const int x = wrapped(at.x, picture.size.x), y = wrapped(at.y, picture.size.y);
    const std::size_t first =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.x) +
             static_cast<std::size_t>(x));
    return {linear_[picture.rgba[first]], linear_[picture.rgba[first + 1]],
            linear_[picture.rgba[first + 2]]};
}

vec3 BaseColor::at(uint triangle, vec3 weights) const {
    const uvec3 corners = source_->triangles[triangle];
    vec3 color(1.0f);
    if (!source_->colors.empty()) color = vec3(mixed(source_->colors, corners, weights));
    if (materialOf_[triangle] < 0) return color;
    const SourceMaterial& material =
        source_->materials[static_cast<std::size_t>(materialOf_[triangle])];
    color *= vec3(material.baseColor);
    if (material.image < 0) return color;
    const Pixels& picture = pictures_[static_cast<std::size_t>(material.image)];
    if (picture.rgba.empty()) return color;

    const vec2 uv = source_->uvs.empty() ? vec2(0.0f) : mixed(source_->uvs, corners, weights);
    const vec2 whole = vec2(picture.size);
    const vec2 place = (uv - glm::floor(uv)) * whole - 0.5f;
    const vec2 lower = glm::floor(place), share = place - lower;
    const ivec2 at(lower);
    return color * glm::mix(glm::mix(texel(picture, at), texel(picture, at + ivec2(1, 0)), share.x),
                            glm::mix(texel(picture, at + ivec2(0, 1)),
                                     texel(picture, at + ivec2(1, 1)), share.x),
                            share.y);
}

}  // namespace pelage
