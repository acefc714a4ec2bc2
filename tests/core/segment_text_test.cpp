// segment_text_test.cpp -- lines that comb along the body: one step each, and clear refusals.
#include "core/segment_text.h"

#include <gtest/gtest.h>

#include "bad_lines.h"
#include "core/animal.h"
#include "core/body.h"
#include "core/script.h"
#include "core/segment_comb.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::errorOf;
using test::refusal;

Workspace onAnimal() {
    Workspace workspace;
    workspace.open(groomedAnimal(2000));
    return workspace;
}

bool sameFur(const Groom& a, const Groom& b) {
    for (std::size_t v = 0; v < a.fur.size(); ++v)
        if (!(a.fur[v] == b.fur[v])) return false;
    return true;
}

TEST(SegmentText, EachLineIsOneStepThatUndoes) {
    Workspace workspace = onAnimal();
    const Editor& editor = *workspace.editor;
    const Groom before = editor.document().groom;
    runLine(workspace, "segment tail");
    EXPECT_EQ(editor.undoLabel(), "Comb tail");
    runLine(workspace, "comb head-to-tail weight 0.5");
    EXPECT_EQ(editor.undoLabel(), "Comb from head to tail");
    EXPECT_EQ(editor.currentStep(), 2u);
    EXPECT_FALSE(sameFur(editor.document().groom, before));
    runLine(workspace, "undo");
    runLine(workspace, "undo");
    EXPECT_EQ(editor.document().groom, before);
}

TEST(SegmentText, ALineDoesWhatTheFunctionDoes) {
    Workspace workspace = onAnimal();
    const Skin& skin = *workspace.editor->document().skin;
    Groom wanted = workspace.editor->document().groom;
    const uint tail = segmentNamed(wanted.body(), "tail");
    combSegment(skin, wanted, tail, {0.1f, 1.0f, 0.3f}, 0.25f);
    runLine(workspace, segmentLine(wanted, tail, {0.1f, 1.0f, 0.3f}, 0.25f));
    EXPECT_TRUE(sameFur(workspace.editor->document().groom, wanted));
    combSegment(skin, wanted, tail, axisOf(wanted.body()[tail]), 1.0f);
    runLine(workspace, "segment tail");
    EXPECT_TRUE(sameFur(workspace.editor->document().groom, wanted));
    combHeadToTail(skin, wanted, 0.75f);
    runLine(workspace, headToTailLine(0.75f));
    EXPECT_TRUE(sameFur(workspace.editor->document().groom, wanted));
}

TEST(SegmentText, ANameIsOneWordWhateverIsInIt) {
    Source source = test::sheet(2);
    source.segments = {{"left ear", {0, 0, 0}, {1, 0, 0}},
                       {"dot", {0, 0, 0}, {0, 0, 0}},
                       {"100 %\taxis", {0, 0, 0}, {0, 0, 1}},
                       {"left ear", {0, 0, 0}, {0, 0, 1}},
                       {"", {0, 0, 0}, {0, 0, 1}}};
    source.segmentOf.assign(source.positions.size(), 0);
    Workspace workspace;
    workspace.open(test::evenDocument(std::move(source)));
    const Document& document = workspace.editor->document();
    const char* words[] = {"left%20ear", "dot", "100%20%25%09axis", "#3", "#4"};
    for (uint s = 0; s < 5; ++s) {
        EXPECT_EQ(segmentWord(document.groom, s), words[s]);
        EXPECT_EQ(segmentNamed(document.groom.body(), textOfWord(words[s])), s);
    }
    runLine(workspace, "segment left%20ear weight 1");
    EXPECT_NEAR(document.groom.fur[0].direction.x, 1.0f, 1e-6f);
    runLine(workspace, "region segment left%20ear : length set 0.5");
    EXPECT_EQ(document.groom.fur[0].furLength, 0.5f);
    EXPECT_EQ(errorOf(workspace, "segment dot"),
              "segment: body segment \"dot\" has no axis of its own; name one");
}

TEST(SegmentText, SaysWhatIsWrong) {
    Workspace workspace = onAnimal();
    EXPECT_EQ(errorOf(workspace, "segment tail weight 2"),
              "segment: weight \"2\" is no number from 0 to 1");
    EXPECT_EQ(errorOf(workspace, "segment tail axis 0 0 0"), "segment: an axis needs a length");
    EXPECT_EQ(errorOf(workspace, "segment tail axis 0 0"),
              "segment: axis \"\" is no number from -1e+12 to 1e+12");
    EXPECT_EQ(errorOf(workspace, "segment tail axis 0 0 1 up"),
              "segment: does not expect \"up\" here");
    EXPECT_TRUE(
        errorOf(workspace, "segment wing")
            .starts_with("segment: no body segment \"wing\"; there are \"head\", \"muzzle\""));
    EXPECT_EQ(errorOf(workspace, "comb tail"),
              "comb: does not know \"tail\"; there is head-to-tail");
    EXPECT_EQ(errorOf(workspace, "comb head-to-tail 0.5"), "comb: does not expect \"0.5\" here");
    workspace.open(test::evenDocument(test::sheet(2)));
    EXPECT_EQ(errorOf(workspace, "comb head-to-tail"),
              "comb: the mesh has no body segments to comb along");
    EXPECT_EQ(errorOf(workspace, "segment tail"), "segment: the mesh has no body segments");
}

}  // namespace
}  // namespace pelage
