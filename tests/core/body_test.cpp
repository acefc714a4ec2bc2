// body_test.cpp -- body segments belong to the document: listed, painted, undone and saved.
#include "core/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bad_lines.h"
#include "canvas.h"
#include "core/animal.h"
#include "core/gltf_in.h"
#include "core/gltf_out.h"
#include "core/script.h"
#include "core/segment_text.h"
#include "gltf_maker.h"
#include "reading.h"

namespace pelage {
namespace {

using test::brushOf;
using test::Canvas;
using test::errorOf;
using test::refusal;

// A sheet whose left half is "a" and whose right half "b", and "c" that no skin belongs to.
Source halves() {
    Source source = test::sheet(20);
    source.segments = {
        {"a", {-1, 0, 0}, {0, 0, 0}}, {"b", {0, 0, 0}, {1, 0, 0}}, {"c", {0, 0, 0}, {0, 0, 1}}};
    for (const vec3 p : source.positions) source.segmentOf.push_back(p.x < 0.0f ? 0u : 1u);
    return source;
}

Brush segmentBrush(const std::string& name, Mode mode = Mode::add, float strength = 0.5f) {
    Brush brush = brushOf(Tool::segment, mode, 0.2f, strength);
    brush.segment = name;
    return brush;
}

bool sameBody(const Groom& a, const Groom& b) {
    if (!std::ranges::equal(a.body(), b.body())) return false;
    for (std::size_t v = 0; v < a.segmentOf.size(); ++v)
        if (a.segmentOf[v] != b.segmentOf[v]) return false;
    return true;
}

TEST(Body, SegmentsAreFoundByNameOrNumber) {
    const std::vector<Segment> body{{"back", {}, {}}, {"front", {}, {}}, {"front", {}, {}},
                                    {"7", {}, {}},    {"#0", {}, {}},    {"", {}, {}}};
    EXPECT_EQ(segmentNamed(body, "front"), 1u);
    EXPECT_EQ(segmentNamed(body, "#2"), 2u);
    EXPECT_EQ(segmentNamed(body, "2"), 2u);
    EXPECT_EQ(segmentNamed(body, "7"), 3u);
    for (uint s = 0; s < body.size(); ++s) EXPECT_EQ(segmentNamed(body, nameOfSegment(body, s)), s);
    EXPECT_EQ(refusal([&] { segmentNamed(body, "#6"); }),
              "no body segment \"#6\"; there are \"back\", \"front\", \"front\", \"7\", \"#0\", "
              "\"\"");
    EXPECT_EQ(refusal([&] { segmentNamed({}, "a"); }), "the mesh has no body segments");
}

TEST(Body, OfAGroomIsThatOfTheSourceUntilItIsChanged) {
    const auto skin = makeSkin(halves());
    const Groom first = initialGroom(*skin), again = initialGroom(*skin);
    EXPECT_EQ(first.segments, again.segments);  // the same list, not a copy
    for (uint v = 0; v < first.segmentOf.size(); ++v)
        EXPECT_EQ(first.segmentOf[v], skin->vertices[v].position.x < 0.0f ? 0u : 1u);
    Groom changed = first;
    moveSegment(changed, 1, {0, 0, 0}, {0, 2, 0});
    EXPECT_FALSE(changed == first);
    EXPECT_EQ(first.body()[1].tip, vec3(1, 0, 0));
}

TEST(Body, ARemovedSegmentLeavesItsSkinAndTheOthersKeepTheirs) {
    const auto skin = makeSkin(halves());
    Groom groom = initialGroom(*skin);
    removeSegment(groom, 0);
    ASSERT_EQ(groom.body().size(), 2u);
    for (uint v = 0; v < groom.segmentOf.size(); ++v)
        EXPECT_EQ(groom.segmentOf[v], skin->vertices[v].position.x < 0.0f ? kNoSegment : 0u);
}

TEST(SegmentPaint, GoesToWhereTheFalloffIsAHalfAtHalfStrength) {
    const Canvas canvas(halves());
    for (const Falloff falloff : {Falloff::smooth, Falloff::linear, Falloff::constant}) {
        for (const float strength : {0.25f, 0.5f, 1.0f}) {
            Brush brush = segmentBrush("c", Mode::add, strength);
            brush.falloff = falloff;
            const Groom after = canvas.painted(brush, {vec3(0.0f)});
            int painted = 0;
            for (uint v = 0; v < after.segmentOf.size(); ++v) {
                const float far = glm::length(canvas.skin->vertices[v].position);
                const float coverage = falloffWeight(falloff, far, 0.2f);
                const bool inside = coverage > 0.0f && coverage >= 1.0f - strength;
                painted += inside;
                ASSERT_EQ(after.segmentOf[v], inside ? 2u : canvas.groom.segmentOf[v]) << far;
                ASSERT_EQ(after.fur[v], canvas.groom.fur[v]);
            }
            EXPECT_GT(painted, 0);
        }
    }
}

TEST(SegmentPaint, IsHeldBackByTheMask) {
    Canvas canvas(halves());
    for (uint v = 0; v < canvas.groom.mask.size(); ++v)
        canvas.groom.mask.edit(v) = v % 3 == 0 ? 1.0f : v % 3 == 1 ? 0.5f : 0.25f;
    Groom after = canvas.groom;
    flood(canvas.query, after, segmentBrush("c", Mode::add, 1.0f));
    for (uint v = 0; v < after.segmentOf.size(); ++v)
        EXPECT_EQ(after.segmentOf[v], v % 3 == 2 ? 2u : canvas.groom.segmentOf[v]);
}

TEST(SegmentPaint, SubtractAndResetGiveBackTheSegmentsOfTheSource) {
    const Canvas canvas(halves());
    Groom painted = canvas.groom;
    flood(canvas.query, painted, segmentBrush("c", Mode::add, 1.0f));
    Groom back = painted;
    Stroke stroke(canvas.query, painted, segmentBrush("c", Mode::subtract));
    stroke.dab(back, vec3(0.0f), test::kUp);
    for (uint v = 0; v < back.segmentOf.size(); ++v) {
        const float far = glm::length(canvas.skin->vertices[v].position);
        const bool inside = falloffWeight(Falloff::smooth, far, 0.2f) >= 0.5f;
        EXPECT_EQ(back.segmentOf[v], inside ? canvas.groom.segmentOf[v] : 2u);
    }
    reset(*canvas.skin, back, Tool::segment);
    EXPECT_TRUE(sameBody(back, canvas.groom));
}

TEST(SegmentPaint, GivesBackByNameAndNoneWhereTheNameIsGone) {
    const Canvas canvas(halves());
    Groom groom = canvas.groom;
    removeSegment(groom, 0);
    addSegment(groom, {"d", {0, 0, 0}, {0, 1, 0}});
    flood(canvas.query, groom, segmentBrush("d", Mode::add, 1.0f));
    reset(*canvas.skin, groom, Tool::segment);
    for (uint v = 0; v < groom.segmentOf.size(); ++v)
        EXPECT_EQ(groom.segmentOf[v], canvas.groom.segmentOf[v] == 0 ? kNoSegment : 0u);
}

TEST(SegmentPaint, RefusesASegmentThatIsNotThere) {
    const Canvas canvas(halves());
    EXPECT_EQ(refusal([&] { canvas.painted(segmentBrush("wing"), {vec3(0.0f)}); }),
              "no body segment \"wing\"; there are \"a\", \"b\", \"c\"");
    const Groom bare = canvas.painted(segmentBrush(""), {vec3(0.0f)});
    int freed = 0;
    for (uint v = 0; v < bare.segmentOf.size(); ++v) freed += bare.segmentOf[v] == kNoSegment;
    EXPECT_GT(freed, 10);
}

Workspace onHalves() {
    Workspace workspace;
    workspace.open(test::evenDocument(halves()));
    return workspace;
}

TEST(BodyLines, EachIsOneStepThatUndoesAndRedoes) {
    Workspace workspace = onHalves();
    const Editor& editor = *workspace.editor;
    const std::pair<const char*, const char*> lines[] = {
        {"body add left%20ear root 0 1 0 tip 0.1 2 0.3", "Add segment left ear"},
        {"stroke segment left%20ear radius 0.2 : 0 0 0 0 1 0", "Segment stroke"},
        {"body move left%20ear root 0 1 0 tip 0.1 3 0.3", "Move axis of left ear"},
        {"body rename left%20ear ear", "Rename segment ear"},
        {"flood segment c", "Flood segment"},
        {"stroke segment # radius 0.2 : 0 0 0 0 1 0", "Segment stroke"},
        {"reset segment", "Reset segment"},
        {"body remove ear", "Remove segment ear"}};
    std::vector<Groom> after{editor.document().groom};
    for (const auto& [line, label] : lines) {
        runLine(workspace, line);
        EXPECT_EQ(editor.undoLabel(), label);
        EXPECT_FALSE(sameBody(editor.document().groom, after.back())) << line;
        after.push_back(editor.document().groom);
    }
    EXPECT_EQ(editor.currentStep(), std::size(lines));
    for (std::size_t step = after.size() - 1; step-- > 0;) {
        runLine(workspace, "undo");
        EXPECT_EQ(editor.document().groom, after[step]);
    }
    for (std::size_t step = 1; step < after.size(); ++step) runLine(workspace, "redo");
    EXPECT_EQ(editor.document().groom, after.back());
}

TEST(BodyLines, AreWrittenSoThatTheyReadBackBitForBit) {
    Workspace workspace = onHalves();
    const Segment ear{"left ear", {0.1f, 1.0f / 3.0f, -2e-8f}, {1e5f, 0.7f, 3.0f}};
    runLine(workspace, addSegmentLine(ear));
    const Groom& groom = workspace.editor->document().groom;
    EXPECT_EQ(groom.body()[3], ear);
    runLine(workspace, moveSegmentLine(groom, 3, ear.tip, ear.root));
    EXPECT_EQ(groom.body()[3], (Segment{"left ear", ear.tip, ear.root}));
    runLine(workspace, renameSegmentLine(groom, 3, "50 %"));
    EXPECT_EQ(groom.body()[3].name, "50 %");
    runLine(workspace, removeSegmentLine(groom, 3));
    EXPECT_EQ(groom.body().size(), 3u);
}

TEST(BodyLines, AStrokeByHandIsReplayed) {
    Workspace painted = onHalves(), replayed = onHalves();
    Brush brush = segmentBrush("c");
    brush.mirror.x = true;
    painted.press(brush, {0.3f, 0, 0}, test::kUp);
    painted.drag({0.3f, 0, 0.3f}, test::kUp);
    const std::string line = painted.release();
    EXPECT_TRUE(line.starts_with("stroke segment c strength 0.5 ")) << line;
    runLine(replayed, line);
    EXPECT_TRUE(sameBody(painted.editor->document().groom, replayed.editor->document().groom));
    runLine(painted, "undo");
    EXPECT_TRUE(sameBody(painted.editor->document().groom, onHalves().editor->document().groom));
}

TEST(BodyLines, SayWhatIsWrongAndChangeNothing) {
    Workspace workspace = onHalves();
    const Document before = workspace.editor->document();
    const std::pair<const char*, const char*> lines[] = {
        {"body", "body: does not know \"\"; there are add, move, rename, remove"},
        {"body add a root 0 0 0 tip 1 0 0", "body: there is a body segment \"a\" already"},
        {"body add d root 0 0 0 tip 0 0 0", "body: the axis of a body segment needs a length"},
        {"body add d tip 0 0 0", "body: expects root and not \"tip\""},
        {"body add d root 0 0", "body: root \"\" is no number from -1e+12 to 1e+12"},
        {"body move a root 0 0 0 tip 0 0 1 0", "body: does not expect \"0\" here"},
        {"body rename a", "body: a body segment needs a name"},
        {"body rename a b", "body: there is a body segment \"b\" already"},
        {"body remove d", "body: no body segment \"d\"; there are \"a\", \"b\", \"c\""},
        {"stroke segment radius 0.2 : 0 0 0 0 1 0", "stroke: the stroke says no radius"},
        {"flood segment", "flood: the brush names no body segment"},
        {"flood segment d", "flood: no body segment \"d\"; there are \"a\", \"b\", \"c\""}};
    for (const auto& [line, problem] : lines) EXPECT_EQ(errorOf(workspace, line), problem);
    EXPECT_EQ(workspace.editor->document(), before);
}

TEST(BodyLines, OnAMeshWithoutSegmentsAddTheFirst) {
    Workspace workspace;
    workspace.open(test::evenDocument(test::sheet(4)));
    runLine(workspace, "flood segment #");
    EXPECT_EQ(workspace.editor->currentStep(), 0u);
    runLine(workspace, "body add torso root 0 0 1 tip 0 0 -1");
    runLine(workspace, "flood segment torso");
    runLine(workspace, "segment torso");
    const Groom& groom = workspace.editor->document().groom;
    EXPECT_EQ(groom.segmentOf[7], 0u);
    EXPECT_NEAR(groom.fur[7].direction.z, -1.0f, 1e-6f);
}

// The document saved and opened again.
Document reopened(const Document& document) {
    return openDocument(readGltf(groomedGlb(document), "test.glb"));
}

nlohmann::json blockOf(const Document& document) {
    return nlohmann::json::parse(document.skin->source->furBlock);
}

TEST(SavedBody, ComesBackBitForBit) {
    for (const bool made : {true, false}) {
        Workspace workspace;
        // A source that was none, and a glTF that is moved and turned.
        Document document = test::evenDocument(halves());
        workspace.open(made ? document : reopened(document));
        for (const char* line :
             {"body add left%20ear root 0.1 0.2 0.3 tip 0.7 1e-7 3", "body remove b",
              "stroke segment left%20ear radius 0.3 : 0.2 0 0 0 1 0",
              "body move a root 0 0.1 0 tip 0.3 0.1 0"})
            runLine(workspace, line);
        const Document& saved = workspace.editor->document();
        const Document again = reopened(saved);
        EXPECT_TRUE(sameBody(again.groom, saved.groom));
        EXPECT_EQ(groomedGlb(again), groomedGlb(saved));
    }
}

TEST(SavedBody, IsNotWrittenWhereTheSkeletonSaysIt) {
    Document document = openDocument(readGltf(test::GltfMaker::skinned().glb(), "test.glb"));
    const Document plain = reopened(document);
    EXPECT_FALSE(blockOf(plain).contains("segments"));
    EXPECT_TRUE(sameBody(plain.groom, document.groom));
    document.groom.segmentOf.edit(0) = kNoSegment;
    const Document painted = reopened(document);
    EXPECT_EQ(blockOf(painted)["segments"].size(), 2u);
    EXPECT_TRUE(sameBody(painted.groom, document.groom));
    removeSegment(document.groom, 0);
    removeSegment(document.groom, 0);
    const Document empty = reopened(document);
    EXPECT_TRUE(empty.groom.body().empty());
}

// A triangle with a list of segments and their numbers at its vertices.
Source told(const nlohmann::json& segments, const std::vector<float>& numbers) {
    test::GltfMaker maker = test::GltfMaker::triangle();
    maker.primitive()["attributes"]["_FUR_SEGMENT"] = maker.add<float>(numbers, "SCALAR", 5126);
    maker.json["meshes"][0]["extras"]["fur"] = {{"version", 1}, {"segments", segments}};
    return readGltf(maker.glb(), "test.glb");
}

TEST(SavedBody, IsRefusedWhereItNamesWhatIsNotThere) {
    const nlohmann::json ear{{"name", "ear"}, {"root", {0, 1, 2}}, {"tip", {3, 4, 5}}};
    const Source source = told(nlohmann::json::array({ear}), {0, -1, 0});
    EXPECT_EQ(source.segments, (std::vector<Segment>{{"ear", {0, 1, 2}, {3, 4, 5}}}));
    EXPECT_EQ(source.segmentOf, (std::vector<uint>{0, kNoSegment, 0}));
    for (const float number : {1.0f, -2.0f, NAN, 1e30f})
        EXPECT_NE(refusal([&] {
                      told(nlohmann::json::array({ear}), {0, number, 0});
                  }).find("_FUR_SEGMENT names one of 1 segments that is not there"),
                  std::string::npos);
    const nlohmann::json blunt{{"name", "ear"}, {"root", {0, 1, 2}}};
    EXPECT_EQ(refusal([&] {
                  told(nlohmann::json::array({ear, blunt}), {0, 0, 0});
              }),
              "test.glb: meshes[0].extras.fur.segments[1]: has no root or no tip");
}

TEST(SavedBody, OfTheFoxIsThatOfItsJointsUntilItIsPainted) {
    const std::string path = test::sharedMesh("Fox.glb");
    if (path.empty()) GTEST_SKIP() << "Fox.glb is not there";
    Workspace workspace;
    workspace.open(openDocument(readSource(path)));
    EXPECT_FALSE(blockOf(reopened(workspace.editor->document())).contains("segments"));
    const uint first = 0;
    const Segment moved = workspace.editor->document().groom.body()[first];
    runLine(workspace,
            moveSegmentLine(workspace.editor->document().groom, first, moved.tip, moved.root));
    const Document again = reopened(workspace.editor->document());
    EXPECT_TRUE(sameBody(again.groom, workspace.editor->document().groom));
}

}  // namespace
}  // namespace pelage
