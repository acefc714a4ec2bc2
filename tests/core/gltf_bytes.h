// gltf_bytes.h -- the bytes of glTF files: .glb put together and taken apart, and base64.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace pelage::test {

using OrderedJson = nlohmann::ordered_json;

struct Glb {
    OrderedJson json;
    std::vector<std::byte> bin;
};

inline std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.subspan(offset, 4).data(), 4);
    return word;
}

inline Glb takeApart(std::span<const std::byte> file) {
    const std::size_t json = wordAt(file, 12);
    const auto* text = reinterpret_cast<const char*>(file.data()) + 20;
    Glb glb{OrderedJson::parse(text, text + json), {}};
    if (file.size() > 20 + json) {
        const auto bin = file.subspan(28 + json, wordAt(file, 20 + json));
        glb.bin.assign(bin.begin(), bin.end());
    }
    return glb;
}

// A .glb of any text and binary chunk (none when empty).
inline std::vector<std::byte> putTogether(std::string text, std::vector<std::byte> content) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    content.resize((content.size() + 3) / 4 * 4);
    std::vector<std::byte> out;
    const auto word = [&](std::size_t value) {
        for (int shift = 0; shift < 32; shift += 8)
            out.push_back(static_cast<std::byte>(value >> shift & 0xff));
    };
    word(0x46546c67), word(2);
    word(20 + text.size() + (content.empty() ? 0 : 8 + content.size()));
    word(text.size()), word(0x4e4f534a);
    for (const char c : text) out.push_back(static_cast<std::byte>(c));
    if (content.empty()) return out;
    word(content.size()), word(0x004e4942);
    out.insert(out.end(), content.begin(), content.end());
    return out;
}

inline std::string base64(std::span<const std::byte> bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 |
                    (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
    return out;
}

inline std::string dataUri(std::span<const std::byte> bytes) {
    return "data:application/octet-stream;base64," + base64(bytes);
}

template <typename T>
std::vector<std::byte> bytesOf(const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}

}  // namespace pelage::test
