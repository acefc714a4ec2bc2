// gltf_nodes.h -- where the nodes of a glTF stand, and which of them place which mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "gltf_file.h"
#include "rig.h"
#include "types.h"

namespace pelage {

struct Nodes {
    NodeTree tree;              // each node at its own TRS or matrix
    std::vector<mat4> toWorld;  // of each node
    // The node that shows each mesh: the first in the default scene, else in another, else kNoNode.
    std::vector<std::size_t> placeOf;
};

// Refuses nodes that are their own ancestor or have two parents. Warns, once a mesh, when several
// places share it, when only another scene shows it and when none does.
Nodes readNodes(GltfFile& file);

}  // namespace pelage
