// gltf_out.cpp -- writes the groomed .glb.
#include "gltf_out.h"

#include <cassert>

#include "files.h"
#include "fur_fields.h"
#include "gltf_carry.h"

namespace pelage {
namespace {

FieldValues fieldsOf(const Document& document, const SourcePart& part, bool tinted) {
    FieldValues values;
    values.length.reserve(part.vertexCount);
    values.density.reserve(part.vertexCount);
    values.direction.reserve(std::size_t{part.vertexCount} * 3);
    for (uint v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
        const FurVertex& fur = document.groom.fur[document.skin->weld.at(v)];
        values.length.push_back(fur.furLength);
        values.density.push_back(fur.density);
        values.direction.insert(values.direction.end(),
                                {fur.direction.x, fur.direction.y, fur.direction.z});
        if (tinted) values.tint.insert(values.tint.end(), {fur.tint.x, fur.tint.y, fur.tint.z});
    }
    return values;
}

bool isTinted(const Groom& groom) {
    for (std::size_t v = 0; v < groom.fur.size(); ++v)
        if (groom.fur[v].tint != vec3(1.0f)) return true;
    return false;
}

}  // namespace

std::vector<std::byte> groomedGlb(const Document& document, const ExportOptions& options,
                                  Progress* progress) {
    const Source& source = *document.skin->source;
    assert(document.skin->weld.size() == source.positions.size());
    GlbDraft draft = bareDraft(source);
    if (progress) progress->report(0.3f);

    const int firstSet = options.compatibilityUvs ? firstMirrorSet(draft, source.parts) : -1;
    const bool tinted = isTinted(document.groom);
    FieldWriter writer(draft);
    for (std::size_t p = 0; p < source.parts.size(); ++p) {
        writer.write(source.parts[p], fieldsOf(document, source.parts[p], tinted), firstSet);
        if (progress)
            progress->report(0.3f + 0.5f * static_cast<float>(p + 1) /
                                        static_cast<float>(source.parts.size()));
    }

    OrderedJson block = OrderedJson::parse(furToJson(document.fur));
    if (firstSet >= 0) block["uvSet"] = firstSet;
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
