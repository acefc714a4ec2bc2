// shell_ground.cpp -- what shells know of the skin: the mean hair over it, and the surfaces that
// rays through the fur begin and end on.
#include "app/render/shell_ground.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <utility>
#include <vector>

#include "app/render/frame_data.h"
#include "app/render/shell_data.h"
#include "core/curvature.h"
#include "core/elastica.h"
#include "core/strand.h"

namespace pelage {
namespace {

// Of the usual hair's length.
constexpr float kMissed = 0.05f;    // by which the surface over the fur may miss the skin's shape
constexpr float kSmoothed = 0.25f;  // standard deviation of the bell that smooths its bumps

// A length that changes in few steps while the fur is painted.
float inSteps(float length) {
    return length > 0.0f ? std::exp2(0.5f * std::round(2.0f * std::log2(length))) : 0.0f;
}

// Tangent, normal and binormal of a vertex, the tangent towards the first of its ring.
mat3 axesAt(const Skin& skin, uint v) {
    const vec3 n = safeUnit(skin.vertices[v].normal, vec3(0.0f, 1.0f, 0.0f));
    vec3 along = anyTangent(n);
    if (!skin.ring(v).empty())
        along = skin.vertices[skin.ring(v)[0]].position - skin.vertices[v].position;
    const vec3 t = safeUnit(along - glm::dot(along, n) * n, anyTangent(n));
    return {t, n, glm::cross(t, n)};
}

RestVertex restVertex(const Skin& shown, const Skin& atRest, uint v) {
    RestVertex rest;
    rest.position = atRest.vertices[v].position;
    if (&shown == &atRest) return rest;
    const glm::quat turn = glm::quat_cast(axesAt(atRest, v) * glm::transpose(axesAt(shown, v)));
    rest.turn = vec4(turn.x, turn.y, turn.z, turn.w);
    return rest;
}

}  // namespace

ShellGround::ShellGround()
    : curves_(Program::compute("shell_curves.comp")),
      rodCurves_(Program::compute("shell_curves.comp", {"RODS"})) {
    rodTable_.upload(std::span(rodTable(), kRodNodes * kRodNodes * kRodTexels));
}

void ShellGround::update(Mirror& mirror, const Document& document, uint coats, float seconds,
                         bool waits) {
    const Fur& fur = document.fur;
    const float relative = std::max(coats & 1u ? fur.over.relativeLength : 0.0f,
                                    coats & 2u ? fur.under.relativeLength : 0.0f);
    const float usual = inSteps(relative * mirror.usualHair());
    furSurface_ = &mirror.surfaceWithin(kMissed * usual, waits);
    updateVertices(mirror, document.skin);
    updateRest(mirror);
    updateBends(mirror, kSmoothed * usual);
    findCurves(mirror,
               {shown_, document.groom, fur, coats, fur.wind > 0.0f ? seconds : 0.0f, smoothed_});
}

// What is the same in every pose.
void ShellGround::updateVertices(const Mirror& mirror, const std::shared_ptr<const Skin>& atRest) {
    if (atRest == atRest_) return;
    atRest_ = atRest;
    const std::size_t count = atRest->vertices.size();
    vertices_.resize(count * sizeof(ShellVertex));
    drawn_.resize(count * sizeof(ShellCorner));
    vertexRows_ = gl::makeTexture(vertices_, GL_RGBA32F);
    drawnRows_ = gl::makeTexture(drawn_, GL_RGBA32F);
    cornerRows_ = gl::makeTexture(mirror.corners(), GL_RGBA32UI);
}

void ShellGround::updateRest(const Mirror& mirror) {
    if (mirror.shown() == restOf_) return;
    restOf_ = mirror.shown();
    std::vector<RestVertex> rest(restOf_->vertices.size());
    tbb::parallel_for(std::size_t{0}, rest.size(), [&](std::size_t v) {
        rest[v] = restVertex(*restOf_, *atRest_, static_cast<uint>(v));
    });
    rest_.upload(std::span<const RestVertex>(rest));
}

void ShellGround::updateBends(const Mirror& mirror, float deviation) {
    if (mirror.shown() == shown_ && deviation == smoothed_) return;
    shown_ = mirror.shown();
    smoothed_ = deviation;
    const std::vector<vec3> normals = smoothNormals(*shown_, deviation);
    const std::vector<Curvature> curvatures = curvaturesOf(*shown_, normals);
    std::vector<Bend> bends(normals.size());
    for (uint v = 0; v < normals.size(); ++v) bends[v] = {normals[v], 0.0f, curvatures[v]};
    bends_.upload(std::span<const Bend>(bends));
}

void ShellGround::findCurves(const Mirror& mirror, CurveKey key) {
    if (curvesOf_ == key) return;
    const Fur& fur = key.fur;
    const bool rods = fur.over.droop == kDroopElastica || fur.under.droop == kDroopElastica;
    curvesOf_ = std::move(key);
    (rods ? rodCurves_ : curves_).use();
    bends_.bindStorage(binding::bends);
    rest_.bindStorage(binding::restVertices);
    vertices_.bindStorage(binding::shellVertices);
    rodTable_.bindStorage(binding::rodTable);
    drawn_.bindStorage(binding::shellCorners);
    gl::dispatch((mirror.skin().vertices.size() + 63) / 64);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

std::size_t ShellGround::bytes() const {
    return vertices_.bytes() + drawn_.bytes() + rest_.bytes() + bends_.bytes() + rodTable_.bytes();
}

}  // namespace pelage
