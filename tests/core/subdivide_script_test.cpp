// subdivide_script_test.cpp -- subdivision as a line of script and a step of history.
#include <gtest/gtest.h>

#include "core/gltf_out.h"
#include "core/script.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::refusal;

TEST(SubdivideScript, AStrokeInProgressEndsWithItsSkin) {
    Workspace workspace;
    workspace.open(test::evenDocument(test::ball(2)));
    runLine(workspace, "subdivide");
    workspace.press(Brush{}, vec3(0, 1, 0), vec3(0, 1, 0));
    workspace.undo();
    workspace.drag(vec3(0.1f, 1, 0), vec3(0, 1, 0));
    EXPECT_EQ(workspace.release(), "");
    EXPECT_EQ(workspace.editor->undoLabel(), "");
}

TEST(SubdivideScript, IsOneStepThatUndoTakesBackExactly) {
    Workspace workspace;
    workspace.open(test::evenDocument(test::ball(2)));
    runLine(workspace, "stroke length add radius 0.5 : 0 1 0 0 1 0");
    const Document before = workspace.editor->document();
    runLine(workspace, "subdivide 2");
    EXPECT_EQ(workspace.editor->stepCount(), 3u);
    const Document after = workspace.editor->document();
    EXPECT_EQ(after.skin->triangles.size(), 16 * before.skin->triangles.size());
    EXPECT_EQ(&workspace.query->skin(), after.skin.get());
    runLine(workspace, "undo");
    EXPECT_TRUE(workspace.editor->document() == before);
    EXPECT_EQ(&workspace.query->skin(), before.skin.get());
    runLine(workspace, "stroke length add radius 0.5 : 0 0 1 0 0 1");
    runLine(workspace, "undo");
    EXPECT_TRUE(workspace.undo());
    EXPECT_TRUE(workspace.redo());
    EXPECT_TRUE(workspace.editor->document() == before);
    EXPECT_FALSE(refusal([&] { runLine(workspace, "subdivide 0"); }) == "(not refused)");
    EXPECT_FALSE(refusal([&] { runLine(workspace, "subdivide 1.5"); }) == "(not refused)");
    EXPECT_TRUE(workspace.editor->document() == before);
}

TEST(SubdivideScript, LineIsReplayedBitForBit) {
    const auto run = [] {
        Workspace workspace;
        workspace.open(test::evenDocument(test::ball(2)));
        for (const char* line :
             {"stroke comb radius 0.5 : 0 1 0 0 1 0 0.1 1 0 0 1 0", "subdivide",
              "stroke length add radius 0.3 : 0 1 0 0 1 0", "undo", "undo", "redo", "subdivide",
              "stroke density subtract radius 0.3 : 1 0 0 1 0 0", "flood smooth strength 0.5"})
            runLine(workspace, line);
        return groomedGlb(workspace.editor->document());
    };
    EXPECT_EQ(run(), run());
}

TEST(SubdivideScript, HistoryOfAFineMeshSharesItsSkin) {
    Workspace workspace;
    workspace.open(test::evenDocument(test::ball(2)));
    runLine(workspace, "subdivide");
    const auto skin = workspace.editor->document().skin;
    const long held = skin.use_count();
    for (int i = 0; i < 20; ++i)
        runLine(workspace, "set over.stiffness 0." + std::to_string(i + 1));
    EXPECT_EQ(workspace.editor->document().skin, skin);
    EXPECT_GE(skin.use_count(), held + 10);
}

}  // namespace
}  // namespace pelage
