// furry_scenes.h -- small furry documents and views of them.
#pragma once

#include <utility>
#include <vector>

#include "tests/core/test_skins.h"
#include "tests/gl/test_pictures.h"

namespace pelage::test {

// A ball of radius 1 m with upright hair that bends a little.
inline Document furryBall(uint hairs) {
    Document document = evenDocument(ball(2));
    document.groom =
        test::evenGroom(*document.skin, {vec3(0.0f, 0.0f, 0.5f), 0.2f, vec3(1.0f), 1.0f});
    document.fur.hairs = hairs;
    return document;
}

inline View ballView(const Document& document, int side) {
    View view;
    view.size = ivec2(side);
    view.camera = framed(document.skin->center(), 1.25f, 0.5f, 0.3f, 1.0f);
    view.detail.rule = Detail::Rule::all;
    return view;
}

// A sheet of 1 m with straight gray hair that lies on it in directions that vary.
inline Document lyingHair(uint hairs, Source source = sheet(8)) {
    Document document = evenDocument(std::move(source));
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const float turn = 0.7f * static_cast<float>(v % 9);
        document.groom.fur.edit(v) = {vec3(std::cos(turn), 0.0f, std::sin(turn)), 0.1f, vec3(1.0f),
                                      1.0f};
    }
    for (Coat* coat : {&document.fur.over, &document.fur.under}) {
        *coat = Coat{};
        coat->ambient = coat->diffuse = vec3(0.2f);  // darker than white in any light
        coat->rootColor = coat->tipColor = vec3(1.0f);
        coat->stiffness = coat->directionWeight = coat->relativeLength = 1.0f;
        coat->shininess = 10.0f;
        coat->taper = 0.3f;
        coat->width = 3e-3f;
    }
    document.fur.gravity = 0.0f;
    document.fur.hairs = hairs;
    return document;
}

constexpr float kHalfSide = 0.6f;  // m, of what viewFromAbove sees

// Straight down, x to the right and -z up, without perspective.
inline View viewFromAbove(int side) {
    View view;
    view.size = ivec2(side);
    view.camera.pitch = 0.5f * 3.14159265f;
    view.camera.orthographic = true;
    view.camera.distance = kHalfSide / std::tan(0.5f * view.camera.fieldOfView);
    view.detail.rule = Detail::Rule::all;
    return view;
}

}  // namespace pelage::test
