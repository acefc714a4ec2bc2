// sights.h -- clusters of roots and places to see them from, for tests of the level of detail.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "core/lod.h"

namespace pelage::test {

constexpr float kFieldOfView = 0.6f;  // rad

// Towards the origin from `eye`, which is neither above nor below it.
inline Sight sightFrom(vec3 eye, ivec2 size = ivec2(500), bool perspective = true) {
    Sight sight;
    sight.eye = eye;
    sight.forward = -glm::normalize(eye);
    sight.perspective = perspective;
    sight.size = size;
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const float distance = glm::length(eye), near = std::max(distance - 2.0f, 0.01f);
    const float half = std::tan(0.5f * kFieldOfView) * (perspective ? 1.0f : distance);
    sight.pixelsPerMetre = 0.5f * static_cast<float>(size.y) / half;
    sight.viewProjection =
        (perspective
             ? glm::perspective(kFieldOfView, aspect, near, distance + 2.0f)
             : glm::ortho(-half * aspect, half * aspect, -half, half, near, distance + 2.0f)) *
        glm::lookAt(eye, vec3(0.0f), vec3(0, 1, 0));
    return sight;
}

inline const SkinDepth kNoSkin;  // that hides anything

constexpr uint kRoots = 100000;

// One small cluster.
inline Roots oneCluster(vec3 center = vec3(0.0f), uint count = kRoots) {
    Roots roots;
    roots.roots.resize(count);
    Cluster cluster;
    cluster.count = count;
    cluster.center = center;
    cluster.radius = 0.01f;
    roots.clusters.push_back(cluster);
    return roots;
}

// Hair 1 mm wide of one coat.
inline Pelt plainPelt() {
    Pelt pelt;
    pelt.coats = 1;
    pelt.meanWidth = pelt.widest = 1e-3f;
    pelt.length = 1.0f;
    pelt.bend = 0.5f;
    return pelt;
}

// What is seen of clusters whose hair is everywhere `longest` (m) and of density 1.
inline InSight seenOf(const Roots& roots, const Sight& sight, float longest = 1e-3f) {
    Tuft tuft;
    tuft.longest = longest;
    tuft.densest = 1.0f;
    return lookAt(roots, std::vector<Tuft>(roots.clusters.size(), tuft), plainPelt(), sight,
                  &kNoSkin);
}

inline Choice choiceOf(const Roots& roots, const Sight& sight, const Detail& detail,
                       float deviation = 0.0f) {
    return choose(roots, seenOf(roots, sight), sight, plainPelt(), detail, deviation, {});
}

}  // namespace pelage::test
