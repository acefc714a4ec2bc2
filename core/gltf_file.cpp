// gltf_file.cpp -- container, JSON and buffers of a glTF, and the checks they must pass.
#include "gltf_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "beside.h"
#include "text.h"

namespace pelage {
namespace {

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t at) {
    const auto b = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[at + i]); };
    return b(0) | b(1) << 8 | b(2) << 16 | b(3) << 24;
}

struct Chunks {
    std::span<const std::byte> json, binary;
};

// The chunks of a .glb; anything else is taken for the JSON itself.
Chunks splitContainer(std::span<const std::byte> bytes, GltfFile& file) {
    const auto refuse = [&](const std::string& what) {
        throw std::runtime_error(file.name + ": " + what);
    };
    constexpr std::uint32_t kMagic = 0x46546c67, kJson = 0x4e4f534a, kBinary = 0x004e4942;
    if (bytes.size() < 4 || wordAt(bytes, 0) != kMagic) return {bytes, {}};
    if (bytes.size() < 20)
        refuse("is truncated: a .glb has at least 20 bytes, this has " +
               std::to_string(bytes.size()));
    if (wordAt(bytes, 4) != 2)
        refuse("is a .glb of version " + std::to_string(wordAt(bytes, 4)) + "; only 2 is read");
    const std::size_t length = wordAt(bytes, 8);
    if (length > bytes.size()) {
        refuse("is truncated: its header says " + std::to_string(length) + " bytes, there are " +
               std::to_string(bytes.size()));
    }
    if (length < bytes.size()) {
        file.warnings.add(std::to_string(bytes.size() - length) +
                          " bytes after the end of the .glb were ignored");
    }
    Chunks chunks;
    for (std::size_t at = 12, number = 0; at + 8 <= length; ++number) {
        const std::size_t size = wordAt(bytes, at);
        if (size > length - at - 8) {
            refuse("chunk " + std::to_string(number) + " says " + std::to_string(size) +
                   " bytes, " + std::to_string(length - at - 8) + " are left");
        }
        const std::uint32_t type = wordAt(bytes, at + 4);
        const auto content = bytes.subspan(at + 8, size);
        if (number == 0 && type != kJson) refuse("chunk 0 is not of type JSON");
        if (number == 0) chunks.json = content;
        if (number == 1 && type == kBinary) chunks.binary = content;
        at += 8 + size;
    }
    return chunks;
}

// Where one part of the file names another by number: "[]" stands for every element of an array,
// "{}" for every member of an object, all else for a member.
struct Reference {
    const char* steps;
    const char* section;
};
constexpr Reference kReferences[] = {
    {"accessors [] bufferView", "bufferViews"},
    {"accessors [] sparse indices bufferView", "bufferViews"},
    {"accessors [] sparse values bufferView", "bufferViews"},
    {"animations [] channels [] target node", "nodes"},
    {"animations [] samplers [] input", "accessors"},
    {"animations [] samplers [] output", "accessors"},
    {"bufferViews [] buffer", "buffers"},
    {"images [] bufferView", "bufferViews"},
    {"materials [] emissiveTexture index", "textures"},
    {"materials [] normalTexture index", "textures"},
    {"materials [] occlusionTexture index", "textures"},
    {"materials [] pbrMetallicRoughness baseColorTexture index", "textures"},
    {"materials [] pbrMetallicRoughness metallicRoughnessTexture index", "textures"},
    {"meshes [] primitives [] attributes {}", "accessors"},
    {"meshes [] primitives [] indices", "accessors"},
    {"meshes [] primitives [] material", "materials"},
    {"meshes [] primitives [] targets [] {}", "accessors"},
    {"nodes [] camera", "cameras"},
    {"nodes [] children []", "nodes"},
    {"nodes [] mesh", "meshes"},
    {"nodes [] skin", "skins"},
    {"scene", "scenes"},
    {"scenes [] nodes []", "nodes"},
    {"skins [] inverseBindMatrices", "accessors"},
    {"skins [] joints []", "nodes"},
    {"skins [] skeleton", "nodes"},
    {"textures [] sampler", "samplers"},
    {"textures [] source", "images"},
};

void checkReference(const JsonPlace& place, std::string_view steps, const char* section,
                    std::size_t count) {
    if (steps.empty()) {
        const std::size_t index = place.integer(0, 0xffffffffu);
        if (index >= count) {
            place.refuse("is " + std::to_string(index) + ", but there are " +
                         std::to_string(count) + " " + section);
        }
        return;
    }
    const std::size_t space = std::min(steps.find(' '), steps.size());
    const std::string step(steps.substr(0, space));
    const auto rest = steps.substr(std::min(space + 1, steps.size()));
    if (step == "[]") {
        if (!place.json().is_array()) place.refuse("is not an array");
        for (std::size_t i = 0; i < place.size(); ++i)
            checkReference(place.at(i), rest, section, count);
    } else if (!place.json().is_object()) {
        place.refuse("is not an object");
    } else if (step == "{}") {
        for (const auto& [member, value] : place.json().items()) {
            checkReference(place.at(member), rest, section, count);
        }
    } else if (place.has(step.c_str())) {
        checkReference(place.at(step), rest, section, count);
    }
}

void checkVersion(const GltfFile& file) {
    if (!file.json.is_object()) file.root().refuse("JSON is not an object, so this is no glTF");
    const JsonPlace asset = file.root().at("asset");
    for (const char* member : {"version", "minVersion"}) {
        const std::string version = asset.string(member);
        if (version.empty() && member == std::string_view("minVersion")) continue;
        if (version != "2.0" && !(member[0] == 'v' && version.starts_with("2."))) {
            asset.refuse(std::string(member) + " is " + inQuotes(version) +
                         "; only glTF 2.0 is read");
        }
    }
}

// Extensions that may be required: what they change is read here or does not touch the skin.
bool isSupported(std::string_view extension) {
    constexpr std::string_view kSupported[] = {
        "KHR_mesh_quantization", "KHR_texture_transform", "KHR_lights_punctual", "KHR_xmp_json_ld",
        "KHR_animation_pointer", "KHR_texture_basisu",    "EXT_texture_webp"};
    return extension.starts_with("KHR_materials_") ||
           std::find(std::begin(kSupported), std::end(kSupported), extension) !=
               std::end(kSupported);
}

void checkExtensions(const GltfFile& file) {
    const auto required = file.root().array("extensionsRequired");
    if (!required) return;
    for (std::size_t i = 0; i < required->size(); ++i) {
        const JsonPlace place = required->at(i);
        if (!place.json().is_string()) place.refuse("is not a string");
        const auto& extension = place.json().get_ref<const std::string&>();
        if (!isSupported(extension)) {
            file.root().refuse("needs the extension " + inQuotes(extension) +
                               ", which is not supported");
        }
    }
}

std::vector<std::byte> bufferContent(const GltfFile& file, const JsonPlace& buffer,
                                     std::size_t index, const Chunks& chunks, std::size_t length) {
    const std::string uri = buffer.string("uri");
    if (uri.starts_with("data:")) return dataUriBytes(buffer, uri);
    if (!uri.empty()) return readBeside(file.path, uri, kMaxFileBytes - file.bytes);
    if (index == 0 && chunks.binary.data()) {
        const auto used = chunks.binary.first(std::min(length, chunks.binary.size()));
        return {used.begin(), used.end()};
    }
    const auto extensions = buffer.object("extensions");
    if (extensions && extensions->has("EXT_meshopt_compression")) {
        buffer.refuse(
            "has its bytes only through \"EXT_meshopt_compression\", which is not supported");
    }
    buffer.refuse("has no uri, and there is no binary chunk for it");
}

void resolveBuffers(GltfFile& file, const Chunks& chunks) {
    for (std::size_t i = 0; i < file.count("buffers"); ++i) {
        const JsonPlace buffer = file.element("buffers", i);
        const std::size_t length = buffer.integer("byteLength", 0, kMaxFileBytes);
        auto content = bufferContent(file, buffer, i, chunks, length);
        if (content.size() < length) {
            buffer.refuse("byteLength is " + std::to_string(length) + ", but it has " +
                          std::to_string(content.size()) + " bytes");
        }
        content.resize(length);
        if (!buffer.string("uri").starts_with("data:") && !(i == 0 && chunks.binary.data())) {
            file.bytes += length;
        }
        if (file.bytes > kMaxFileBytes)
            buffer.refuse("takes the file and those beside it over 2 GiB");
        file.carried->buffers.push_back(std::move(content));
    }
}

void checkViews(const GltfFile& file) {
    for (std::size_t i = 0; i < file.count("bufferViews"); ++i) {
        const JsonPlace view = file.element("bufferViews", i);
        const std::size_t size =
            file.carried->buffers[view.integer("buffer", 0, 0xffffffffu)].size();
        const std::size_t offset = view.integerOr("byteOffset", 0, kMaxFileBytes);
        const std::size_t length = view.integer("byteLength", 0, kMaxFileBytes);
        if (offset + length > size) {
            view.refuse("bytes " + std::to_string(offset) + " to " +
                        std::to_string(offset + length) + " are past the end of a buffer of " +
                        std::to_string(size));
        }
    }
}

}  // namespace

std::vector<std::byte> dataUriBytes(const JsonPlace& place, const std::string& uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos ||
        !std::string_view(uri).substr(0, comma).ends_with(";base64")) {
        place.refuse("its data URI is not in base64");
    }
    static constexpr std::array<std::uint8_t, 256> kValues = [] {
        std::array<std::uint8_t, 256> values{};
        values.fill(255);
        constexpr std::string_view kDigits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (std::size_t i = 0; i < 64; ++i) {
            values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
        }
        values['-'] = 62;  // base64url, which some writers use
        values['_'] = 63;
        return values;
    }();
    std::string_view digits = std::string_view(uri).substr(comma + 1);
    while (digits.ends_with('=')) digits.remove_suffix(1);
    std::vector<std::byte> out;
    out.reserve(digits.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const std::uint8_t value = kValues[static_cast<unsigned char>(digits[i])];
        if (value == 255) {
            place.refuse("its data URI has no base64 digit at character " +
                         std::to_string(comma + 1 + i));
        }
        bits = bits << 6 | value;
        if (i % 4 != 0) out.push_back(static_cast<std::byte>(bits >> (6 - 2 * (i % 4)) & 0xff));
    }
    return out;
}

std::span<const std::byte> viewBytes(const GltfFile& file, std::size_t view) {
    const JsonPlace place = file.element("bufferViews", view);
    const auto& buffer = file.carried->buffers[place.integer("buffer", 0, 0xffffffffu)];
    return std::span(buffer).subspan(place.integerOr("byteOffset", 0, kMaxFileBytes),
                                     place.integer("byteLength", 0, kMaxFileBytes));
}

GltfFile openGltf(std::span<const std::byte> bytes, const std::string& path) {
    GltfFile file;
    file.name = path.empty() ? "glTF" : path;
    file.path = path;
    file.bytes = bytes.size();
    file.carried = std::make_shared<CarriedGltf>();
    if (bytes.size() > kMaxFileBytes) throw std::runtime_error(file.name + ": is over 2 GiB");
    const Chunks chunks = splitContainer(bytes, file);
    std::string& text = file.carried->json;
    text.assign(reinterpret_cast<const char*>(chunks.json.data()), chunks.json.size());
    file.json = parsedJson(text, file.name);
    checkVersion(file);
    checkExtensions(file);
    for (const Reference& reference : kReferences) {
        checkReference(file.root(), reference.steps, reference.section,
                       file.count(reference.section));
    }
    resolveBuffers(file, chunks);
    checkViews(file);
    file.budget = (std::size_t{1} << 23) + 32 * file.bytes;
    return file;
}

}  // namespace pelage
