// reference.cpp -- samples of pixels, their mean and their error.
#include "reference.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

#include "reference_scene.h"
#include "strand.h"
#include "stratified.h"

namespace pelage {
namespace {

constexpr int kTile = 16;  // pixels that one task does, each way
constexpr uint kMostSamples = 65536;

struct Ray {
    vec3 origin, direction;
};

// Through a place of the picture in pixels, from its upper left corner.
Ray rayThrough(const ReferenceView& view, const RayScene& rays, vec2 place) {
    const vec2 size(view.size);
    const float x = (2.0f * place.x - size.x) / size.y, y = 1.0f - 2.0f * place.y / size.y;
    const vec3 across = view.halfHeight * (x * view.right + y * view.up);
    if (!view.orthographic) return {view.eye, glm::normalize(view.forward + across)};
    // From before everything there is, also where that is behind the eye.
    const vec3 origin = view.eye + across;
    const float depth = glm::dot(rays.center() - origin, view.forward) - 1.01f * rays.radius();
    return {origin + depth * view.forward, view.forward};
}

void checkSize(ivec2 size) {
    constexpr int kMostSide = 16384;
    if (size.x >= 1 && size.y >= 1 && size.x <= kMostSide && size.y <= kMostSide) return;
    throw std::runtime_error("a picture of " + std::to_string(size.x) + " x " +
                             std::to_string(size.y) + " pixels cannot be traced");
}

}  // namespace

ReferencePicture::ReferencePicture(std::shared_ptr<const ReferenceScene> scene,
                                   const ReferenceView& view, std::span<const Lighting> more)
    : scene_(std::move(scene)), view_(view), lightings_{{view.shadows, view.style}} {
    checkSize(view.size);
    lightings_.insert(lightings_.end(), more.begin(), more.end());
    sums_.resize(2 * lightings_.size() * static_cast<std::size_t>(view.size.x) *
                     static_cast<std::size_t>(view.size.y),
                 vec4(0.0f));
}

void ReferencePicture::add(uint samples, Progress* progress) {
    const uint more = samples / 2 + samples % 2;
    assert(more <= kMostSamples / 2 - ofHalf_);
    const TracedDocument& scene = scene_->traced();
    std::vector<vec4> sums = sums_;
    std::atomic<std::size_t> rays{0}, done{0};
    // A half of a pixel's samples, added to what it has.
    const auto sampleHalf = [&](int x, int y, uint half) {
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.size.x) +
                           static_cast<std::size_t>(x);
        const uint seed = pcg(static_cast<uint>(pixel) ^ pcg(2 * view_.seed + half));
        std::size_t traced = 0;
        const std::span<vec4> ofHalf =
            std::span(sums).subspan((2 * pixel + half) * lightings_.size(), lightings_.size());
        for (uint i = ofHalf_; i < ofHalf_ + more; ++i) {
            const Ray ray = rayThrough(view_, *scene.rays, vec2(x, y) + stratified(i, seed));
            ++traced;
            const auto hit = scene.rays->cast(ray.origin, ray.direction);
            if (!hit) continue;
            traced +=
                addSeen(ofHalf, scene, view_.light, lightings_, *hit, -ray.direction, {i, seed});
        }
        return traced;
    };
    tbb::parallel_for(tbb::blocked_range2d<int>(0, view_.size.y, kTile, 0, view_.size.x, kTile),
                      [&](const auto& tile) {
                          std::size_t traced = 0;
                          for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
                              for (int x = tile.cols().begin(); x < tile.cols().end(); ++x)
                                  traced += sampleHalf(x, y, 0) + sampleHalf(x, y, 1);
                          rays += traced;
                          done += tile.rows().size() * tile.cols().size();
                          if (progress)
                              progress->report(static_cast<float>(2 * lightings_.size() * done) /
                                               static_cast<float>(sums.size()));
                      });
    sums_ = std::move(sums);
    ofHalf_ += more;
    rays_ += rays;
}

std::vector<vec4> ReferencePicture::pixels(std::size_t picture) const {
    assert(picture < lightings_.size());
    std::vector<vec4> means(sums_.size() / (2 * lightings_.size()));
    const float share = 0.5f / static_cast<float>(std::max(ofHalf_, 1u));
    for (std::size_t p = 0; p < means.size(); ++p) {
        const std::size_t a = 2 * p * lightings_.size() + picture;
        means[p] = share * (sums_[a] + sums_[a + lightings_.size()]);
    }
    return means;
}

ReferenceNoise ReferencePicture::noise(vec3 background, std::size_t picture) const {
    assert(ofHalf_ > 0 && picture < lightings_.size());
    const std::size_t step = 2 * lightings_.size();
    double color = 0.0, coverage = 0.0;
    for (std::size_t a = picture; a < sums_.size(); a += step) {
        const vec4 apart = sums_[a] - sums_[a + lightings_.size()];
        const vec3 over = vec3(apart) - apart.a * background;
        color += static_cast<double>(glm::dot(over, over)) / 3.0;
        coverage += static_cast<double>(apart.a * apart.a);
    }
    const double scale = 0.5 / ofHalf_ / std::sqrt(static_cast<double>(sums_.size() / step));
    return {static_cast<float>(scale * std::sqrt(color)),
            static_cast<float>(scale * std::sqrt(coverage))};
}

}  // namespace pelage
