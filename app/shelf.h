// shelf.h -- the presets that the window shows: those of the program and the user's own, with
// pictures that are read or drawn bit by bit.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/preset_file.h"

namespace pelage {

class Thumbnailer;
struct ShelfPicture;

struct ShelfEntry {
    Preset preset;
    std::shared_ptr<ShelfPicture> picture;  // null until it was read or drawn
    bool unfinished = false;                // the file still has to get its picture
};

// Has to go before the OpenGL context does.
struct Shelf {
    std::vector<ShelfEntry> entries;  // the user's, then the program's, each by name
    std::shared_ptr<Thumbnailer> thumbnailer;
    std::optional<Preset> dropped;  // on the animal, and not kept yet
    bool shown = false;             // in this frame
};

// The texture of the picture; 0 until there is one.
unsigned textureOf(const ShelfEntry& entry);

// Reads the presets of the user anew; pictures that still fit stay. Returns a line for each file
// that could not be read.
std::vector<std::string> loadShelf(Shelf& shelf);

// True while a picture is missing that somebody waits for.
bool shelfBusy(const Shelf& shelf);
// Goes on with the first missing picture by one small piece of work, and writes the file of a
// preset that waits for it. Throws std::runtime_error when the disk refuses.
void stepShelf(Shelf& shelf);

}  // namespace pelage
