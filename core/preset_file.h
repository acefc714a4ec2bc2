// preset_file.h -- coats as small files that people share, and where the user's own ones are kept.
//
// NAME.fur.json is one JSON object (schema: assets/preset.schema.json): name, author and note, the
// fur as in extras.fur, and a small picture as a data URI. Of these only the fur has to be there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coat.h"

namespace pelage {

inline constexpr const char* kPresetExtension = ".fur.json";

// The file as text. A preset that is not seeded is written without a seed.
std::string presetText(const Preset& preset);
// Takes what the preset has from the text of `file`. What is missing has its default, the name that
// of the file; what is not known is ignored. Throws std::runtime_error "wolf.fur.json: fur:
// over.stiffness is 3, range 0..1" on a newer version, wrong types, values out of range, texts over
// 60 (name), 100 (author) or 1000 bytes (note) or with control codes, and a picture that is none.
Preset presetFromText(std::string_view text, const std::string& file);

// A file of at most 256 KiB.
Preset readPreset(const std::string& path);
// Atomically. Throws as presetFromText would for what it could not read back, and for a name that
// does not end in .fur.json.
void writePreset(const Preset& preset, const std::string& path);

// $XDG_DATA_HOME/pelage/presets or ~/.local/share/pelage/presets; empty when neither variable names
// an absolute path.
std::string presetFolder();

// The presets of a folder in the order of their names; none where there is no folder. A file that
// is none is left out, and `warnings` has a line for it.
struct OwnPresets {
    std::vector<Preset> presets;
    std::vector<std::string> warnings;
};
OwnPresets ownPresets(const std::string& folder = presetFolder());

// A file in the folder for a preset of that name: that of the one that is to be replaced, else one
// that is not there yet. Throws std::runtime_error for the name of a preset of the program and for
// the empty folder.
std::string presetPath(const std::string& folder, const OwnPresets& own, const std::string& name);

// The preset that a script or a user names: a file if it ends in .fur.json, else one of the program
// or of the user's own. Throws std::runtime_error.
Preset findPreset(std::string_view nameOrFile);

}  // namespace pelage
