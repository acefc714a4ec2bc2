// gltf_skin.cpp -- the rest pose of skinned vertices, and segments of the body from joints.
#include "gltf_skin.h"

#include <algorithm>
#include <cmath>

#include "gltf_accessor.h"
#include "segment_parts.h"

namespace pelage {
namespace {

constexpr uint kNoJoint = 0xffffffffu;

mat4 matrixAt(const std::vector<float>& values, std::size_t index) {
    mat4 out;
    for (int i = 0; i < 16; ++i)
        out[i / 4][i % 4] = values[index * 16 + static_cast<std::size_t>(i)];
    return out;
}

// One set of four joints and weights per vertex.
struct Influences {
    std::vector<std::vector<uint>> joints;
    std::vector<std::vector<float>> weights;
};

Influences readInfluences(GltfFile& file, const SourcePart& part, const JsonPlace& primitive) {
    Influences out;
    const JsonPlace attributes = primitive.at("attributes");
    for (int set = 0;; ++set) {
        const auto joints = attributes.reference(("JOINTS_" + std::to_string(set)).c_str());
        const auto weights = attributes.reference(("WEIGHTS_" + std::to_string(set)).c_str());
        if (!joints || !weights) return out;
        for (const std::size_t accessor : {*joints, *weights}) {
            const std::size_t count = accessorShape(file, accessor).count;
            if (count != part.vertexCount) {
                primitive.refuse("joints or weights of set " + std::to_string(set) + " are " +
                                 std::to_string(count) + " for " +
                                 std::to_string(part.vertexCount) + " vertices");
            }
        }
        out.joints.push_back(accessorIntegers(file, *joints, 4));
        out.weights.push_back(accessorFloats(file, *weights, 4));
    }
}

}  // namespace

bool SkinReader::isSkinned(const JsonPlace& primitive, std::size_t node) const {
    if (node == kNoNode || !file_.element("nodes", node).has("skin")) return false;
    const JsonPlace attributes = primitive.at("attributes");
    return attributes.has("JOINTS_0") && attributes.has("WEIGHTS_0");
}

const SkinReader::Skin& SkinReader::skin(std::size_t index) {
    const auto known = skins_.find(index);
    if (known != skins_.end()) return known->second;

    const JsonPlace place = file_.element("skins", index);
    const JsonPlace joints = place.at("joints");
    Skin skin;
    for (std::size_t j = 0; j < joints.size(); ++j)
        skin.joints.push_back(joints.at(j).integer(0, kNoJoint));
    std::vector<float> inverse;
    if (const auto accessor = place.reference("inverseBindMatrices")) {
        inverse = accessorFloats(file_, *accessor, 16, skin.joints.size());
        if (inverse.size() < skin.joints.size() * 16) {
            place.refuse("has " + std::to_string(inverse.size() / 16) +
                         " inverse bind matrices for " + std::to_string(skin.joints.size()) +
                         " joints");
        }
    }
    skin.first = static_cast<uint>(rig_.joints.size());
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        const mat4 bind = inverse.empty() ? mat4(1.0f) : matrixAt(inverse, j);
        const mat4 matrix = nodes_.toWorld[skin.joints[j]] * bind;
        for (int c = 0; c < 4; ++c) {
            for (int r = 0; r < 4; ++r) {
                if (!std::isfinite(matrix[c][r]))
                    place.refuse("the matrix of joint " + std::to_string(j) + " is not finite");
            }
        }
        rig_.joints.push_back({skin.joints[j], bind});
        atRest_.push_back(matrix);
    }
    return skins_.emplace(index, std::move(skin)).first->second;
}

void SkinReader::bind(Source& source, const SourcePart& part, const JsonPlace& primitive,
                      std::size_t node) {
    const Skin& bones = skin(*file_.element("nodes", node).reference("skin"));
    const Influences influences = readInfluences(file_, part, primitive);
    if (bones.joints.empty()) primitive.refuse("is held by a skin without joints");
    // Vertices of earlier parts that no joint holds.
    rig_.firstInfluence.resize(part.firstVertex, static_cast<uint>(rig_.influences.size()));
    std::size_t unheld = 0;
    for (uint v = 0; v < part.vertexCount; ++v) {
        float total = 0.0f, most = 0.0f;
        std::size_t dominant = influences.joints[0][v * std::size_t{4}];
        rig_.firstInfluence.push_back(static_cast<uint>(rig_.influences.size()));
        for (std::size_t set = 0; set < influences.joints.size(); ++set) {
            for (std::size_t k = v * std::size_t{4}; k < v * std::size_t{4} + 4; ++k) {
                const float weight = influences.weights[set][k];
                const std::size_t joint = influences.joints[set][k];
                if (!std::isfinite(weight) || weight < 0.0f) {
                    primitive.refuse("a weight of vertex " + std::to_string(v) +
                                     " is negative or not finite");
                }
                if (weight == 0.0f) continue;
                if (joint >= bones.joints.size()) {
                    primitive.refuse("vertex " + std::to_string(v) + " names joint " +
                                     std::to_string(joint) + " of " +
                                     std::to_string(bones.joints.size()));
                }
                rig_.influences.push_back({bones.first + static_cast<uint>(joint), weight});
                total += weight;
                if (weight > most) {
                    most = weight;
                    dominant = joint;
                }
            }
        }
        if (!(total > 0.0f) || !std::isfinite(total)) {
            dominant = std::min(dominant, bones.joints.size() - 1);
            rig_.influences.resize(rig_.firstInfluence.back());
            rig_.influences.push_back({bones.first + static_cast<uint>(dominant), 1.0f});
            ++unheld;
        }
        const std::span<const Influence> own(rig_.influences.data() + rig_.firstInfluence.back(),
                                             rig_.influences.data() + rig_.influences.size());
        source.vertexToWorld[part.firstVertex + v] = blended(own, atRest_);
        source.segmentOf[part.firstVertex + v] = static_cast<uint>(bones.joints[dominant]);
    }
    if (unheld > 0) {
        file_.warnings.add(primitive.text() + ": " + std::to_string(unheld) +
                           " vertices have no weights; each follows the first joint it names");
    }
}

Segment SkinReader::segment(std::size_t joint,
                            const std::vector<std::vector<std::size_t>>& children,
                            const std::vector<char>& towardsHead) const {
    const auto placeOf = [&](std::size_t node) { return vec3(nodes_.toWorld[node][3]); };
    const vec3 here = placeOf(joint);
    vec3 end = here;
    if (!children[joint].empty()) {
        // On the way to the head, a child off that way (a leg, the tail) says nothing.
        vec3 sum(0.0f), sumToHead(0.0f);
        float count = 0.0f, countToHead = 0.0f;
        for (const std::size_t child : children[joint]) {
            sum += placeOf(child);
            count += 1.0f;
            if (!towardsHead[child]) continue;
            sumToHead += placeOf(child);
            countToHead += 1.0f;
        }
        end = countToHead > 0.0f ? sumToHead / countToHead : sum / count;
    } else if (nodes_.tree.parent[joint] != kNoNode) {
        end = here + (here - placeOf(nodes_.tree.parent[joint]));
    }
    Segment out{file_.element("nodes", joint).string("name"), here, end};
    if (out.name.empty()) out.name = "joint " + std::to_string(joint);
    if (towardsHead[joint]) std::swap(out.root, out.tip);
    return out;
}

void SkinReader::nameSegments(Source& source) const {
    std::vector<std::vector<std::size_t>> children(nodes_.tree.parent.size());
    std::vector<char> isJoint(nodes_.tree.parent.size(), 0),
        towardsHead(nodes_.tree.parent.size(), 0);
    for (const auto& [index, skin] : skins_) {
        for (const std::size_t joint : skin.joints) {
            if (isJoint[joint]) continue;
            isJoint[joint] = 1;
            if (nodes_.tree.parent[joint] != kNoNode)
                children[nodes_.tree.parent[joint]].push_back(joint);
            if (!saysHead(file_.element("nodes", joint).string("name"))) continue;
            for (std::size_t n = joint; n != kNoNode && !towardsHead[n];
                 n = nodes_.tree.parent[n]) {
                towardsHead[n] = 1;
            }
        }
    }
    std::vector<uint> segmentOf(nodes_.tree.parent.size(), kNoJoint);
    uint rest = kNoJoint;
    for (uint& of : source.segmentOf) {
        uint& number = of == kNoJoint ? rest : segmentOf[of];
        if (number == kNoJoint) {
            number = static_cast<uint>(source.segments.size());
            source.segments.push_back(of == kNoJoint
                                          ? Segment{"rest", vec3(0.0f), vec3(0.0f, -1.0f, 0.0f)}
                                          : segment(of, children, towardsHead));
        }
        of = number;
    }
}

}  // namespace pelage
