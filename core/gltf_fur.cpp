// gltf_fur.cpp -- finds fur in attributes and extras.
#include "gltf_fur.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "gltf_accessor.h"

namespace pelage {
namespace {

constexpr float kMaxLength = 1e6f;

// "fur_length" for "_FUR_LENGTH" and "__Fur_Length".
std::string plainName(const std::string& name) {
    std::string out = name.substr(std::min(name.find_first_not_of('_'), name.size()));
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

// The attribute of that plain name, as it is spelled.
std::optional<std::string> attributeOf(const JsonPlace& primitive, std::string_view name) {
    for (const auto& [attribute, value] : primitive.at("attributes").json().items())
        if (plainName(attribute) == name) return attribute;
    return std::nullopt;
}

// Values of the attribute of that plain name, one of `components` per vertex of the part.
std::optional<std::vector<float>> field(GltfFile& file, const SourcePart& part,
                                        const JsonPlace& primitive, const char* name,
                                        std::size_t components) {
    const std::optional<std::string> attribute = attributeOf(primitive, name);
    if (!attribute) return std::nullopt;
    const std::size_t accessor = primitive.at("attributes").at(*attribute).integer(0, 0xffffffffu);
    const AccessorShape shape = accessorShape(file, accessor);
    if (shape.components != components) {
        file.warnings.add(primitive.text() + ": " + name + " has " +
                          std::to_string(shape.components) + " components instead of " +
                          std::to_string(components) + "; it was ignored");
        return std::nullopt;
    }
    if (shape.count != part.vertexCount) {
        primitive.refuse(std::string(name) + " has " + std::to_string(shape.count) +
                         " values for " + std::to_string(part.vertexCount) + " vertices");
    }
    return accessorFloats(file, accessor, components);
}

// Makes every value one that fur can have; returns how many were changed.
std::size_t keepInRange(std::vector<float>& values, float greatest, float instead = 0.0f) {
    std::size_t changed = 0;
    for (float& value : values) {
        if (value >= 0.0f && value <= greatest) continue;
        value = value > greatest && std::isfinite(value) ? greatest : instead;
        ++changed;
    }
    return changed;
}

std::size_t keepInRange(std::vector<vec3>& directions) {
    std::size_t changed = 0;
    for (vec3& d : directions) {
        const float length = glm::length(d);
        if (length <= 1.001f) continue;  // a unit vector may be off by its rounding
        d = std::isfinite(length) ? d / length : vec3(0.0f);
        ++changed;
    }
    return changed;
}

void warnChanged(GltfFile& file, const JsonPlace& primitive, const char* name,
                 std::size_t changed) {
    if (changed == 0) return;
    file.warnings.add(primitive.text() + ": " + std::to_string(changed) + " values of " + name +
                      " were out of range and were changed");
}

std::vector<vec3> threes(const std::vector<float>& flat) {
    std::vector<vec3> values(flat.size() / 3);
    for (std::size_t v = 0; v < values.size(); ++v)
        values[v] = vec3(flat[3 * v], flat[3 * v + 1], flat[3 * v + 2]);
    return values;
}

// Puts the values at the place of the part in an array that is as long as all vertices so far.
template <typename T>
void place(std::vector<T>& all, const SourcePart& part, const std::vector<T>& values, T missing) {
    all.resize(part.firstVertex, missing);
    all.insert(all.end(), values.begin(), values.end());
}

// extras.fur of the object if that is a block: others may mean something else by "fur".
std::optional<JsonPlace> blockOf(const JsonPlace& place) {
    if (!place.has("extras") || !place.at("extras").has("fur")) return std::nullopt;
    const JsonPlace block = place.at("extras").at("fur");
    return block.json().is_object() ? std::optional(block) : std::nullopt;
}

std::optional<JsonPlace> blockOf(const GltfFile& file) {
    for (const char* section : {"meshes", "nodes"})
        for (std::size_t i = 0; i < file.count(section); ++i)
            if (const auto block = blockOf(file.element(section, i))) return block;
    return blockOf(file.root().at("asset"));
}

Segment segmentFrom(const JsonPlace& place) {
    const auto root = place.numbers("root", 3), tip = place.numbers("tip", 3);
    if (root.empty() || tip.empty()) place.refuse("has no root or no tip");
    return {place.string("name"), vec3(root[0], root[1], root[2]), vec3(tip[0], tip[1], tip[2])};
}

}  // namespace

void readFurFields(GltfFile& file, Source& source, const SourcePart& part,
                   const JsonPlace& primitive) {
    auto length = field(file, part, primitive, "fur_length", 1);
    auto density = field(file, part, primitive, "fur_density", 1);
    const auto flat = field(file, part, primitive, "fur_direction", 3);
    auto tint = field(file, part, primitive, "fur_tint", 3);
    if (!source.fur && (length || density || flat || tint))
        source.fur = std::make_unique<SourceFur>();
    if (length) {
        warnChanged(file, primitive, "fur_length", keepInRange(*length, kMaxLength));
        place(source.fur->length, part, *length, 0.0f);
    }
    if (density) {
        warnChanged(file, primitive, "fur_density", keepInRange(*density, 1.0f));
        place(source.fur->density, part, *density, 1.0f);
    }
    if (flat) {
        std::vector<vec3> direction = threes(*flat);
        warnChanged(file, primitive, "fur_direction", keepInRange(direction));
        place(source.fur->direction, part, direction, vec3(0.0f));
    }
    if (tint) {
        warnChanged(file, primitive, "fur_tint", keepInRange(*tint, 1.0f, 1.0f));
        place(source.fur->tint, part, threes(*tint), vec3(1.0f));
    }
}

void warnMissingFields(GltfFile& file, const Source& source) {
    if (!source.fur) return;
    const struct {
        const char* name;
        bool found;
        const char* instead;
    } fields[] = {{"fur_length", !source.fur->length.empty(), "length 0"},
                  {"fur_density", !source.fur->density.empty(), "density 1"},
                  {"fur_direction", !source.fur->direction.empty(), "the direction of the normal"},
                  {"fur_tint", !source.fur->tint.empty(), "tint 1"}};
    for (const SourcePart& part : source.parts) {
        const JsonPlace primitive = file.primitive(part.mesh, part.primitive);
        for (const auto& [name, found, instead] : fields) {
            if (!found || attributeOf(primitive, name)) continue;
            file.warnings.add(primitive.text() + ": has no " + name +
                              ", which other primitives have; it takes " + instead);
        }
    }
}

bool readFurSegments(GltfFile& file, Source& source) {
    const auto block = blockOf(file);
    const auto list = block ? block->array("segments") : std::nullopt;
    if (!list) return false;
    for (std::size_t s = 0; s < list->size(); ++s)
        source.segments.push_back(segmentFrom(list->at(s)));
    source.segmentOf.assign(source.positions.size(), kNoSegment);
    for (const SourcePart& part : source.parts) {
        const JsonPlace primitive = file.primitive(part.mesh, part.primitive);
        const auto numbers = field(file, part, primitive, "fur_segment", 1);
        for (uint v = 0; numbers && v < part.vertexCount; ++v) {
            const float number = (*numbers)[v];
            if (number == -1.0f) continue;
            if (!(number >= 0.0f && number < static_cast<float>(source.segments.size())))
                primitive.refuse("_FUR_SEGMENT names one of " +
                                 std::to_string(source.segments.size()) +
                                 " segments that is not there");
            source.segmentOf[part.firstVertex + v] = static_cast<uint>(number);
        }
    }
    return true;
}

std::string furBlock(const GltfFile& file) {
    const auto block = blockOf(file);
    return block ? block->json().dump() : std::string();
}

}  // namespace pelage
