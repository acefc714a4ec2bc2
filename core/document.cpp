// document.cpp -- from a source to a document that can be edited.
#include "document.h"

#include <utility>

namespace pelage {

Document openDocument(Source source, Progress* progress) {
    // First, because it may throw, and the rest takes long.
    const Fur fur = source.furBlock.empty() ? defaultFur() : furFromJson(source.furBlock);
    std::shared_ptr<const Skin> skin = makeSkin(std::move(source), progress);
    Groom groom = initialGroom(*skin);
    return {std::move(skin), std::move(groom), fur};
}

}  // namespace pelage
