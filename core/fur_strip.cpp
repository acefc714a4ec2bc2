// fur_strip.cpp -- takes the fields of an earlier export out of a draft.
#include <algorithm>
#include <cctype>
#include <set>

#include "fur_fields.h"
#include "fur_names.h"
#include "glb_uses.h"

namespace pelage {
namespace {

bool isMirrorName(const std::string& name) {
    return name == kZeroName || std::find(std::begin(kMirrorNames), std::end(kMirrorNames), name) !=
                                    std::end(kMirrorNames);
}

bool isOurName(const std::string& name) {
    return name == kLengthName || name == kDensityName || name == kDirectionName ||
           name == kTintName || name == kSegmentName || isMirrorName(name);
}

std::string nameOf(const OrderedJson& object) {
    const auto name = object.find("name");
    return name != object.end() && name->is_string() ? name->get<std::string>() : std::string();
}

bool isField(const std::string& attribute) {
    const std::string plain = plainAttribute(attribute);
    return plain == "FUR_LENGTH" || plain == "FUR_DENSITY" || plain == "FUR_DIRECTION" ||
           plain == "FUR_TINT" || plain == "FUR_SEGMENT";
}

bool isMirror(const OrderedJson& gltf, const std::string& attribute, const OrderedJson& accessor) {
    return attribute.starts_with("TEXCOORD_") &&
           isMirrorName(nameOf(gltf.at("accessors").at(accessor.get<std::size_t>())));
}

void stripPrimitive(const OrderedJson& gltf, OrderedJson& attributes) {
    std::vector<std::string> ours;
    for (const auto& [attribute, accessor] : attributes.items())
        if (isField(attribute) || isMirror(gltf, attribute, accessor)) ours.push_back(attribute);
    for (const std::string& attribute : ours) attributes.erase(attribute);
}

// Drops the last view if it is ours and nothing uses it, with the bytes that it covers.
bool dropLastView(GlbDraft& draft) {
    if (!draft.json.contains("bufferViews") || draft.json["bufferViews"].empty()) return false;
    OrderedJson& views = draft.json["bufferViews"];
    const std::size_t last = views.size() - 1;
    if (!isOurName(nameOf(views[last]))) return false;
    const auto offset = views[last].value("byteOffset", std::size_t{0});
    const auto length = views[last].at("byteLength").get<std::size_t>();
    std::size_t endOfOthers = 0;
    for (std::size_t v = 0; v < last; ++v)
        endOfOthers = std::max(endOfOthers, views[v].value("byteOffset", std::size_t{0}) +
                                                views[v].at("byteLength").get<std::size_t>());
    if (viewUses(draft.json).contains(last) || endOfOthers > offset ||
        offset + length != draft.bin.size())
        return false;
    draft.bin.resize(offset);
    views.erase(last);
    return true;
}

}  // namespace

std::string plainAttribute(std::string_view name) {
    while (name.starts_with('_')) name.remove_prefix(1);
    std::string plain(name);
    for (char& c : plain) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return plain;
}

void stripFields(GlbDraft& draft, const std::vector<SourcePart>& parts) {
    for (const SourcePart& part : parts)
        stripPrimitive(draft.json, draft.json.at("meshes")
                                       .at(part.mesh)
                                       .at("primitives")
                                       .at(part.primitive)
                                       .at("attributes"));
    if (!draft.json.contains("accessors")) return;
    // Only from the end: any other removal would renumber what extensions we do not know may name.
    const std::multiset<std::size_t> used = accessorUses(draft.json);
    OrderedJson& accessors = draft.json["accessors"];
    while (!accessors.empty() && isOurName(nameOf(accessors.back())) &&
           !used.contains(accessors.size() - 1)) {
        accessors.erase(accessors.size() - 1);
        if (!dropLastView(draft)) break;
    }
}

}  // namespace pelage
