// pose_test.cpp -- where the skin and its fur stand in a pose, and that painting there is at rest.
#include "core/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animated.h"
#include "core/gltf_in.h"
#include "core/gltf_out.h"
#include "core/rig.h"
#include "core/script.h"
#include "core/strands_out.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::addChannel;
using test::GltfMaker;
using test::refusal;
using test::sameBits;

std::shared_ptr<const Skin> skinOf(const GltfMaker& maker) {
    return makeSkin(readGltf(maker.glb(), ""));
}

Document documentOf(const GltfMaker& maker) { return openDocument(readGltf(maker.glb(), "")); }

float farthestApart(const Skin& a, const Skin& b) {
    float far = 0.0f;
    for (std::size_t v = 0; v < a.vertices.size(); ++v)
        far = std::max(far, glm::distance(a.vertices[v].position, b.vertices[v].position));
    return far;
}

// Skin vertex of a vertex of the file.
const SkinVertex& vertexOf(const Skin& skin, uint source) {
    return skin.vertices[skin.weld[source]];
}

bool near(vec3 a, vec3 b) { return glm::distance(a, b) < 1e-5f; }

TEST(Pose, AtRestIsTheRestSkinItself) {
    const auto rest = skinOf(test::bendingSheet(4));
    EXPECT_EQ(posedSkin(rest, {}), rest);
}

TEST(Pose, KeysAtRestGiveTheRestSkinBitForBit) {
    GltfMaker maker = GltfMaker::skinned();
    maker.json["nodes"][1]["rotation"] = {0.1, 0.2, -0.3, 0.9};
    maker.json["nodes"][2]["rotation"] = {0.3, -0.2, 0.3, 0.7};
    maker.json["nodes"][2]["scale"] = {1.5, 0.7, -1.1};
    for (const int node : {1, 2}) {
        for (const char* path : {"translation", "rotation", "scale"}) {
            const auto& value = maker.json["nodes"][static_cast<std::size_t>(node)];
            if (!value.contains(path)) continue;
            const auto key = value[path].get<std::vector<float>>();
            addChannel(maker, 0, node, path, {0.0f, 1.0f}, test::joined(key, key));
        }
    }
    const auto rest = skinOf(maker);
    for (const float seconds : {0.0f, 0.3f, 1.0f}) {
        const auto posed = posedSkin(rest, {0, seconds, {}});
        EXPECT_NE(posed, rest);
        EXPECT_TRUE(sameBits(posed->vertices, rest->vertices));
        EXPECT_TRUE(sameBits(posed->frames, rest->frames));
        EXPECT_EQ(posed->lower, rest->lower);
        EXPECT_EQ(posed->upper, rest->upper);
        EXPECT_EQ(posed->radius, rest->radius);
    }
}

TEST(Pose, SkinnedVerticesFollowTheirJointsAndNotTheirNode) {
    GltfMaker maker = test::bendingSheet(10);
    // The node of the mesh runs away; a skinned mesh does not follow it.
    addChannel(maker, 0, 0, "translation", {0.0f, 1.0f}, {3, 4, 5, 100, 0, 0});
    const auto rest = skinOf(maker);
    const auto posed = posedSkin(rest, {0, 1.0f, {}});
    for (std::size_t v = 0; v < rest->vertices.size(); ++v) {
        const vec3 p = rest->vertices[v].position, q = posed->vertices[v].position;
        if (p.x < -0.15f) {
            EXPECT_EQ(q, p);
        }
        if (p.x > 0.15f) {
            EXPECT_TRUE(near(q, vec3(0.0f, p.x, p.z)));
            EXPECT_TRUE(near(posed->vertices[v].normal, vec3(-1.0f, 0.0f, 0.0f)));
        }
    }
    EXPECT_TRUE(near(posed->upper, vec3(posed->upper.x, 0.5f, 0.5f)));
    EXPECT_EQ(posed->areas, rest->areas);
    EXPECT_EQ(posed->triangles, rest->triangles);
    EXPECT_EQ(posed->source, rest->source);
}

TEST(Pose, HairTurnsWithTheSkinAndGrowsWithItsScale) {
    GltfMaker maker = test::bendingSheet(10);
    addChannel(maker, 0, 2, "scale", {0.0f, 1.0f}, {1, 1, 1, 2, 2, 2});
    const auto rest = skinOf(maker);
    const auto posed = posedSkin(rest, {0, 1.0f, {}});
    const FurVertex fur{vec3(0.5f, 0.0f, 0.0f), 0.1f, vec3(1.0f), 1.0f};  // combed along x
    int turned = 0;
    for (uint v = 0; v < rest->vertices.size(); ++v) {
        const vec3 p = rest->vertices[v].position;
        const FurVertex there = furToWorld(*posed, v, fur);
        if (p.x < -0.15f) {
            EXPECT_TRUE(there == furToWorld(*rest, v, fur));
        }
        if (p.x < 0.15f) continue;
        EXPECT_TRUE(near(there.direction, vec3(0.0f, 0.5f, 0.0f)));
        EXPECT_NEAR(there.furLength, 0.2f, 1e-6f);
        const FurVertex back = furToMesh(*posed, v, there);
        EXPECT_TRUE(near(back.direction, fur.direction));
        EXPECT_NEAR(back.furLength, fur.furLength, 1e-6f);
        ++turned;
    }
    EXPECT_GT(turned, 30);
}

TEST(Pose, MirroredJointsKeepNormalsOutside) {
    GltfMaker maker = test::bendingSheet(4);
    addChannel(maker, 0, 1, "scale", {0.0f, 1.0f}, {1, 1, 1, -1, 1, 1}, "STEP");
    const auto rest = skinOf(maker);
    const auto posed = posedSkin(rest, {0, 0.0f, {}}), mirrored = posedSkin(rest, {0, 1.0f, {}});
    for (std::size_t v = 0; v < rest->vertices.size(); ++v) {
        EXPECT_TRUE(near(posed->vertices[v].normal, vec3(0.0f, 1.0f, 0.0f)));
        if (rest->vertices[v].position.x < -0.15f) {
            EXPECT_TRUE(near(mirrored->vertices[v].normal, vec3(0.0f, 1.0f, 0.0f)));
        }
    }
}

TEST(Pose, JointsScaledAwayLoseTheirHair) {
    GltfMaker maker = test::bendingSheet(10);
    addChannel(maker, 0, 1, "scale", {0.0f}, {0, 0, 0}, "STEP");
    Document document = documentOf(maker);
    document.skin = posedSkin(document.skin, {0, 0.0f, {}});
    const Roots roots = scatterRoots(*documentOf(maker).skin, 1000, 1);
    EXPECT_EQ(growCurves(document, roots, 4).root.size(), 0u);
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        const FurVertex fur = furToMesh(*document.skin, v, document.groom.fur[v]);
        EXPECT_TRUE(std::isfinite(fur.furLength) && std::isfinite(fur.direction.x));
    }
}

TEST(Pose, NodesMoveMeshesThatNoJointHolds) {
    GltfMaker maker = GltfMaker::triangle();
    maker.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}};
    maker.json["scenes"] = {{{"nodes", {1}}}};
    addChannel(maker, 0, 1, "rotation", {0.0f, 1.0f},
               test::joined(test::kNoTurn, test::kQuarterTurn));
    addChannel(maker, 0, 1, "translation", {0.0f, 1.0f}, {0, 0, 0, 10, 0, 0});
    const auto rest = skinOf(maker);
    const auto posed = posedSkin(rest, {0, 1.0f, {}});
    EXPECT_TRUE(near(vertexOf(*posed, 0).position, vec3(10, 0, 0)));
    EXPECT_TRUE(near(vertexOf(*posed, 1).position, vec3(10, 1, 0)));
    EXPECT_TRUE(near(vertexOf(*posed, 2).position, vec3(9, 0, 0)));
    const FurVertex fur{vec3(1.0f, 0.0f, 0.0f), 0.1f, vec3(1.0f), 1.0f};
    EXPECT_TRUE(near(furToWorld(*posed, 0, fur).direction, vec3(0, 1, 0)));
}

TEST(Pose, TargetsMoveTheirVerticesByTheirWeights) {
    GltfMaker maker = test::morphing();
    addChannel(maker, 0, 0, "weights", {0.0f, 1.0f}, {0, 0, 0, 1, 0.5, 0});
    const auto rest = skinOf(maker);
    const std::vector<MorphTarget>& targets = rest->source->rig->targets;
    ASSERT_EQ(targets.size(), 3u);
    EXPECT_EQ(targets[0].name, "tall");
    EXPECT_EQ(targets[1].name, "target 2");
    EXPECT_EQ(targets[0].weight, 0.5f);
    EXPECT_EQ(vertexOf(*rest, 2).position, vec3(0, 2, 0));  // the file's own weights

    const auto own = posedSkin(rest, {-1, 0.0f, {0.5f, 0.0f, 0.0f}});
    EXPECT_TRUE(sameBits(own->vertices, rest->vertices));
    const auto set = posedSkin(rest, {-1, 0.0f, {1.0f, 2.0f, 1.0f}});
    EXPECT_EQ(vertexOf(*set, 2).position, vec3(0, 3, 2));
    EXPECT_EQ(vertexOf(*set, 0).position, vec3(0, 0, 2));
    // A track wins over what was set.
    const auto played = posedSkin(rest, {0, 0.5f, {9.0f, 9.0f, 9.0f}});
    EXPECT_EQ(vertexOf(*played, 2).position, vec3(0, 2, 0.25f));
}

TEST(Pose, NormalsFollowTheTargets) {
    GltfMaker maker = test::morphing();
    const int tilt = maker.add<float>({0, 0, 0, 0, 0, 0, 0, -1, 1}, "VEC3", 5126);
    maker.primitive()["targets"][1]["POSITION"] = tilt;
    const auto posed = posedSkin(skinOf(maker), {-1, 0.0f, {0.0f, 1.0f, 0.0f}});
    EXPECT_TRUE(near(vertexOf(*posed, 0).normal, vec3(0, -1, 0)));
}

TEST(Pose, NothingLeavesTheRangeOfFloats) {
    GltfMaker maker = test::bendingSheet(4);
    addChannel(maker, 1, 1, "scale", {0.0f}, {1e38f, 1e38f, 1e38f}, "STEP");
    addChannel(maker, 1, 2, "scale", {0.0f}, {1e38f, 1e38f, -1e38f}, "STEP");
    addChannel(maker, 2, 1, "rotation", {0.0f, 1.0f}, {0, 0, 0, 0, 0, 0, 0, 0});
    const auto rest = skinOf(maker);
    for (const int clip : {1, 2}) {
        const auto posed = posedSkin(rest, {clip, 0.5f, {}});
        EXPECT_TRUE(sameBits(posed->vertices, rest->vertices)) << clip;
    }
}

TEST(Pose, ClustersHoldTheirRootsInAPose) {
    const auto rest = skinOf(test::bendingSheet(20));
    Roots roots = scatterRoots(*rest, 5000, 3);
    const Roots before = roots;
    const auto posed = posedSkin(rest, {0, 1.0f, {}});
    boundClusters(roots, *posed);
    for (const Cluster& cluster : roots.clusters) {
        for (uint i = 0; i < cluster.count; ++i) {
            const Root& root = roots.roots[cluster.first + i];
            const uvec3 t = posed->triangles[root.triangle];
            for (int c = 0; c < 3; ++c)
                ASSERT_LE(glm::distance(posed->vertices[t[c]].position, cluster.center),
                          cluster.radius + 1e-6f);
        }
    }
    boundClusters(roots, *rest);
    for (std::size_t c = 0; c < roots.clusters.size(); ++c) {
        EXPECT_EQ(roots.clusters[c].center, before.clusters[c].center);
        EXPECT_EQ(roots.clusters[c].radius, before.clusters[c].radius);
    }
}

TEST(Pose, TheExportIsOfTheRestPose) {
    Workspace workspace;
    workspace.open(documentOf(test::bendingSheet(6)));
    const auto before = groomedGlb(workspace.editor->document());
    runLine(workspace, "pose bend 0.5");
    EXPECT_EQ(groomedGlb(workspace.editor->document()), before);
}

// Its clips are Survey, Walk and Run.
TEST(Pose, FoxWalksForAHundredFrames) {
    const std::string path = test::sharedMesh("Fox.glb");
    if (path.empty()) GTEST_SKIP() << "Fox.glb is not beside the repository";
    Document document = openDocument(readSource(path));
    document.fur.hairs = 2000;
    document.fur.over.style = document.fur.under.style = kStyleCurve;
    const auto rest = document.skin;
    const Roots roots = scatterRoots(*rest, document.fur.hairs, document.fur.seed);
    ASSERT_EQ(rest->source->rig->clips.size(), 3u);
    const int walk = clipNamed(*rest, "Walk");
    const float seconds = rest->source->rig->clips[static_cast<std::size_t>(walk)].seconds;
    float moved = 0.0f, worstRoot = 0.0f, worstLength = 0.0f;
    for (int frame = 0; frame < 100; ++frame) {
        document.skin = posedSkin(rest, {walk, seconds * static_cast<float>(frame) / 99.0f, {}});
        const Skin& skin = *document.skin;
        moved = std::max(moved, farthestApart(skin, *rest));
        for (const SkinVertex& v : skin.vertices)
            ASSERT_TRUE(std::isfinite(glm::dot(v.position, v.position)) &&
                        std::isfinite(glm::dot(v.normal, v.normal)));
        const Curves curves = growCurves(document, roots, 16);
        ASSERT_GT(curves.root.size(), 1000u);
        for (std::size_t h = 0; h < curves.root.size(); ++h) {
            const Root& root = roots.roots[curves.root[h]];
            const uvec3 t = skin.triangles[root.triangle];
            const vec3 w = baryWeights(root.bary);
            const vec3 place = w.x * skin.vertices[t.x].position +
                               w.y * skin.vertices[t.y].position +
                               w.z * skin.vertices[t.z].position;
            const vec3* points = &curves.points[h * curves.pointsPerHair];
            worstRoot = std::max(worstRoot, glm::distance(points[0], place));
            float drawn = 0.0f;
            for (uint p = 1; p < curves.pointsPerHair; ++p)
                drawn += glm::distance(points[p - 1], points[p]);
            ASSERT_TRUE(std::isfinite(drawn));
            const auto painted = [&](uint v) {
                return furToWorld(skin, v, document.groom.fur[v]).furLength;
            };
            const Coat& coat =
                isOvercoat(root.id, document.fur.share) ? document.fur.over : document.fur.under;
            const float asked = coat.relativeLength *
                                (w.x * painted(t.x) + w.y * painted(t.y) + w.z * painted(t.z));
            worstLength = std::max(worstLength, std::abs(drawn - asked) / asked);
        }
    }
    EXPECT_GT(moved, 0.05f * rest->size());
    EXPECT_LT(worstRoot, 1e-5f * rest->size());
    EXPECT_LT(worstLength, 5e-3f);  // of chords, which are shorter than their curve
}

TEST(PoseScript, LinesReadBackBitForBit) {
    GltfMaker maker = test::morphing();
    for (std::size_t a = 0; a < 3; ++a)
        addChannel(maker, a, 0, "translation", {0.0f, 1.0f}, {0, 0, 0, 1, 0, 0});
    const auto skin = skinOf(maker);
    test::Draws draws(7);
    for (int i = 0; i < 200; ++i) {
        Pose pose;
        pose.clip = static_cast<int>(draws.below(4)) - 1;
        if (pose.clip >= 0) pose.seconds = draws.in(-1.0f, 3.0f);
        if (draws.below(2)) pose.weights = {draws.in(-1.0f, 2.0f), draws.in(0.0f, 1.0f), 0.0f};
        const std::string line = poseLine(pose);
        Words words(line);
        words.next();
        EXPECT_EQ(poseFromWords(*skin, words), pose) << line;
    }
}

Pose poseOf(const Skin& skin, std::string_view text) {
    Words words(text);
    return poseFromWords(skin, words);
}

TEST(PoseScript, ClipsGoByNameOrNumber) {
    GltfMaker maker = test::morphing();
    for (std::size_t a = 0; a < 3; ++a)
        addChannel(maker, a, 0, "translation", {0.0f, 1.0f}, {0, 0, 0, 1, 0, 0});
    maker.json["animations"][1]["name"] = "Run fast";
    maker.json["animations"][2]["name"] = "2";
    const auto skin = skinOf(maker);
    EXPECT_EQ(poseOf(*skin, "Run fast 0.5"), (Pose{1, 0.5f, {}}));
    EXPECT_EQ(poseOf(*skin, "1 0.5"), (Pose{0, 0.5f, {}}));
    EXPECT_EQ(poseOf(*skin, "2 0.5"), (Pose{2, 0.5f, {}}));  // a name goes before a number
    EXPECT_EQ(poseOf(*skin, " rest  morph 1 0 0.5"), (Pose{-1, 0.0f, {1.0f, 0.0f, 0.5f}}));
    EXPECT_EQ(refusal([&] { poseOf(*skin, "Walk 0"); }),
              "no clip \"Walk\"; there are \"clip 1\", \"Run fast\", \"2\"");
    EXPECT_EQ(refusal([&] { poseOf(*skin, "1 soon"); }), "\"soon\" is no number of seconds");
    EXPECT_EQ(refusal([&] { poseOf(*skin, "1"); }), "expected \"rest\", or a clip and its seconds");
    EXPECT_EQ(refusal([&] { poseOf(*skin, "rest morph 1"); }), "has 1 weights for 3 morph targets");
    const auto still = skinOf(GltfMaker::triangle());
    EXPECT_EQ(refusal([&] { poseOf(*still, "1 0"); }), "nothing of this animal can move");
    EXPECT_EQ(poseOf(*still, "rest"), Pose{});
}

TEST(PoseScript, APoseIsNoStepOfHistory) {
    Workspace workspace;
    workspace.open(documentOf(test::bendingSheet(6)));
    runLine(workspace, "pose bend 0.5");
    EXPECT_EQ(workspace.pose, (Pose{0, 0.5f, {}}));
    EXPECT_EQ(workspace.editor->stepCount(), 1u);
    EXPECT_TRUE(workspace.editor->saved());
    runLine(workspace, "flood length set 0.2");
    runLine(workspace, "undo");
    EXPECT_EQ(workspace.pose, (Pose{0, 0.5f, {}}));
    runLine(workspace, "pose rest");
    EXPECT_EQ(workspace.shown(), workspace.editor->document().skin);
    runLine(workspace, "pose 1 1");
    workspace.open(documentOf(test::bendingSheet(6)));
    EXPECT_TRUE(workspace.pose.atRest());
    EXPECT_FALSE(workspace.posed);
}

TEST(PoseScript, AnotherSkinStandsAsTheOneBefore) {
    Workspace workspace;
    workspace.open(documentOf(test::bendingSheet(6)));
    const Document finer = documentOf(test::bendingSheet(12));
    runLine(workspace, "pose bend 1");
    workspace.editor->edit([&](Document& document) { document = finer; });
    workspace.follow();
    EXPECT_TRUE(
        sameBits(workspace.shown()->vertices, posedSkin(finer.skin, {0, 1.0f, {}})->vertices));
    EXPECT_EQ(&workspace.query->skin(), workspace.shown().get());
    workspace.editor->edit(
        [](Document& document) { document = documentOf(GltfMaker::triangle()); });
    workspace.follow();
    EXPECT_TRUE(workspace.pose.atRest());
    EXPECT_EQ(&workspace.query->skin(), workspace.editor->document().skin.get());
}

TEST(PoseScript, AStrokeOnAPoseEditsWhatItCoversThere) {
    const GltfMaker maker = test::bendingSheet(20);
    Workspace hand;
    hand.open(documentOf(maker));
    const Groom before = hand.editor->document().groom;
    hand.stand({0, 1.0f, {}});
    // The far half stands upright: this place is empty at rest.
    const vec3 place(0.0f, 0.35f, 0.0f), normal(-1.0f, 0.0f, 0.0f);
    const Brush brush{.tool = Tool::length,
                      .mode = Mode::set,
                      .falloff = Falloff::constant,
                      .radius = 0.1f,
                      .strength = 1.0f,
                      .value = 0.5f};
    hand.press(brush, place, normal);
    const std::string line = hand.release();
    ASSERT_FALSE(line.empty());

    const Groom& after = hand.editor->document().groom;
    const Skin& rest = *hand.editor->document().skin;
    std::size_t changed = 0;
    for (uint v = 0; v < rest.vertices.size(); ++v) {
        const vec3 p = rest.vertices[v].position;
        const bool covered = glm::distance(vec3(p.x, 0.0f, p.z), vec3(0.35f, 0.0f, 0.0f)) < 0.1f;
        if (covered) {
            EXPECT_NEAR(after.fur[v].furLength, 0.5f, 1e-6f);
            ++changed;
        } else {
            EXPECT_TRUE(after.fur[v] == before.fur[v]);
        }
    }
    EXPECT_GT(changed, 5u);

    Workspace script;
    script.open(documentOf(maker));
    runLine(script, poseLine(hand.pose));
    runLine(script, line);
    EXPECT_TRUE(sameBits(script.editor->document().groom, after));
    EXPECT_EQ(script.editor->stepCount(), 2u);
    runLine(script, "undo");
    EXPECT_TRUE(sameBits(script.editor->document().groom, before));
    // Without the pose the stroke meets nothing.
    Workspace resting;
    resting.open(documentOf(maker));
    runLine(resting, line);
    EXPECT_TRUE(sameBits(resting.editor->document().groom, before));
}

TEST(PoseScript, CombingOnAPoseIsKeptInMeshSpace) {
    Workspace workspace;
    workspace.open(documentOf(test::bendingSheet(20)));
    runLine(workspace, "pose bend 1");
    runLine(workspace, "flood comb direction 0 1 0");
    const Document& document = workspace.editor->document();
    for (uint v = 0; v < document.skin->vertices.size(); ++v) {
        if (document.skin->vertices[v].position.x < 0.15f) continue;
        // Up on the raised half is away from the joint, which at rest is along x.
        const vec3 direction = document.groom.fur[v].direction;
        EXPECT_TRUE(near(glm::normalize(direction), vec3(1.0f, 0.0f, 0.0f)));
    }
}

}  // namespace
}  // namespace pelage
