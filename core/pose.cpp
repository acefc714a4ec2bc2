// pose.cpp -- from a moment of a clip to the places of all vertices.
#include "pose.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

#include "rig.h"
#include "source_check.h"

namespace pelage {
namespace {

// What a pose sets: places of nodes, and weights of all targets.
struct Settings {
    NodeTree tree;
    std::vector<float> weights;
};

void apply(const Rig& rig, const Track& track, const std::vector<float>& value,
           Settings& settings) {
    NodePlace& place = settings.tree.places[track.node];
    switch (track.path) {
        case ClipPath::translation:
            place.translation = {value[0], value[1], value[2]};
            break;
        case ClipPath::rotation:
            place.rotation = {value[0], value[1], value[2], value[3]};
            break;
        case ClipPath::scale:
            place.scale = {value[0], value[1], value[2]};
            break;
        case ClipPath::weights:
            for (std::size_t t = 0; t < rig.targets.size(); ++t) {
                const MorphTarget& target = rig.targets[t];
                if (target.node == track.node && target.number < value.size())
                    settings.weights[t] = value[target.number];
            }
            break;
    }
}

Settings settingsOf(const Rig& rig, const Pose& pose) {
    Settings settings{rig.tree, pose.weights};
    if (settings.weights.empty())
        for (const MorphTarget& target : rig.targets) settings.weights.push_back(target.weight);
    assert(settings.weights.size() == rig.targets.size());
    if (pose.clip < 0) return settings;
    for (const Track& track : rig.clips[static_cast<std::size_t>(pose.clip)].tracks)
        apply(rig, track, valueAt(track, pose.seconds), settings);
    return settings;
}

// In mesh space; empty where the source's own positions hold.
std::vector<vec3> morphed(const Rig& rig, const std::vector<float>& weights) {
    std::vector<vec3> positions = rig.unmorphed;
    for (std::size_t t = 0; t < weights.size(); ++t) {
        if (weights[t] == 0.0f) continue;
        const MorphTarget& target = rig.targets[t];
        for (std::size_t i = 0; i < target.vertices.size(); ++i)
            positions[target.vertices[i]] += weights[t] * target.offsets[i];
    }
    return positions;
}

bool inRange(const mat4& m, vec3 place) {
    const vec3 size =
        glm::abs(vec3(m[0])) + glm::abs(vec3(m[1])) + glm::abs(vec3(m[2])) + glm::abs(place);
    return size.x <= kMaxCoordinate && size.y <= kMaxCoordinate && size.z <= kMaxCoordinate;
}

}  // namespace

std::shared_ptr<const Skin> posedSkin(const std::shared_ptr<const Skin>& rest, const Pose& pose) {
    if (pose.atRest()) return rest;
    const Source& source = *rest->source;
    assert(source.rig && source.rig->nodeOfPart.size() == source.parts.size());
    const Rig& rig = *source.rig;
    const Settings settings = settingsOf(rig, pose);
    const std::vector<mat4> ofNodes = worldMatrices(settings.tree);
    std::vector<mat4> ofJoints;
    for (const Joint& joint : rig.joints)
        ofJoints.push_back(ofNodes[joint.node] * joint.inverseBind);
    const std::vector<vec3> moved = morphed(rig, settings.weights);
    const std::vector<vec3>& positions = moved.empty() ? source.positions : moved;
    const std::vector<uint> part = partOfVertex(source);

    const auto matrixOf = [&](uint s) {
        if (const auto held = rig.influencesOf(s); !held.empty()) return blended(held, ofJoints);
        const std::size_t node = rig.nodeOfPart[part[s]];
        return node == kNoNode ? source.parts[part[s]].toWorld : ofNodes[node];
    };
    std::vector<vec3> places(rest->vertices.size());
    std::vector<mat4> toWorld(places.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 2048),
                      [&](const auto& range) {
                          for (std::size_t v = range.begin(); v < range.end(); ++v) {
                              const uint s = rest->sourceOf[v];
                              toWorld[v] = matrixOf(s);
                              places[v] = vec3(toWorld[v] * vec4(positions[s], 1.0f));
                              if (inRange(toWorld[v], places[v])) continue;
                              const SkinVertex& vertex = rest->vertices[v];
                              toWorld[v] = mat4(rest->frames[vertex.frame].toWorld);
                              places[v] = vertex.position;
                          }
                      });
    auto skin = std::make_shared<Skin>(*rest);
    moveVertices(*skin, part, places, toWorld);
    return skin;
}

}  // namespace pelage
