// settings.cpp -- the settings file.
#include "app/settings.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/files.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kRecent = 12;
constexpr std::size_t kLargestFile = 1 << 20;  // bytes

}  // namespace

std::string settingsPath() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const fs::path folder = config && *config ? fs::path(config)
                            : home && *home   ? fs::path(home) / ".config"
                                              : fs::temp_directory_path();
    return (folder / "pelage" / "settings.json").string();
}

LoadedSettings loadSettings(const std::string& path) {
    LoadedSettings loaded;
    std::error_code absent;
    if (!fs::exists(path, absent)) return loaded;
    try {
        const auto bytes = readFile(path, kLargestFile);
        const auto* text = reinterpret_cast<const char*>(bytes.data());
        const auto json = nlohmann::json::parse(text, text + bytes.size());
        loaded.settings.recent = json.value("recent", std::vector<std::string>{});
        loaded.settings.scale = std::clamp(json.value("scale", 0.0f), 0.0f, 4.0f);
        loaded.settings.folder = json.value("folder", std::string{});
        if (loaded.settings.recent.size() > kRecent) loaded.settings.recent.resize(kRecent);
    } catch (const std::exception& error) {
        loaded.settings = Settings();
        loaded.warning = path + ": settings not read: " + error.what();
    }
    return loaded;
}

void saveSettings(const Settings& settings, const std::string& path) {
    fs::create_directories(fs::path(path).parent_path());
    const nlohmann::json json = {
        {"recent", settings.recent}, {"scale", settings.scale}, {"folder", settings.folder}};
    // File names are bytes: what is not UTF-8 is written with replacement characters.
    const std::string text =
        json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    writeFileAtomically(path, std::as_bytes(std::span(text)));
}

void remember(Settings& settings, const std::string& path) {
    const std::string absolute = fs::absolute(path).lexically_normal().string();
    std::erase(settings.recent, absolute);
    settings.recent.insert(settings.recent.begin(), absolute);
    if (settings.recent.size() > kRecent) settings.recent.resize(kRecent);
}

}  // namespace pelage
