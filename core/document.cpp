// document.cpp -- from a source to a document that can be edited.
#include "document.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pelage {
namespace {

bool hasColors(const Source& source) {
    const auto colored = [](const SourceMaterial& m) { return vec3(m.baseColor) != vec3(1.0f); };
    return !source.images.empty() || !source.colors.empty() ||
           std::any_of(source.materials.begin(), source.materials.end(), colored);
}

Fur carriedFur(const Source& source) {
    try {
        return furFromJson(source.furBlock);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error((source.path.empty() ? "glTF" : source.path) + ": " +
                                 error.what());
    }
}

// Hair takes its color from the skin at its root. Where that is plain white, as in most meshes that
// are only a shape, the first coat brings a brown of its own.
Fur firstFur(const Source& source) {
    Fur fur = defaultFur();
    if (hasColors(source)) return fur;
    fur.over.rootColor = vec3(0.16f, 0.11f, 0.07f);
    fur.over.tipColor = vec3(0.74f, 0.57f, 0.40f);
    fur.under.rootColor = vec3(0.13f, 0.09f, 0.06f);
    fur.under.tipColor = vec3(0.46f, 0.33f, 0.22f);
    return fur;
}

}  // namespace

Document openDocument(Source source, Progress* progress) {
    // First, because it may throw, and the rest takes long.
    const Fur fur = source.furBlock.empty() ? firstFur(source) : carriedFur(source);
    std::shared_ptr<const Skin> skin = makeSkin(std::move(source), progress);
    Groom groom = initialGroom(*skin);
    return {std::move(skin), std::move(groom), fur};
}

}  // namespace pelage
