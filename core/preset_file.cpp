// preset_file.cpp -- preset files: text and back, and the folder of the user's own.
#include "preset_file.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "files.h"
#include "gltf_carry.h"
#include "gltf_file.h"
#include "json_place.h"
#include "text.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kVersion = 1;
constexpr std::size_t kMostBytes = std::size_t{1} << 18;
constexpr std::size_t kMostName = 60, kMostAuthor = 100, kMostNote = 1000;  // bytes

std::string lineOf(const JsonPlace& root, const char* member, std::size_t most) {
    std::string text = root.string(member);
    if (text.size() > most)
        root.at(member).refuse("is " + std::to_string(text.size()) + " bytes long, at most " +
                               std::to_string(most));
    if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
        root.at(member).refuse("holds a control code");
    return text;
}

std::vector<std::byte> pictureOf(const JsonPlace& root) {
    if (!root.has("thumbnail")) return {};
    const JsonPlace place = root.at("thumbnail");
    std::vector<std::byte> bytes = dataUriBytes(place, root.string("thumbnail"));
    const std::string type = pictureType(bytes);
    if (type != "image/png" && type != "image/jpeg") place.refuse("is neither a PNG nor a JPEG");
    return bytes;
}

// "wolf" for "coats/wolf.fur.json"
std::string stemOf(const std::string& file) {
    const std::string name = fs::path(file).filename().string();
    return name.substr(0, std::min(name.find('.'), kMostName));
}

}  // namespace

std::string presetText(const Preset& preset) {
    nlohmann::ordered_json json{{"version", kVersion}};
    if (!preset.name.empty()) json["name"] = preset.name;
    if (!preset.author.empty()) json["author"] = preset.author;
    if (!preset.note.empty()) json["note"] = preset.note;
    json["fur"] = nlohmann::ordered_json::parse(furToJson(preset.fur));
    if (!preset.seeded) json["fur"].erase("seed");
    if (!preset.thumbnail.empty())
        json["thumbnail"] =
            "data:" + pictureType(preset.thumbnail) + ";base64," + base64(preset.thumbnail);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Preset presetFromText(std::string_view text, const std::string& file) {
    const Json json = parsedJson(text, file);
    const JsonPlace root(file, json);
    const auto fur = root.object("fur");
    if (!fur) root.refuse("has no \"fur\", so it is no preset");
    if (root.has("version")) root.integer("version", 1, kVersion);
    Preset preset;
    preset.file = file;
    preset.name = lineOf(root, "name", kMostName);
    if (preset.name.empty()) preset.name = stemOf(file);
    preset.author = lineOf(root, "author", kMostAuthor);
    preset.note = lineOf(root, "note", kMostNote);
    preset.fur = furFromJson(fur->json().dump(), file + ": fur");
    preset.seeded = fur->has("seed");
    preset.thumbnail = pictureOf(root);
    return preset;
}

Preset readPreset(const std::string& path) {
    const std::vector<std::byte> bytes = readFile(path, kMostBytes);
    return presetFromText({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

void writePreset(const Preset& preset, const std::string& path) {
    expectExtension(path, kPresetExtension);
    const std::string text = presetText(preset);
    presetFromText(text, path);
    writeFileAtomically(path, std::as_bytes(std::span(text)));
}

std::string presetFolder() {
    if (const char* data = std::getenv("XDG_DATA_HOME"); data && data[0] == '/')
        return std::string(data) + "/pelage/presets";
    if (const char* home = std::getenv("HOME"); home && home[0] == '/')
        return std::string(home) + "/.local/share/pelage/presets";
    return {};
}

OwnPresets ownPresets(const std::string& folder) {
    OwnPresets own;
    std::error_code absent;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent)) {
        const std::string path = entry.path().string();
        if (!hasExtension(path, kPresetExtension)) continue;
        try {
            own.presets.push_back(readPreset(path));
        } catch (const std::runtime_error& error) {
            own.warnings.emplace_back(error.what());
        }
    }
    std::ranges::sort(own.presets, {}, [](const Preset& p) { return std::pair(p.name, p.file); });
    std::ranges::sort(own.warnings);
    return own;
}

std::string presetPath(const std::string& folder, const OwnPresets& own, const std::string& name) {
    if (std::ranges::find(presets(), name, &Preset::name) != presets().end())
        throw std::runtime_error("\"" + name + "\" is a preset of the program");
    if (folder.empty()) throw std::runtime_error("no place for presets: HOME names no folder");
    const auto known = std::ranges::find(own.presets, name, &Preset::name);
    if (known != own.presets.end()) return known->file;
    std::string stem = name;
    for (char& c : stem)
        if (static_cast<unsigned char>(c) < 0x80 && !std::isalnum(static_cast<unsigned char>(c)))
            c = '_';
    std::string path = folder + "/" + stem + kPresetExtension;
    for (int other = 2; fs::exists(path); ++other)
        path = folder + "/" + stem + "_" + std::to_string(other) + kPresetExtension;
    return path;
}

Preset findPreset(std::string_view nameOrFile) {
    const std::string name(nameOrFile);
    if (hasExtension(name, kPresetExtension)) return readPreset(name);
    // The program's come first, and then nobody's folder is read.
    const auto known = std::ranges::find(presets(), name, &Preset::name);
    return known != presets().end() ? *known : presetNamed(name, ownPresets().presets);
}

}  // namespace pelage
