// animal_groom.cpp -- the animal's fur: how long, how dense and which way on each piece of the
// body.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "animal.h"
#include "animal_shape.h"

namespace pelage {
namespace {

constexpr float kLean = 0.85f;  // magnitude of the direction where hair lies as combed

bool bare(const animal::Part& part) {
    return part.paint == animal::Paint::nose || part.paint == animal::Paint::eye;
}

FurVertex furAt(const animal::Shape& shape, vec3 p, vec3 n) {
    const float side = p.x < 0.0f ? -1.0f : 1.0f;
    const vec3 half(std::abs(p.x), p.y, p.z);
    const animal::Blend blend = shape.blend(half);
    FurVertex fur = kBareFur;
    vec3 comb(0.0f);
    for (const animal::Blend::Term& term : blend) {
        fur.furLength += term.weight * term.part->furLength;
        comb += term.weight * term.part->comb;
    }
    // Sideways combing of the two halves fades towards the middle, where they meet.
    comb.x *= side * std::min(1.0f, half.x / 0.03f);
    const vec3 tangential = comb - glm::dot(comb, n) * n;
    const float size = std::sqrt(glm::dot(tangential, tangential));
    fur.direction = tangential * (kLean / std::max(size, 0.45f));
    const bool pad = n.y < -0.6f && p.y < 0.006f;
    fur.density = bare(*blend.nearest) || pad ? 0.0f : 1.0f;
    if (fur.density == 0.0f) fur.furLength = 0.0f;
    return fur;
}

// Evens out the direction where pieces that are combed differently meet.
void smoothDirections(const Skin& skin, std::vector<FurVertex>& fur) {
    std::vector<vec3> next(fur.size());
    for (int round = 0; round < 3; ++round) {
        tbb::parallel_for(std::size_t(0), fur.size(), [&](std::size_t v) {
            vec3 sum = fur[v].direction;
            float count = 1.0f;
            for (const uint n : skin.ring(uint(v))) {
                sum += fur[n].direction;
                count += 1.0f;
            }
            const vec3 normal = skin.vertices[v].normal;
            next[v] = sum / count - glm::dot(sum / count, normal) * normal;
        });
        for (std::size_t v = 0; v < fur.size(); ++v) fur[v].direction = next[v];
    }
}

// The look that goes with the animal's picture.
Fur animalFur() {
    Fur fur = defaultFur();
    fur.hairs = 200000;
    fur.share = 0.45f;
    fur.gravity = 0.35f;
    fur.over.stiffness = 0.55f;
    fur.over.directionWeight = 0.66f;
    fur.over.endRandomness = 0.18f;
    fur.over.normalRandomness = 0.35f;
    fur.over.ambient = vec3(0.75f);
    fur.over.diffuse = vec3(0.85f);
    fur.over.specular = vec3(0.07f, 0.065f, 0.06f);
    fur.over.shininess = 20.0f;
    fur.over.rootColor = vec3(0.45f, 0.42f, 0.40f);
    fur.over.tipColor = vec3(1.0f);
    fur.over.colorNoise = 0.14f;
    fur.over.taper = 0.9f;
    fur.under = fur.over;
    fur.under.relativeLength = 0.55f;
    fur.under.stiffness = 0.7f;
    fur.under.endRandomness = 0.25f;
    fur.under.specular = vec3(0.03f);
    fur.under.tipColor = vec3(0.85f, 0.82f, 0.80f);
    return fur;
}

}  // namespace

Document groomedAnimal(std::size_t triangles) {
    const std::shared_ptr<const Skin> skin = makeSkin(makeAnimal(triangles));
    const animal::Shape shape(0.0f);
    const std::size_t count = skin->vertices.size();
    std::vector<FurVertex> fur(count);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t v) {
        fur[v] = furAt(shape, skin->vertices[v].position, skin->vertices[v].normal);
    });
    smoothDirections(*skin, fur);
    Groom groom = evenGroom(*skin, kBareFur);
    for (std::size_t v = 0; v < count; ++v) groom.fur.edit(v) = fur[v];
    return {skin, std::move(groom), animalFur()};
}

}  // namespace pelage
