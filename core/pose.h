// pose.h -- an animal away from its rest pose: a moment of a clip, and weights of morph targets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "script_text.h"
#include "skin.h"

namespace pelage {

struct Pose {
    int clip = -1;               // into Rig::clips; -1 = none
    float seconds = 0.0f;        // of the clip
    std::vector<float> weights;  // of Rig::targets that no channel moves; empty = the file's own

    bool atRest() const { return clip < 0 && weights.empty(); }
    bool operator==(const Pose&) const = default;
};

// The skin in a pose: the same vertices, triangles, areas and source, so that roots, painted values
// and brushes mean the same on both; places, frames, normals and bounds are those of the pose. Fur
// on it is what furToWorld gives there, and what furToMesh makes of it belongs to the rest pose. A
// vertex that would leave the range of floats stays where it rests. At rest, the rest skin itself.
std::shared_ptr<const Skin> posedSkin(const std::shared_ptr<const Skin>& rest, const Pose& pose);

// Number of a clip by its name or its number from 1. Throws std::runtime_error that lists them.
int clipNamed(const Skin& skin, std::string_view name);

// "pose rest", "pose 2 0.5", "pose 2 0.5 morph 0 1": the script line of a pose, which says clips by
// their number. What follows the word pose in a line may name the clip as well.
std::string poseLine(const Pose& pose);
Pose poseFromWords(const Skin& skin, Words& words);

}  // namespace pelage
