// picture.cpp -- what encoded pictures are, and how they are when only their pixels count.
#include <algorithm>
#include <string_view>

#include "gltf_carry.h"

namespace pelage {
namespace {

constexpr std::string_view kPng = "\x89PNG\r\n\x1A\n";

std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// A big-endian number of 32 bits.
std::size_t numberAt(std::span<const std::byte> bytes) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8 | std::to_integer<std::size_t>(bytes[i]);
    return number;
}

}  // namespace

std::string pictureType(std::span<const std::byte> bytes) {
    const std::string_view text = textOf(bytes);
    if (text.starts_with(kPng)) return "image/png";
    if (text.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
    if (text.starts_with("RIFF") && text.size() >= 12 && text.substr(8, 4) == "WEBP")
        return "image/webp";
    if (text.starts_with("\xABKTX 20\xBB\r\n\x1A\n")) return "image/ktx2";
    return "";
}

std::vector<std::byte> plainPicture(std::span<const std::byte> bytes) {
    constexpr std::string_view kDropped[] = {"iCCP", "cHRM", "gAMA", "sRGB", "pHYs"};
    constexpr std::size_t kAround = 12;  // bytes of a chunk's length, type and checksum
    const std::vector<std::byte> whole(bytes.begin(), bytes.end());
    if (!textOf(bytes).starts_with(kPng)) return whole;
    std::vector<std::byte> plain(bytes.begin(), bytes.begin() + kPng.size());
    for (auto rest = bytes.subspan(kPng.size()); !rest.empty();) {
        if (rest.size() < kAround || numberAt(rest) > rest.size() - kAround) return whole;
        const auto chunk = rest.first(numberAt(rest) + kAround);
        const std::string_view type = textOf(chunk.subspan(4, 4));
        if (std::ranges::find(kDropped, type) == std::end(kDropped))
            plain.insert(plain.end(), chunk.begin(), chunk.end());
        rest = rest.subspan(chunk.size());
    }
    return plain;
}

}  // namespace pelage
