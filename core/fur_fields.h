// fur_fields.h -- what the fur is called in a glTF, and how it is taken out of one and put in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glb_draft.h"
#include "source.h"

namespace pelage {

// The attribute without leading underscores and in capitals: "_fur_length" is "FUR_LENGTH".
std::string plainAttribute(std::string_view name);

// Takes the fur fields and the compatibility mirror of earlier exports off every primitive that
// has a part, and removes their data where it ends the file, as it does in a file of ours. So a
// file that is saved often does not grow.
void stripFields(GlbDraft& draft, const std::vector<SourcePart>& parts);

// Values of one primitive, one per vertex of the file, in mesh space.
struct FieldValues {
    std::vector<float> length, density;
    std::vector<float> direction;  // x, y, z
    std::vector<float> tint;       // linear RGB; empty to write none
    std::vector<float> segment;    // number of the body segment, -1 for none; empty to write none
    bool operator==(const FieldValues&) const = default;
};

// Puts fields on primitives. Primitives of a mesh that share positions share the fields if they
// are equal.
class FieldWriter {
public:
    explicit FieldWriter(GlbDraft& draft) : draft_(draft) {}

    // `firstSet` is the number of the first mirror set, -1 for no mirror.
    void write(const SourcePart& part, FieldValues values, int firstSet);

private:
    struct Written {
        uint mesh;
        std::size_t positions;  // accessor
        FieldValues values;
        std::size_t length, density, direction, tint, segment;
        std::size_t mirror[3];
    };
    const Written& written(const SourcePart& part, std::size_t positions, FieldValues values,
                           bool mirrored);
    std::size_t zeros(std::size_t count);

    GlbDraft& draft_;
    std::vector<Written> written_;
    std::vector<std::pair<std::size_t, std::size_t>> zeros_;  // count, accessor
};

// The first texture coordinate set from which the mirror can be written on every primitive that
// has a part: after those in use, and 2 at least.
int firstMirrorSet(const GlbDraft& draft, const std::vector<SourcePart>& parts);

// Puts the block into extras.fur of every mesh that has parts and of every node that places one.
// Where extras is no object, or has a fur that is none, it is left alone; if that is so everywhere
// the block goes to asset.extras. Throws std::runtime_error when that cannot hold it either.
void writeBlock(OrderedJson& gltf, const std::vector<SourcePart>& parts, const OrderedJson& block);

}  // namespace pelage
