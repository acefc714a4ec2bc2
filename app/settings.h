// settings.h -- what the editor remembers from one start to the next: recent files and scale.
#pragma once

#include <string>
#include <vector>

namespace pelage {

struct Settings {
    std::vector<std::string> recent;  // absolute paths, the latest first, at most 12
    float scale = 0.0f;               // of widgets and text; 0 = that of the display
    std::string folder;               // where the file dialog was last
};

// $XDG_CONFIG_HOME/pelage/settings.json or ~/.config/pelage/settings.json.
std::string settingsPath();

// A file that is missing or damaged gives the defaults; `warning` then says what was wrong with it.
struct LoadedSettings {
    Settings settings;
    std::string warning;
};
LoadedSettings loadSettings(const std::string& path);

// Throws std::runtime_error when the disk refuses.
void saveSettings(const Settings& settings, const std::string& path);

// Puts `path`, made absolute, at the front.
void remember(Settings& settings, const std::string& path);

}  // namespace pelage
