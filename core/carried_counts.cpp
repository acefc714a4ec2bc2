// carried_counts.cpp -- counts in the JSON of a glTF that was read without complaint.
#include "carried_counts.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "gltf_carried.h"

namespace pelage {
namespace {

const nlohmann::json& member(const nlohmann::json& object, const char* name) {
    static const nlohmann::json empty = nlohmann::json::array();
    const auto found = object.find(name);
    return found == object.end() ? empty : *found;
}

}  // namespace

CarriedCounts carriedCounts(const Source& source) {
    CarriedCounts counts;
    if (!source.carried) return counts;
    const auto json = nlohmann::json::parse(source.carried->json);
    counts.nodes = member(json, "nodes").size();
    counts.animations = member(json, "animations").size();
    counts.materials = member(json, "materials").size();
    counts.images = member(json, "images").size();
    std::set<nlohmann::json> joints;
    for (const auto& skin : member(json, "skins")) {
        const auto& named = member(skin, "joints");
        joints.insert(named.begin(), named.end());
    }
    counts.joints = joints.size();
    for (const auto& mesh : member(json, "meshes")) {
        for (const auto& primitive : member(mesh, "primitives")) {
            counts.morphTargets =
                std::max(counts.morphTargets, member(primitive, "targets").size());
        }
    }
    return counts;
}

}  // namespace pelage
