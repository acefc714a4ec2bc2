// shelf.cpp -- the presets of the window and their pictures.
#include "app/shelf.h"

#include <algorithm>
#include <utility>

#include "app/render/decoded.h"
#include "app/render/thumbnail.h"

namespace pelage {

struct ShelfPicture {
    gl::Texture texture;
};

namespace {

bool waits(const ShelfEntry& entry) { return !entry.picture || entry.unfinished; }

std::shared_ptr<ShelfPicture> pictureOf(const std::vector<std::byte>& encoded) {
    constexpr int kLargestSide = 1024;
    const ivec2 size = decodedSize(encoded, kLargestSide);
    if (size.x < 8 || size.y < 8) return nullptr;
    Decoded decoded = decodePicture(encoded, GL_RGBA8, 3);
    if (!decoded.texture) return nullptr;
    glGenerateTextureMipmap(decoded.texture.name());
    return std::make_shared<ShelfPicture>(ShelfPicture{std::move(decoded.texture)});
}

}  // namespace

unsigned textureOf(const ShelfEntry& entry) {
    return entry.picture ? entry.picture->texture.name() : 0;
}

std::vector<std::string> loadShelf(Shelf& shelf) {
    OwnPresets own = ownPresets();
    std::vector<Preset> all = std::move(own.presets);
    all.insert(all.end(), presets().begin(), presets().end());
    std::vector<ShelfEntry> entries;
    for (Preset& preset : all) {
        const auto old = std::ranges::find_if(shelf.entries, [&](const ShelfEntry& entry) {
            return entry.preset.name == preset.name && entry.preset.file == preset.file &&
                   entry.preset.fur == preset.fur &&
                   (preset.thumbnail.empty() || entry.preset.thumbnail == preset.thumbnail);
        });
        if (old != shelf.entries.end())
            entries.push_back(*old);
        else
            entries.push_back({std::move(preset), nullptr, false});
    }
    shelf.entries = std::move(entries);
    return own.warnings;
}

bool shelfBusy(const Shelf& shelf) {
    return std::ranges::any_of(shelf.entries, [&](const ShelfEntry& entry) {
        return entry.unfinished || (shelf.shown && !entry.picture);
    });
}

void stepShelf(Shelf& shelf) {
    const auto entry = std::ranges::find_if(shelf.entries, waits);
    if (entry == shelf.entries.end()) return;
    Preset& preset = entry->preset;
    if (preset.thumbnail.empty()) {
        if (!shelf.thumbnailer) shelf.thumbnailer = std::make_shared<Thumbnailer>();
        if (auto drawn = shelf.thumbnailer->draw(preset.fur)) preset.thumbnail = std::move(*drawn);
        return;
    }
    entry->picture = pictureOf(preset.thumbnail);
    if (!entry->picture) preset.thumbnail.clear();  // a damaged one is drawn anew
    if (entry->picture && std::exchange(entry->unfinished, false)) writePreset(preset, preset.file);
}

}  // namespace pelage
