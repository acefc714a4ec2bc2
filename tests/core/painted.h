// painted.h -- documents with another value at every vertex, for tests that write and read them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#include "core/coat.h"
#include "core/document.h"
#include "core/gltf_in.h"
#include "core/mesh_in.h"
#include "core/strand.h"
#include "gtest/gtest.h"
#include "reading.h"

namespace pelage::test {

inline Document opened(std::span<const std::byte> bytes) {
    return openDocument(readGltf(bytes, "test.glb"));
}

// Another value at each vertex, with all fraction bits in use.
inline void paint(Document& document, uint salt = 0) {
    for (uint v = 0; v < document.groom.fur.size(); ++v) {
        FurVertex& fur = document.groom.fur.edit(v);
        const auto draw = [&](uint k) { return rand01(pcg(v * 8 + k + salt * 1000003)); };
        fur.furLength = draw(0);
        fur.density = draw(1);
        fur.direction = (2.0f * vec3(draw(2), draw(3), draw(4)) - 1.0f) / std::sqrt(3.0f);
        fur.tint = vec3(draw(5), draw(6), draw(7));
    }
    applyPreset(document.fur, presets()[salt % presets().size()]);
    document.fur.seed = 77 + salt;
}

inline Document painted(std::span<const std::byte> bytes) {
    Document document = opened(bytes);
    paint(document);
    return document;
}

inline void expectSameFields(const Document& a, const Document& b) {
    ASSERT_EQ(a.groom.fur.size(), b.groom.fur.size());
    std::size_t different = 0;
    for (std::size_t v = 0; v < a.groom.fur.size(); ++v) {
        const FurVertex &x = a.groom.fur[v], &y = b.groom.fur[v];
        different += std::memcmp(&x.furLength, &y.furLength, sizeof(float)) != 0;
        different += std::memcmp(&x.density, &y.density, sizeof(float)) != 0;
        different += std::memcmp(&x.direction, &y.direction, sizeof(vec3)) != 0;
        different += std::memcmp(&x.tint, &y.tint, sizeof(vec3)) != 0;
    }
    EXPECT_EQ(different, 0u);
    EXPECT_EQ(furToJson(a.fur), furToJson(b.fur));
}

// A sheet of two triangles and one with a corner twice, and a vertex that none of them uses; as
// OBJ.
inline Document paintedObj() {
    Document document =
        openDocument(readObj(bytesOf("v 0 0 0\nv 0.1 0 0\nv 0.1 0.3 0\nv 0 0.3 0\nv 9 9 9\n"
                                     "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                     "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 2/2 2/2\n"),
                             ""));
    paint(document);
    return document;
}

}  // namespace pelage::test
