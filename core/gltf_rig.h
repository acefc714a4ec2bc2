// gltf_rig.h -- what moves a glTF: its animations and morph targets.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gltf_nodes.h"
#include "source.h"

namespace pelage {

// Weights of the morph targets as the file shows them: of the node, else of the mesh. Empty where
// neither has any.
std::vector<float> morphWeights(const GltfFile& file, const JsonPlace& mesh, std::size_t node,
                                std::size_t targets);

// Completes a rig that has the joints and influences of the source, which is read but for the rig:
// morph targets and clips, with their numbers checked. Null where nothing can move. What is wrong
// with an animation costs that animation and gives a warning, what is wrong with the targets costs
// all of them: the mesh is no worse for it.
std::shared_ptr<const Rig> completeRig(GltfFile& file, const Source& source, const Nodes& nodes,
                                       Rig rig);

}  // namespace pelage
