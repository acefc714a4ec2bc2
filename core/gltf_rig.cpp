// gltf_rig.cpp -- animations and morph targets, every number checked once.
#include "gltf_rig.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "gltf_accessor.h"
#include "text.h"

namespace pelage {
namespace {

// The complaint without the file's name, with which it would begin twice.
void warn(GltfFile& file, const std::runtime_error& error, const char* what) {
    std::string_view text = error.what();
    if (text.starts_with(file.name + ": ")) text.remove_prefix(file.name.size() + 2);
    file.warnings.add(std::string(text) + "; " + what);
}

void checkFinite(const JsonPlace& place, const std::vector<float>& values, const char* what) {
    const auto bad =
        std::find_if(values.begin(), values.end(), [](float x) { return !std::isfinite(x); });
    if (bad != values.end())
        place.refuse(std::string(what) + " " + std::to_string(bad - values.begin()) +
                     " is not finite");
}

std::size_t targetCount(const GltfFile& file, std::size_t mesh) {
    const JsonPlace primitives = file.element("meshes", mesh).at("primitives");
    const auto targets =
        primitives.size() > 0 ? primitives.at(std::size_t{0}).array("targets") : std::nullopt;
    return targets ? targets->size() : 0;
}

std::optional<ClipPath> pathNamed(std::string_view name) {
    if (name == "translation") return ClipPath::translation;
    if (name == "rotation") return ClipPath::rotation;
    if (name == "scale") return ClipPath::scale;
    if (name == "weights") return ClipPath::weights;
    return std::nullopt;
}

Interpolation interpolationOf(const JsonPlace& sampler) {
    const std::string name = sampler.string("interpolation");
    if (name.empty() || name == "LINEAR") return Interpolation::linear;
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    sampler.refuse("interpolation is " + inQuotes(name) + ", which is none of glTF");
}

std::vector<float> readTimes(GltfFile& file, const JsonPlace& sampler) {
    std::vector<float> times = accessorFloats(file, sampler.integer("input", 0, 0xffffffffu), 1);
    checkFinite(sampler, times, "time");
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] > times[i - 1]) continue;
        sampler.refuse("time " + std::to_string(i) + " is " + floatText(times[i]) + " after " +
                       floatText(times[i - 1]) + ", which does not rise");
    }
    return times;
}

// How many numbers the track sets: the components of a vector, or one per morph target.
std::size_t widthOf(const GltfFile& file, const JsonPlace& target, const Track& track) {
    if (track.path == ClipPath::rotation) return 4;
    if (track.path != ClipPath::weights) return 3;
    const auto mesh = file.element("nodes", track.node).reference("mesh");
    const std::size_t count = mesh ? targetCount(file, *mesh) : 0;
    if (count == 0) target.refuse("moves the weights of a node that has no morph target");
    return count;
}

// Nothing for what an extension animates, which glTF asks to ignore.
std::optional<Track> readTrack(GltfFile& file, const Nodes& nodes, const JsonPlace& animation,
                               const JsonPlace& place) {
    const JsonPlace target = place.at("target");
    const auto node = target.reference("node");
    const auto path = pathNamed(target.string("path"));
    if (!node || !path) return std::nullopt;
    Track track{.node = *node, .path = *path};
    if (*path != ClipPath::weights && nodes.tree.places[*node].matrix)
        target.refuse("moves node " + std::to_string(*node) + ", which is placed by a matrix");

    const JsonPlace samplers = animation.at("samplers");
    const std::size_t number = place.integer("sampler", 0, 0xffffffffu);
    if (number >= samplers.size()) {
        place.refuse("names sampler " + std::to_string(number) + " of " +
                     std::to_string(samplers.size()));
    }
    const JsonPlace sampler = samplers.at(number);
    track.interpolation = interpolationOf(sampler);
    track.width = widthOf(file, target, track);
    track.times = readTimes(file, sampler);
    const bool weights = *path == ClipPath::weights;
    track.values =
        accessorFloats(file, sampler.integer("output", 0, 0xffffffffu), weights ? 1 : track.width);
    checkFinite(sampler, track.values, "number");
    const std::size_t wanted =
        track.times.size() * track.width * (track.interpolation == Interpolation::cubic ? 3 : 1);
    if (track.values.size() != wanted) {
        sampler.refuse("has " + std::to_string(track.values.size()) + " numbers where " +
                       std::to_string(track.times.size()) + " keys take " + std::to_string(wanted));
    }
    return track;
}

Clip readClip(GltfFile& file, const Nodes& nodes, std::size_t number) {
    const JsonPlace animation = file.element("animations", number);
    Clip clip{.name = animation.string("name")};
    if (clip.name.empty()) clip.name = "clip " + std::to_string(number + 1);
    const JsonPlace channels = animation.at("channels");
    for (std::size_t c = 0; c < channels.size(); ++c) {
        auto track = readTrack(file, nodes, animation, channels.at(c));
        if (!track) continue;
        clip.seconds = std::max(clip.seconds, track->times.back());
        clip.tracks.push_back(std::move(*track));
    }
    return clip;
}

std::string targetName(const JsonPlace& mesh, std::size_t number) {
    std::string name;
    const auto extras = mesh.has("extras") && mesh.at("extras").json().is_object()
                            ? mesh.object("extras")
                            : std::nullopt;
    if (extras && extras->has("targetNames")) {
        const Json& names = extras->at("targetNames").json();
        if (names.is_array() && number < names.size() && names[number].is_string())
            name = names[number].get<std::string>();
    }
    return name.empty() ? "target " + std::to_string(number + 1) : name;
}

// Positions of the part before any target moved them.
void readUnmorphed(GltfFile& file, const SourcePart& part, const JsonPlace& primitive,
                   std::vector<vec3>& positions) {
    const auto values = accessorFloats(file, *primitive.at("attributes").reference("POSITION"), 3);
    for (uint v = 0; v < part.vertexCount; ++v)
        positions[part.firstVertex + v] = {values[3 * v], values[3 * v + 1], values[3 * v + 2]};
}

void readOffsets(GltfFile& file, const SourcePart& part, const JsonPlace& place,
                 MorphTarget& target) {
    const auto accessor = place.reference("POSITION");
    if (!accessor) return;
    const auto values = accessorFloats(file, *accessor, 3);
    if (values.size() != 3 * std::size_t{part.vertexCount}) {
        place.refuse("POSITION has " + std::to_string(values.size() / 3) + " values for " +
                     std::to_string(part.vertexCount) + " vertices");
    }
    checkFinite(place, values, "number");
    for (uint v = 0; v < part.vertexCount; ++v) {
        const vec3 offset(values[3 * v], values[3 * v + 1], values[3 * v + 2]);
        if (offset == vec3(0.0f)) continue;
        target.vertices.push_back(part.firstVertex + v);
        target.offsets.push_back(offset);
    }
}

void readTargets(GltfFile& file, const Source& source, const Nodes& nodes, Rig& rig) {
    std::vector<std::size_t> first(file.count("meshes"), kNoNode);  // target of each mesh
    for (const SourcePart& part : source.parts) {
        const JsonPlace mesh = file.element("meshes", part.mesh);
        const JsonPlace primitive = file.primitive(part.mesh, part.primitive);
        const auto targets = primitive.array("targets");
        if (!targets) continue;
        if (first[part.mesh] == kNoNode) {
            first[part.mesh] = rig.targets.size();
            const std::size_t node = nodes.placeOf[part.mesh];
            const auto weights = morphWeights(file, mesh, node, targets->size());
            for (std::size_t t = 0; t < targets->size(); ++t)
                rig.targets.push_back({.name = targetName(mesh, t),
                                       .node = node,
                                       .number = t,
                                       .weight = weights.empty() ? 0.0f : weights[t]});
        }
        if (rig.unmorphed.empty()) rig.unmorphed = source.positions;
        readUnmorphed(file, part, primitive, rig.unmorphed);
        const std::size_t known = rig.targets.size() - first[part.mesh];
        for (std::size_t t = 0; t < std::min(targets->size(), known); ++t)
            readOffsets(file, part, targets->at(t), rig.targets[first[part.mesh] + t]);
    }
}

}  // namespace

std::vector<float> morphWeights(const GltfFile& file, const JsonPlace& mesh, std::size_t node,
                                std::size_t targets) {
    std::optional<JsonPlace> owner;
    if (node != kNoNode && file.element("nodes", node).has("weights")) {
        owner = file.element("nodes", node);
    } else if (mesh.has("weights")) {
        owner = mesh;
    }
    return owner ? owner->numbers("weights", targets) : std::vector<float>();
}

std::shared_ptr<const Rig> completeRig(GltfFile& file, const Source& source, const Nodes& nodes,
                                       Rig rig) {
    try {
        readTargets(file, source, nodes, rig);
    } catch (const std::runtime_error& error) {
        rig.targets.clear();
        rig.unmorphed.clear();
        warn(file, error, "its morph targets do not move");
    }
    for (std::size_t a = 0; a < file.count("animations"); ++a) {
        try {
            Clip clip = readClip(file, nodes, a);
            if (!clip.tracks.empty()) rig.clips.push_back(std::move(clip));
        } catch (const std::runtime_error& error) {
            warn(file, error, "this animation is not played");
        }
    }
    if (rig.clips.empty() && rig.targets.empty()) return nullptr;
    rig.firstInfluence.resize(source.positions.size() + 1,
                              static_cast<uint>(rig.influences.size()));
    for (const SourcePart& part : source.parts) rig.nodeOfPart.push_back(nodes.placeOf[part.mesh]);
    rig.tree = nodes.tree;
    return std::make_shared<const Rig>(std::move(rig));
}

}  // namespace pelage
