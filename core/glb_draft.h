// glb_draft.h -- a glTF being put together: its JSON and its one binary chunk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "types.h"

namespace pelage {

using OrderedJson = nlohmann::ordered_json;  // keeps the order of keys

struct GlbDraft {
    OrderedJson json;
    std::vector<std::byte> bin;  // content of buffer 0; its byteLength is set by packGlb
};

// Numbers of glTF 2.0, section 3.6 and 3.7.
inline constexpr int kGlFloat = 5126, kGlUnsignedShort = 5123, kGlUnsignedInt = 5125;
inline constexpr int kGlArrayBuffer = 34962, kGlElementArrayBuffer = 34963;

// Appends the bytes on a 4-byte boundary and a view of them; returns the number of the view.
// A target of 0 is left out.
std::size_t appendView(GlbDraft& draft, std::span<const std::byte> bytes, int target,
                       const std::string& name);

// Appends float values with a view of their own, and their exact least and greatest; returns the
// number of the accessor. `components` is 1 to 4; values.size() is a multiple of it. Asserts that
// every value is finite.
std::size_t appendFloats(GlbDraft& draft, std::span<const float> values, int components,
                         const std::string& name);

// Appends vertex numbers in 16 bits, or in 32 where the largest does not fit.
std::size_t appendIndices(GlbDraft& draft, std::span<const uint> indices, const std::string& name);

// Appends four joint numbers per vertex, with a view of their own; returns the number of the
// accessor.
std::size_t appendJoints(GlbDraft& draft, std::span<const std::uint16_t> joints);

// The .glb: header, JSON chunk, binary chunk (none when it is empty). In names that are not UTF-8
// (those of files and OBJ materials need not be) the wrong bytes become U+FFFD. Throws
// std::runtime_error when it would be 4 GiB or more.
std::vector<std::byte> packGlb(GlbDraft draft);

}  // namespace pelage
