// rig.h -- what moves the vertices of a source: nodes, joints, morph targets and clips.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clip.h"
#include "types.h"

namespace pelage {

inline constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();

// Where a node stands in its parent.
struct NodePlace {
    vec3 translation{0.0f};
    vec4 rotation{0.0f, 0.0f, 0.0f, 1.0f};  // quaternion x, y, z, w of any length
    vec3 scale{1.0f};
    std::optional<mat4> matrix;  // in place of the three
};

struct NodeTree {
    std::vector<NodePlace> places;    // of each node
    std::vector<std::size_t> parent;  // kNoNode for roots
    std::vector<std::size_t> order;   // every node after its parent
};

// From the space of each node to the world.
std::vector<mat4> worldMatrices(const NodeTree& tree);

struct Joint {
    std::size_t node = 0;
    mat4 inverseBind{1.0f};
};

struct Influence {
    uint joint = 0;  // into Rig::joints, or those of a skin
    float weight = 0.0f;
};

// From mesh space to the world for a vertex that joints hold: the sum of weight * matrix, weights
// made to add up to 1 (glTF 2.0, section 3.7.3.3).
mat4 blended(std::span<const Influence> influences, std::span<const mat4> ofJoints);

// Vertices that move together by a weight; zero offsets are left out.
struct MorphTarget {
    std::string name;
    std::size_t node = kNoNode;    // whose weights these are
    std::size_t number = 0;        // of the target among those of its mesh
    float weight = 0.0f;           // as the file shows it
    std::vector<uint> vertices{};  // of the source
    std::vector<vec3> offsets{};   // mesh space
};

struct Rig {
    NodeTree tree;
    std::vector<Joint> joints;
    std::vector<uint> firstInfluence;     // of each source vertex, and their end
    std::vector<Influence> influences;    // none for a vertex that no joint holds
    std::vector<std::size_t> nodeOfPart;  // that places each part; kNoNode where none does
    std::vector<vec3> unmorphed;          // positions with all weights 0; empty without targets
    std::vector<MorphTarget> targets;
    std::vector<Clip> clips;

    std::span<const Influence> influencesOf(uint v) const {
        return {influences.data() + firstInfluence[v], influences.data() + firstInfluence[v + 1]};
    }
};

}  // namespace pelage
