// mirror_gltest.cpp -- the GPU's copy equals the document, and only what differs is uploaded.
#include <gtest/gtest.h>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "core/editor.h"
#include "tests/core/test_skins.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

// A skin of several chunks whose mesh space is not the world.
Document turnedDocument() {
    mat4 toWorld(0.0f);
    toWorld[0] = vec4(0.0f, 2.0f, 0.0f, 0.0f);
    toWorld[1] = vec4(0.0f, 0.0f, 2.0f, 0.0f);
    toWorld[2] = vec4(2.0f, 0.0f, 0.0f, 0.0f);
    toWorld[3] = vec4(1.0f, 2.0f, 3.0f, 1.0f);
    Document document = test::evenDocument(test::sheet(40, toWorld));
    document.fur.hairs = 1000;
    test::Draws draws(1);
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        document.groom.fur.edit(v) = {draws.inBox(0.5f), draws.in(0.0f, 0.1f), vec3(1.0f),
                                      draws.in(0.0f, 1.0f)};
        document.groom.mask.edit(v) = draws.in(0.0f, 1.0f);
    }
    return document;
}

std::size_t chunks(const Groom& groom) {
    return groom.fur.chunkCount() + groom.mask.chunkCount() + groom.segmentOf.chunkCount();
}

void expectEqual(const Mirror& mirror, const Document& document) {
    const std::size_t count = document.skin->vertices.size();
    const auto fur = test::uploaded<FurVertex>(mirror, binding::furVertices, count);
    const auto mask = test::uploaded<float>(mirror, binding::mask, count);
    const auto segments = test::uploaded<uint>(mirror, binding::segmentOf, count);
    std::size_t different = 0;
    for (uint v = 0; v < count; ++v)
        different += segments[v] != document.groom.segmentOf[v] ||
                     !(fur[v] == furToWorld(*document.skin, v, document.groom.fur[v])) ||
                     mask[v] != document.groom.mask[v];
    EXPECT_EQ(different, 0u);
}

TEST(Mirror, TheGpuHoldsTheValuesInTheWorld) {
    const Document document = turnedDocument();
    Mirror mirror;
    EXPECT_TRUE(mirror.update(document));
    expectEqual(mirror, document);
    // The document's frame scales lengths by 2: values in the world are not those of the file.
    EXPECT_FLOAT_EQ(furToWorld(*document.skin, 0, document.groom.fur[0]).furLength,
                    2.0f * document.groom.fur[0].furLength);
    float longest = 0.0f;
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        longest = std::max(longest, 2.0f * document.groom.fur[v].furLength);
    EXPECT_FLOAT_EQ(mirror.longestHair(), longest);
}

TEST(Mirror, UploadedChunksAreTheTouchedOnes) {
    Document document = turnedDocument();
    ASSERT_GT(document.groom.fur.chunkCount(), 4u);
    Mirror mirror;
    mirror.update(document);
    EXPECT_EQ(mirror.chunksUploaded(), chunks(document.groom));

    EXPECT_FALSE(mirror.update(document));
    EXPECT_EQ(mirror.chunksUploaded(), 0u);

    document.groom.fur.edit(700).furLength = 0.25f;
    EXPECT_TRUE(mirror.update(document));
    EXPECT_EQ(mirror.chunksUploaded(), 1u);
    expectEqual(mirror, document);

    document.groom.mask.edit(0) = 0.5f;
    document.groom.fur.edit(1).density = 0.5f;
    document.groom.fur.edit(2).density = 0.5f;
    EXPECT_TRUE(mirror.update(document));
    EXPECT_EQ(mirror.chunksUploaded(), 2u);
    expectEqual(mirror, document);

    document.groom.segmentOf.edit(300) = 1;
    EXPECT_TRUE(mirror.update(document));
    EXPECT_EQ(mirror.chunksUploaded(), 1u);
    expectEqual(mirror, document);

    document.fur.over.stiffness *= 0.5f;
    EXPECT_TRUE(mirror.update(document));
    EXPECT_EQ(mirror.chunksUploaded(), 0u);

    const Document other = turnedDocument();
    EXPECT_TRUE(mirror.update(other));
    EXPECT_EQ(mirror.chunksUploaded(), chunks(other.groom));
    expectEqual(mirror, other);
}

TEST(Mirror, UndoUploadsTheSameChunks) {
    Editor editor(turnedDocument());
    Mirror mirror;
    mirror.update(editor.document());
    editor.edit([](Document& d) {
        for (const uint v : {3u, 300u, 301u, 1400u}) d.groom.fur.edit(v).furLength += 0.01f;
    });
    mirror.update(editor.document());
    const std::size_t touched = mirror.chunksUploaded();
    EXPECT_EQ(touched, 3u);
    ASSERT_TRUE(editor.commit("Length"));
    EXPECT_FALSE(mirror.update(editor.document()));

    ASSERT_TRUE(editor.undo());
    EXPECT_TRUE(mirror.update(editor.document()));
    EXPECT_EQ(mirror.chunksUploaded(), touched);
    expectEqual(mirror, editor.document());

    ASSERT_TRUE(editor.redo());
    EXPECT_TRUE(mirror.update(editor.document()));
    EXPECT_EQ(mirror.chunksUploaded(), touched);
    expectEqual(mirror, editor.document());
}

TEST(Mirror, RootsChangeWithTheirNumberAndSeedOnly) {
    Document document = turnedDocument();
    Mirror mirror;
    const auto rootsAfter = [&] {
        mirror.update(document);
        const auto ids = test::uploaded<Root>(mirror, binding::roots, mirror.roots().roots.size());
        std::vector<uint> result;
        for (const Root& root : ids) result.push_back(root.id);
        return result;
    };
    const auto first = rootsAfter();
    document.fur.share = 0.5f;
    document.groom.fur.edit(0).density = 0.1f;
    EXPECT_EQ(rootsAfter(), first);
    document.fur.seed += 1;
    EXPECT_NE(rootsAfter(), first);
    document.fur.seed -= 1;
    EXPECT_EQ(rootsAfter(), first);
    document.fur.hairs = 500;
    EXPECT_LT(rootsAfter().size(), first.size());
    EXPECT_EQ(mirror.roots().roots.size(), rootsAfter().size());
}

}  // namespace
}  // namespace pelage
