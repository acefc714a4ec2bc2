// glb_draft.cpp -- views, accessors and the container of glTF 2.0.
#include "glb_draft.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pelage {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

std::size_t aligned(std::size_t size) { return (size + 3) & ~std::size_t{3}; }

// Appends an object to a top-level array, which is made when the file has none.
std::size_t append(GlbDraft& draft, const char* array, OrderedJson object) {
    OrderedJson& list = draft.json[array];
    if (list.is_null()) list = OrderedJson::array();
    list.push_back(std::move(object));
    return list.size() - 1;
}

void appendWord(std::vector<std::byte>& out, std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<std::byte>((word >> shift) & 0xFFu));
}

}  // namespace

std::size_t appendView(GlbDraft& draft, std::span<const std::byte> bytes, int target,
                       const std::string& name) {
    draft.bin.resize(aligned(draft.bin.size()));
    const std::size_t offset = draft.bin.size();
    draft.bin.insert(draft.bin.end(), bytes.begin(), bytes.end());
    OrderedJson view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    view["name"] = name;
    return append(draft, "bufferViews", std::move(view));
}

std::size_t appendFloats(GlbDraft& draft, std::span<const float> values, int components,
                         const std::string& name) {
    static const char* const kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    const auto width = static_cast<std::size_t>(components);
    assert(width >= 1 && width <= 4 && !values.empty() && values.size() % width == 0);
    std::vector<float> least(values.begin(), values.begin() + components), greatest = least;
    for (std::size_t i = 0; i < values.size(); ++i) {
        assert(std::isfinite(values[i]));
        least[i % width] = std::min(least[i % width], values[i]);
        greatest[i % width] = std::max(greatest[i % width], values[i]);
    }
    const std::size_t view = appendView(draft, std::as_bytes(values), kGlArrayBuffer, name);
    return append(draft, "accessors",
                  {{"bufferView", view},
                   {"componentType", kGlFloat},
                   {"count", values.size() / width},
                   {"type", kTypes[components - 1]},
                   {"min", least},
                   {"max", greatest},
                   {"name", name}});
}

std::size_t appendIndices(GlbDraft& draft, std::span<const uint> indices, const std::string& name) {
    assert(!indices.empty());
    // The largest number of an index type is reserved (glTF 2.0, section 3.7.2.1).
    const uint largest = *std::max_element(indices.begin(), indices.end());
    const bool narrow = largest < std::numeric_limits<std::uint16_t>::max();
    std::size_t view;
    if (narrow) {
        const std::vector<std::uint16_t> halves(indices.begin(), indices.end());
        view = appendView(draft, std::as_bytes(std::span(halves)), kGlElementArrayBuffer, name);
    } else {
        view = appendView(draft, std::as_bytes(indices), kGlElementArrayBuffer, name);
    }
    return append(draft, "accessors",
                  {{"bufferView", view},
                   {"componentType", narrow ? kGlUnsignedShort : kGlUnsignedInt},
                   {"count", indices.size()},
                   {"type", "SCALAR"},
                   {"name", name}});
}

std::size_t appendJoints(GlbDraft& draft, std::span<const std::uint16_t> joints) {
    assert(!joints.empty() && joints.size() % 4 == 0);
    const std::size_t view = appendView(draft, std::as_bytes(joints), kGlArrayBuffer, "joints");
    return append(draft, "accessors",
                  {{"bufferView", view},
                   {"componentType", kGlUnsignedShort},
                   {"count", joints.size() / 4},
                   {"type", "VEC4"}});
}

std::vector<std::byte> packGlb(GlbDraft draft) {
    if (!draft.bin.empty()) {
        OrderedJson& buffers = draft.json["buffers"];
        if (buffers.is_null()) buffers = OrderedJson::array({OrderedJson::object()});
        buffers[0]["byteLength"] = draft.bin.size();
    }
    const std::string text = draft.json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    const std::size_t json = aligned(text.size()), bin = aligned(draft.bin.size());
    const std::size_t total =
        kHeader + kChunkHeader + json + (draft.bin.empty() ? 0 : kChunkHeader + bin);
    if (total > std::numeric_limits<std::uint32_t>::max())
        throw std::runtime_error("export: the file would have " + std::to_string(total) +
                                 " bytes; a .glb holds less than 4294967296");

    std::vector<std::byte> out;
    out.reserve(total);
    appendWord(out, kMagic);
    appendWord(out, 2);
    appendWord(out, total);
    appendWord(out, json);
    appendWord(out, kJsonChunk);
    const auto characters = std::as_bytes(std::span(text));
    out.insert(out.end(), characters.begin(), characters.end());
    out.resize(out.size() + json - text.size(), std::byte{' '});
    if (!draft.bin.empty()) {
        appendWord(out, bin);
        appendWord(out, kBinChunk);
        out.insert(out.end(), draft.bin.begin(), draft.bin.end());
        out.resize(total);
    }
    return out;
}

}  // namespace pelage
