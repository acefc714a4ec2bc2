// document.h -- everything that is saved and undone, and nothing else.
#pragma once

#include <memory>

#include "coat.h"
#include "groom.h"
#include "skin.h"

namespace pelage {

struct Document {
    std::shared_ptr<const Skin> skin;
    Groom groom;
    Fur fur;

    // Same state: the same skin, the same chunks, equal parameters. Cheap.
    bool operator==(const Document&) const = default;
};

// The document of a source: its skin, the fur it carries or else a first groom and default coats,
// which are brown where the mesh has no color of its own.
Document openDocument(Source source, Progress* progress = nullptr);

}  // namespace pelage
