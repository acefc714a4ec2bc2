// gltf_out.cpp -- writes the groomed .glb.
#include "gltf_out.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "files.h"
#include "fur_fields.h"
#include "gltf_carry.h"
#include "text.h"

namespace pelage {
namespace {

// Which of the fields that a file may lack it gets.
struct Extra {
    bool tint = false, segment = false;
};

FieldValues fieldsOf(const Document& document, const SourcePart& part, Extra extra) {
    FieldValues values;
    values.length.reserve(part.vertexCount);
    values.density.reserve(part.vertexCount);
    values.direction.reserve(std::size_t{part.vertexCount} * 3);
    for (uint v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
        const uint at = document.skin->weld.at(v);
        const FurVertex& fur = document.groom.fur[at];
        values.length.push_back(fur.furLength);
        values.density.push_back(fur.density);
        values.direction.insert(values.direction.end(),
                                {fur.direction.x, fur.direction.y, fur.direction.z});
        if (extra.tint) values.tint.insert(values.tint.end(), {fur.tint.x, fur.tint.y, fur.tint.z});
        if (!extra.segment) continue;
        const uint segment = document.groom.segmentOf[at];
        values.segment.push_back(segment == kNoSegment ? -1.0f : static_cast<float>(segment));
    }
    return values;
}

bool isTinted(const Groom& groom) {
    for (std::size_t v = 0; v < groom.fur.size(); ++v)
        if (groom.fur[v].tint != vec3(1.0f)) return true;
    return false;
}

// Whether the body of the document is not what a reader finds in the file without being told.
bool tellsBody(const Document& document) {
    const Source& source = *document.skin->source;
    const Groom& groom = document.groom;
    if (!source.carried && !groom.body().empty()) return true;
    if (source.segmentsKept || !std::ranges::equal(groom.body(), source.segments)) return true;
    const Groom first = evenGroom(*document.skin, kBareFur);
    for (std::size_t v = 0; v < groom.segmentOf.size(); ++v)
        if (groom.segmentOf[v] != first.segmentOf[v]) return true;
    return false;
}

// As the shortest numbers that read back to the same floats.
OrderedJson pointOf(vec3 p) {
    return OrderedJson::parse('[' + floatText(p.x) + ',' + floatText(p.y) + ',' + floatText(p.z) +
                              ']');
}

OrderedJson segmentList(std::span<const Segment> body) {
    OrderedJson list = OrderedJson::array();
    for (const auto& [name, root, tip] : body)
        list.push_back({{"name", name}, {"root", pointOf(root)}, {"tip", pointOf(tip)}});
    return list;
}

}  // namespace

std::vector<std::byte> groomedGlb(const Document& document, const ExportOptions& options,
                                  Progress* progress) {
    const Source& source = *document.skin->source;
    assert(document.skin->weld.size() == source.positions.size());
    GlbDraft draft = bareDraft(source);
    if (progress) progress->report(0.3f);

    const int firstSet = options.compatibilityUvs ? firstMirrorSet(draft, source.parts) : -1;
    const Extra extra{isTinted(document.groom), tellsBody(document)};
    FieldWriter writer(draft);
    for (std::size_t p = 0; p < source.parts.size(); ++p) {
        writer.write(source.parts[p], fieldsOf(document, source.parts[p], extra), firstSet);
        if (progress)
            progress->report(0.3f + 0.5f * static_cast<float>(p + 1) /
                                        static_cast<float>(source.parts.size()));
    }

    OrderedJson block = OrderedJson::parse(furToJson(document.fur));
    if (firstSet >= 0) block["uvSet"] = firstSet;
    if (extra.segment) block["segments"] = segmentList(document.groom.body());
    writeBlock(draft.json, source.parts, block);
    std::vector<std::byte> bytes = packGlb(std::move(draft));
    if (progress) progress->report(1.0f);
    return bytes;
}

void writeGroomedGlb(const Document& document, const std::string& path,
                     const ExportOptions& options, Progress* progress) {
    expectExtension(path, ".glb");
    writeFileAtomically(path, groomedGlb(document, options, progress));
}

}  // namespace pelage
