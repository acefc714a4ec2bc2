// pose_gltest.cpp -- an animal that stands in a pose is drawn as if it had been opened so.
#include <gtest/gtest.h>

#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "core/gltf_in.h"
#include "core/pose.h"
#include "tests/core/animated.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

// A sheet that bends, with hair whose look does not depend on the size of the skin at rest. Clip
// "bend" bends it and clip 2 takes it far away.
Document bendingDocument() {
    test::GltfMaker maker = test::bendingSheet(20);
    test::addChannel(maker, 1, 1, "translation", {0.0f}, {0, 0, 64});
    Document document = openDocument(readGltf(maker.glb(), ""));
    document.fur.hairs = 4000;
    document.fur.over.width = document.fur.under.width = 2e-3f;
    return document;
}

View viewOf(const Skin& skin) {
    View view;
    view.size = ivec2(160);
    view.camera = framed(skin.center(), 1.2f * skin.radius, 0.7f, 0.4f, 1.0f);
    view.detail.rule = Detail::Rule::all;
    return view;
}

void expectHolds(const Mirror& mirror, const Document& document, const Skin& shown) {
    const std::size_t count = shown.vertices.size();
    const auto vertices = test::uploaded<SkinVertex>(mirror, binding::skinVertices, count);
    const auto fur = test::uploaded<FurVertex>(mirror, binding::furVertices, count);
    std::size_t different = 0;
    for (uint v = 0; v < count; ++v)
        different += vertices[v].position != shown.vertices[v].position ||
                     vertices[v].normal != shown.vertices[v].normal ||
                     !(fur[v] == furToWorld(shown, v, document.groom.fur[v]));
    EXPECT_EQ(different, 0u);
}

TEST(PoseOnGpu, TheMirrorHoldsThePoseAndKeepsTheRoots) {
    Document document = bendingDocument();
    const auto posed = posedSkin(document.skin, {0, 1.0f, {}});
    Mirror mirror;
    mirror.update(document);
    const Roots atRest = mirror.roots();
    EXPECT_TRUE(mirror.update(document, posed));
    expectHolds(mirror, document, *posed);
    EXPECT_FALSE(mirror.update(document, posed));
    EXPECT_EQ(mirror.chunksUploaded(), 0u);
    for (std::size_t i = 0; i < atRest.roots.size(); ++i) {
        ASSERT_EQ(mirror.roots().roots[i].id, atRest.roots[i].id);
        ASSERT_EQ(mirror.roots().roots[i].guide, atRest.roots[i].guide);
    }
    // An edit while it stands so uploads what it touched, in the pose.
    document.groom.fur.edit(3).furLength = 0.25f;
    EXPECT_TRUE(mirror.update(document, posed));
    EXPECT_EQ(mirror.chunksUploaded(), 1u);
    expectHolds(mirror, document, *posed);
    document.fur.hairs = 3000;
    mirror.update(document, posed);
    for (const Cluster& cluster : mirror.roots().clusters)
        EXPECT_LT(glm::distance(cluster.center, posed->center()), posed->radius);

    EXPECT_TRUE(mirror.update(document));
    expectHolds(mirror, document, *document.skin);
    document.fur.hairs = 4000;
    mirror.update(document);
    ASSERT_EQ(mirror.roots().clusters.size(), atRest.clusters.size());
    for (std::size_t c = 0; c < atRest.clusters.size(); ++c)
        EXPECT_EQ(mirror.roots().clusters[c].center, atRest.clusters[c].center);
}

TEST(PoseOnGpu, ThePictureIsThatOfThePosedSkinAsADocument) {
    const Document document = bendingDocument();
    Renderer renderer;
    for (const int clip : {0, 1}) {
        const auto posed = posedSkin(document.skin, {clip, 0.7f, {}});
        View view = viewOf(*posed);
        const test::Pixels alone =
            test::picture(renderer, {posed, document.groom, document.fur}, view);
        view.posed = posed;
        const test::Pixels seen = test::picture(renderer, document, view);
        std::size_t different = 0, colored = 0;
        for (std::size_t i = 0; i < seen.size(); i += 4) {
            different += !std::equal(&seen[i], &seen[i] + 3, &alone[i]);
            colored += !std::equal(&seen[i], &seen[i] + 3, seen.data());
        }
        EXPECT_EQ(different, 0u) << clip;
        EXPECT_GT(colored, 2000u) << clip;  // of 25600 pixels: not culled, not clipped
    }
}

TEST(PoseOnGpu, APoseBeginsThePictureAnewAndRestBringsItBack) {
    const Document document = bendingDocument();
    Renderer renderer;
    View view = viewOf(*document.skin);
    view.samples = 3;
    const test::Pixels rest = test::picture(renderer, document, view);
    EXPECT_TRUE(renderer.draw(document, view).finished);
    view.posed = posedSkin(document.skin, {0, 1.0f, {}});
    EXPECT_EQ(renderer.draw(document, view).samples, 1);
    EXPECT_NE(test::picture(renderer, document, view), rest);
    view.posed.reset();
    EXPECT_EQ(renderer.draw(document, view).samples, 1);
    EXPECT_EQ(test::picture(renderer, document, view), rest);
}

}  // namespace
}  // namespace pelage
