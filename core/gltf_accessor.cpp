// gltf_accessor.cpp -- decodes accessors: strides, component types, normalized integers, sparse.
#include "gltf_accessor.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "text.h"

namespace pelage {
namespace {

enum ComponentType : std::size_t {
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kUnsignedInt = 5125,
    kFloat = 5126,
};

std::size_t componentBytes(const JsonPlace& place, std::size_t type) {
    switch (type) {
        case kByte:
        case kUnsignedByte:
            return 1;
        case kShort:
        case kUnsignedShort:
            return 2;
        case kUnsignedInt:
        case kFloat:
            return 4;
    }
    place.refuse("componentType " + std::to_string(type) + " is none of glTF");
}

struct Type {
    const char* name;
    std::size_t components, columns;
};
constexpr Type kTypes[] = {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1},
                           {"MAT2", 4, 2},   {"MAT3", 9, 3}, {"MAT4", 16, 4}};

// Elements as they lie in memory. No data means zeros.
struct Elements {
    const std::byte* data = nullptr;
    std::size_t count = 0, stride = 0;
    std::size_t componentType = 0, componentBytes = 0;
    std::size_t components = 0, columns = 1, columnBytes = 0;  // columns start on 4 bytes
    bool normalized = false;

    std::size_t elementBytes() const {
        return (columns - 1) * columnBytes + components / columns * componentBytes;
    }
    const std::byte* component(std::size_t element, std::size_t c) const {
        const std::size_t rows = components / columns;
        return data + element * stride + c / rows * columnBytes + c % rows * componentBytes;
    }
};

// Points `elements` at its bytes in a buffer view, after checking that all of them are there.
void locate(const GltfFile& file, const JsonPlace& place, Elements& elements) {
    const std::size_t view = place.integer("bufferView", 0, 0xffffffffu);
    const auto bytes = viewBytes(file, view);
    const std::size_t offset = place.integerOr("byteOffset", 0, kMaxFileBytes);
    const std::size_t packed =
        elements.columns > 1 ? elements.columns * elements.columnBytes : elements.elementBytes();
    elements.stride = file.element("bufferViews", view).integerOr("byteStride", packed, 1 << 16);
    if (elements.stride < elements.elementBytes()) {
        place.refuse("byteStride " + std::to_string(elements.stride) +
                     " of its buffer view is less than an element of " +
                     std::to_string(elements.elementBytes()) + " bytes");
    }
    // Neither factor is above 2^31 and 2^16, so nothing overflows.
    const std::size_t end = elements.count == 0 ? 0
                                                : offset + (elements.count - 1) * elements.stride +
                                                      elements.elementBytes();
    if (end > bytes.size()) {
        place.refuse(std::to_string(elements.count) + " elements end at byte " +
                     std::to_string(end) + " of a buffer view of " + std::to_string(bytes.size()));
    }
    elements.data = bytes.data() + std::min(offset, bytes.size());
}

Elements baseElements(const GltfFile& file, const JsonPlace& place) {
    Elements elements;
    elements.count = place.integer("count", 1, std::size_t{1} << 31);
    elements.componentType = place.integer("componentType", 0, 1 << 16);
    elements.componentBytes = componentBytes(place, elements.componentType);
    elements.normalized = place.boolean("normalized");
    const std::string name = place.string("type");
    const auto type = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const Type& t) { return t.name == name; });
    if (type == std::end(kTypes))
        place.refuse("type is " + inQuotes(name) + ", which is none of glTF");
    elements.components = type->components;
    elements.columns = type->columns;
    elements.columnBytes = (type->components / type->columns * elements.componentBytes + 3) / 4 * 4;
    if (place.has("bufferView")) {
        locate(file, place, elements);
    } else if (elements.count > file.elementLimit()) {
        place.refuse("has no buffer view and a count of " + std::to_string(elements.count) +
                     "; at most " + std::to_string(file.elementLimit()) +
                     " elements are made from nothing in a file of this size");
    }
    return elements;
}

template <typename T>
T load(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

// glTF 2.0, section 3.6.2.2.
template <typename T>
float asFloat(const std::byte* from, bool normalized) {
    const T value = load<T>(from);
    if constexpr (std::is_same_v<T, float>) {
        return value;
    } else {
        const float real = static_cast<float>(value);
        if (!normalized) return real;
        const float scaled = real / static_cast<float>(std::numeric_limits<T>::max());
        return std::max(scaled, -1.0f);
    }
}

float floatAt(const Elements& elements, const std::byte* at) {
    switch (elements.componentType) {
        case kByte:
            return asFloat<std::int8_t>(at, elements.normalized);
        case kUnsignedByte:
            return asFloat<std::uint8_t>(at, elements.normalized);
        case kShort:
            return asFloat<std::int16_t>(at, elements.normalized);
        case kUnsignedShort:
            return asFloat<std::uint16_t>(at, elements.normalized);
        case kUnsignedInt:
            return asFloat<std::uint32_t>(at, elements.normalized);
        default:
            return asFloat<float>(at, false);
    }
}

uint integerAt(const Elements& elements, const std::byte* at) {
    switch (elements.componentType) {
        case kUnsignedByte:
            return load<std::uint8_t>(at);
        case kUnsignedShort:
            return load<std::uint16_t>(at);
        default:
            return load<std::uint32_t>(at);
    }
}

bool isUnsigned(std::size_t type) {
    return type == kUnsignedByte || type == kUnsignedShort || type == kUnsignedInt;
}

struct Sparse {
    Elements indices, values;
};

Sparse sparseElements(const GltfFile& file, const JsonPlace& sparse, const Elements& base) {
    const std::size_t count = sparse.integer("count", 1, base.count);
    const JsonPlace indices = sparse.at("indices");
    Sparse out;
    out.indices.count = out.values.count = count;
    out.indices.components = 1;
    out.indices.componentType = indices.integer("componentType", 0, 1 << 16);
    out.indices.componentBytes = componentBytes(indices, out.indices.componentType);
    if (!isUnsigned(out.indices.componentType))
        indices.refuse("componentType is not one of unsigned integers");
    locate(file, indices, out.indices);
    out.values = base;
    out.values.count = count;
    locate(file, sparse.at("values"), out.values);
    return out;
}

// Calls `decode(elements, at)` for every component of the first `most` elements, in order.
template <typename T, typename Decode>
std::vector<T> decoded(GltfFile& file, const JsonPlace& place, Elements elements, std::size_t most,
                       Decode decode) {
    const std::size_t count = std::min(elements.count, most);
    const auto sparse = place.object("sparse");
    const std::size_t changed = sparse ? sparse->integer("count", 1, elements.count) : 0;
    const std::size_t cost = (count + changed) * elements.components;
    if (cost > file.budget) {
        place.refuse("is one of too many: for its size, the file asks for too many numbers");
    }
    file.budget -= cost;
    std::vector<T> out(count * elements.components);
    for (std::size_t i = 0; elements.data && i < count; ++i) {
        for (std::size_t c = 0; c < elements.components; ++c) {
            out[i * elements.components + c] = decode(elements, elements.component(i, c));
        }
    }
    if (sparse) {
        const auto [indices, values] = sparseElements(file, *sparse, elements);
        for (std::size_t s = 0; s < values.count; ++s) {
            const uint i = integerAt(indices, indices.component(s, 0));
            if (i >= elements.count) {
                sparse->refuse("index " + std::to_string(s) + " is " + std::to_string(i) + " of " +
                               std::to_string(elements.count));
            }
            for (std::size_t c = 0; i < count && c < elements.components; ++c) {
                out[i * elements.components + c] = decode(values, values.component(s, c));
            }
        }
    }
    return out;
}

Elements elementsOf(const GltfFile& file, const JsonPlace& place, std::size_t components) {
    const Elements elements = baseElements(file, place);
    if (elements.components != components) {
        place.refuse("has " + std::to_string(elements.components) + " components where " +
                     std::to_string(components) + " are needed");
    }
    return elements;
}

}  // namespace

AccessorShape accessorShape(const GltfFile& file, std::size_t accessor) {
    const Elements elements = baseElements(file, file.element("accessors", accessor));
    return {elements.count, elements.components};
}

std::vector<float> accessorFloats(GltfFile& file, std::size_t accessor, std::size_t components,
                                  std::size_t most) {
    const JsonPlace place = file.element("accessors", accessor);
    return decoded<float>(file, place, elementsOf(file, place, components), most, floatAt);
}

std::vector<uint> accessorIntegers(GltfFile& file, std::size_t accessor, std::size_t components) {
    const JsonPlace place = file.element("accessors", accessor);
    const Elements elements = elementsOf(file, place, components);
    if (!isUnsigned(elements.componentType)) {
        place.refuse("componentType " + std::to_string(elements.componentType) +
                     " is not one of unsigned integers");
    }
    return decoded<uint>(file, place, elements, ~std::size_t{0}, integerAt);
}

}  // namespace pelage
