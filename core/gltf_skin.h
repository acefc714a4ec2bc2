// gltf_skin.h -- skins of a glTF at rest: where the joints hold the vertices, and the body they
// name.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "gltf_nodes.h"
#include "source.h"

namespace pelage {

// Reads skins as parts ask for them; their joints and influences go to the rig.
class SkinReader {
public:
    SkinReader(GltfFile& file, const Nodes& nodes, Rig& rig)
        : file_(file), nodes_(nodes), rig_(rig) {}

    // Whether `part`, placed by `node`, is skinned: the node names a skin and the primitive has
    // joints and weights.
    bool isSkinned(const JsonPlace& primitive, std::size_t node) const;

    // Fills vertexToWorld and segmentOf (joint nodes, for now) of the vertices of the part with
    // the rest pose that viewers show: the sum of weight * joint * inverse bind matrix, weights
    // made to add up to 1; the place of the node itself does not matter (glTF 2.0,
    // section 3.7.3.3).
    void bind(Source& source, const SourcePart& part, const JsonPlace& primitive, std::size_t node);

    // Turns joint nodes in segmentOf into segments, one per joint that holds some vertex most: from
    // the joint to the middle of its child joints; turned round along the way to the head, since
    // fur lies from the head to the tail. Vertices without joints belong to one more segment.
    void nameSegments(Source& source) const;

private:
    struct Skin {
        std::vector<std::size_t> joints;  // nodes
        uint first = 0;                   // of them in the rig
    };
    const Skin& skin(std::size_t index);
    Segment segment(std::size_t joint, const std::vector<std::vector<std::size_t>>& children,
                    const std::vector<char>& towardsHead) const;

    GltfFile& file_;
    const Nodes& nodes_;
    Rig& rig_;
    std::map<std::size_t, Skin> skins_;
    std::vector<mat4> atRest_;  // of each joint of the rig, from mesh space to the world
};

}  // namespace pelage
