// script_test.cpp -- lines mean what they say, come back bit for bit, and name what is wrong.
#include "core/script.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "bad_lines.h"
#include "core/coat.h"
#include "core/text.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;
using test::errorOf;
using test::refusal;
using test::TempFolder;

Workspace onBall() {
    Workspace workspace;
    workspace.open(test::evenDocument(test::ball(4)));
    return workspace;
}

bool sameBits(const Document& a, const Document& b) {
    return test::sameBits(a.groom, b.groom) && a.fur == b.fur;
}

Brush randomBrush(Draws& draws) {
    Brush brush;
    brush.tool = static_cast<Tool>(draws.below(kToolCount));
    brush.mode = static_cast<Mode>(draws.below(4));
    brush.falloff = static_cast<Falloff>(draws.below(4));
    brush.radius = draws.in(0.05f, 0.8f);
    brush.strength = draws.in(0.0f, 1.0f);
    brush.value = draws.in(0.0f, 1.0f);
    brush.color = 0.5f + draws.inBox(0.5f);
    brush.mirror = {draws.below(2), draws.below(2), draws.below(2)};
    brush.factor = draws.in(0.0f, 3.0f);
    brush.alongSurface = draws.below(3) > 0;
    brush.facingOnly = draws.below(3) > 0;
    return brush;
}

// A stroke by hand over the ball; its line.
std::string strokeByHand(Workspace& workspace, Draws& draws) {
    auto place = [&] { return glm::normalize(draws.inBox(1.0f) + vec3(0.0f, 0.01f, 0.0f)); };
    vec3 at = place();
    const bool pen = draws.below(2);
    workspace.press(randomBrush(draws), at, at, pen ? draws.in(0.0f, 1.0f) : 1.0f);
    for (uint i = 0, moves = draws.below(8); i < moves; ++i) {
        at = glm::normalize(at + 0.3f * draws.inBox(1.0f));
        workspace.drag(at, at, pen ? draws.in(0.0f, 1.0f) : 1.0f);
    }
    return workspace.release();
}

TEST(Script, LineReplaysBitForBit) {
    Draws draws(31);
    Workspace painted = onBall(), replayed = onBall();
    std::size_t lines = 0;
    for (int i = 0; i < 100; ++i) {
        const std::string line = strokeByHand(painted, draws);
        if (line.empty()) continue;
        runLine(replayed, line);
        ASSERT_TRUE(sameBits(painted.editor->document(), replayed.editor->document())) << line;
        ++lines;
    }
    EXPECT_GT(lines, 60u);
    EXPECT_EQ(painted.editor->stepCount(), lines + 1);
    EXPECT_EQ(replayed.editor->stepCount(), lines + 1);
}

TEST(Script, EachLineIsOneStepWithALabel) {
    Workspace workspace = onBall();
    const std::vector<std::pair<std::string, std::string>> lines{
        {"stroke comb radius 0.3 strength 0.5 : 1 0 0 1 0 0  0.9 0.3 0 0.9 0.3 0", "Comb stroke"},
        {"stroke length set 0.1 radius 0.3 : 1 0 0 1 0 0", "Length stroke"},
        {"flood density subtract strength 0.25", "Flood density"},
        {"flood mask set 1", "Flood mask"},
        {"flood mask set 0", "Flood mask"},
        {"flood comb direction 0 -1 0", "Flood comb"},
        {"set over.stiffness 0.3125", "Set over.stiffness"},
        {"set fur.hairs 1234 under.stiffness 0.75", "Set fur.hairs, under.stiffness"}};
    std::size_t steps = 1;
    for (const auto& [line, label] : lines) {
        runLine(workspace, line);
        EXPECT_EQ(workspace.editor->stepCount(), ++steps) << line;
        EXPECT_EQ(workspace.editor->undoLabel(), label);
    }
    EXPECT_EQ(workspace.editor->document().fur.over.stiffness, 0.3125f);
    EXPECT_EQ(workspace.editor->document().fur.under.stiffness, 0.75f);
    EXPECT_EQ(workspace.editor->document().fur.hairs, 1234u);
    EXPECT_EQ(workspace.editor->document().groom.fur[0].density, 0.25f);
}

TEST(Script, BlankLinesAndRemarksDoNothing) {
    Workspace workspace;
    for (const char* line : {"", "   ", "\t\r", "# open nothing", "  # remark"})
        runLine(workspace, line);
    EXPECT_FALSE(workspace.editor);
}

TEST(Script, UndoAndRedoAtTheEndOfTheHistoryDoNothing) {
    Workspace workspace = onBall();
    runLine(workspace, "undo");
    runLine(workspace, "redo");
    runLine(workspace, "flood density set 0.125");
    runLine(workspace, "undo");
    EXPECT_EQ(workspace.editor->document().groom.fur[0].density, 0.5f);
    runLine(workspace, "redo");
    runLine(workspace, "redo");
    EXPECT_EQ(workspace.editor->document().groom.fur[0].density, 0.125f);
}

TEST(Script, WordsAfterTheToolMayComeInAnyOrder) {
    Workspace one = onBall(), other = onBall();
    runLine(one, "stroke length add radius 0.3 strength 0.75 falloff sharp mirror : 1 0 0 1 0 0");
    runLine(other, "stroke length mirror falloff sharp strength 0.75 radius 0.3 : 1 0 0 1 0 0\r");
    EXPECT_TRUE(sameBits(one.editor->document(), other.editor->document()));
    EXPECT_EQ(one.editor->stepCount(), 2u);
}

TEST(Script, MirrorAloneIsInX) {
    const std::string points = " : 0.7 0.5 0.5 0.7 0.5 0.5";
    const std::pair<const char*, const char*> same[] = {
        {"mirror", "mirror x"},
        {"mirror zy", "mirror yz"},
        {"mirror xyz straight", "straight mirror zyx"}};
    for (const auto& [first, second] : same) {
        Workspace one = onBall(), other = onBall(), none = onBall();
        runLine(one, std::string("stroke mask radius 0.3 ") + first + points);
        runLine(other, std::string("stroke mask radius 0.3 ") + second + points);
        runLine(none, "stroke mask radius 0.3" + points);
        EXPECT_TRUE(sameBits(one.editor->document(), other.editor->document())) << first;
        EXPECT_FALSE(sameBits(one.editor->document(), none.editor->document())) << first;
    }
}

TEST(Script, PressureIsASeventhNumberOfEachPoint) {
    Workspace full = onBall(), pressed = onBall(), light = onBall();
    runLine(full, "stroke density set 1 radius 0.3 strength 1 : 1 0 0 1 0 0  0 0 1 0 0 1");
    runLine(pressed,
            "stroke density set 1 radius 0.3 strength 1 pressure : 1 0 0 1 0 0 1  0 0 1 0 0 1 1");
    runLine(light,
            "stroke density set 1 radius 0.3 strength 1 pressure : 1 0 0 1 0 0 .5  0 0 1 0 0 1 .5");
    EXPECT_TRUE(sameBits(full.editor->document(), pressed.editor->document()));
    const auto &first = full.editor->document().groom, &second = light.editor->document().groom;
    for (std::size_t v = 0; v < first.fur.size(); ++v)
        EXPECT_NEAR(second.fur[v].density - 0.5f, 0.5f * (first.fur[v].density - 0.5f), 1e-6f);
}

TEST(Script, ErrorNamesTheOffendingWordAndChangesNothing) {
    Workspace workspace = onBall();
    runLine(workspace, "flood density set 0.75");
    const Document before = workspace.editor->document();
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"paint it", "paint"},
        {"stroke braid radius 1 : 0 0 0 0 0 0", "braid"},
        {"stroke", "no tool"},
        {"stroke comb radius x : 0 0 0 0 1 0", "\"x\""},
        {"stroke comb radius 0 : 0 0 0 0 1 0", "\"0\""},
        {"stroke comb radius -1 : 0 0 0 0 1 0", "\"-1\""},
        {"stroke comb radius nan : 0 0 0 0 1 0", "nan"},
        {"stroke comb radius 0.1 strength 1.5 : 0 0 0 0 1 0", "1.5"},
        {"stroke comb strength 1 : 0 0 0 0 1 0", "radius"},
        {"stroke comb radius 0.1 falloff bumpy : 0 0 0 0 1 0", "bumpy"},
        {"stroke comb radius 0.1 sideways : 0 0 0 0 1 0", "sideways"},
        {"stroke comb radius 0.1", "points"},
        {"stroke comb radius 0.1 : 0 0 0 0 1", "\"\""},
        {"stroke comb radius 0.1 : 0 0 0", "normal"},
        {"stroke comb radius 0.1 : 1 0 0 1 0 0 0 zero 0 0 0 1", "zero"},
        {"stroke density set 2 radius 0.1 : 1 0 0 1 0 0", "\"2\""},
        {"stroke comb scale 0.5 radius 0.1 : 1 0 0 1 0 0", "does not scale"},
        {"stroke length scale 11 radius 0.1 : 1 0 0 1 0 0", "\"11\""},
        {"stroke comb radius 0.1 mirror xw : 1 0 0 1 0 0", "xw"},
        {"stroke comb radius 0.1 pressure : 1 0 0 1 0 0", "pressure"},
        {"stroke comb radius 0.1 pressure : 1 0 0 1 0 0 2", "\"2\""},
        {"stroke comb radius 0.1 pressure straight : 1 0 0 1 0 0 1", "straight"},
        {"flood comb", "direction"},
        {"flood part", "part goes by the path"},
        {"flood clump subtract", "clump goes by the path"},
        {"flood cut", "cut needs set"},
        {"flood tint color 1 0", "\"\""},
        {"flood tint color 1 2 0", "\"2\""},
        {"flood length color 1 1 1", "color"},
        {"reset", "no tool"},
        {"reset hat", "hat"},
        {"reset length now", "now"},
        {"flood comb direction 0 1", "\"\""},
        {"flood length radius 1", "radius"},
        {"flood length direction 1 0 0 more", "more"},
        {"set over.fluff 0.3", "over.fluff"},
        {"set over.stiffness", "over.stiffness"},
        {"set over.stiffness 3", "over.stiffness"},
        {"set over.stiffness 0.5 over.fluff 1", "over.fluff"},
        {"set", "set"},
        {"preset no such animal", "no such animal"},
        {"animal 5", "\"5\""},
        {"undo twice", "twice"},
        {"open", "file"},
        {"open /nonexistent/fox.glb", "fox.glb"},
        {"save", "file"},
        {"save /nonexistent/folder/fox.glb", "folder"}};
    for (const auto& [line, word] : wrong) {
        const std::string error = errorOf(workspace, line);
        EXPECT_NE(error.find(word), std::string::npos) << line << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
        EXPECT_EQ(workspace.editor->document(), before) << line;
        EXPECT_EQ(workspace.editor->stepCount(), 2u) << line;
    }
}

TEST(Script, LinesNeedADocument) {
    Workspace workspace;
    for (const char* line : {"undo", "set over.stiffness 0.5", "flood mask set 0", "save x.glb",
                             "stroke comb radius 1 : 0 0 0 0 1 0"})
        EXPECT_NE(errorOf(workspace, line).find("nothing is open"), std::string::npos) << line;
}

TEST(Script, LongNoiseIsCutInMessages) {
    Workspace workspace;
    const std::string error = errorOf(workspace, std::string(100000, 'x'));
    EXPECT_NE(error.find("xxx"), std::string::npos) << error;
    EXPECT_LT(error.size(), 200u);
}

TEST(Script, LineDropsUncommittedEditsFirst) {
    Workspace workspace = onBall();
    workspace.press(Brush{}, {1, 0, 0}, {1, 0, 0});
    workspace.drag({0.9f, 0.3f, 0}, {1, 0, 0});
    runLine(workspace, "set over.stiffness 0.3125");
    EXPECT_FALSE(workspace.stroke);
    EXPECT_EQ(workspace.release(), "");
    runLine(workspace,
            "set over.stiffness " + floatText(onBall().editor->document().fur.over.stiffness));
    EXPECT_TRUE(sameBits(workspace.editor->document(), onBall().editor->document()));
    EXPECT_EQ(workspace.editor->stepCount(), 3u);
}

TEST(Script, CancelledStrokeLeavesNothing) {
    Workspace workspace = onBall();
    const Document before = workspace.editor->document();
    Brush brush;
    brush.tool = Tool::length;
    brush.radius = 0.4f;
    workspace.press(brush, {1, 0, 0}, {1, 0, 0});
    EXPECT_FALSE(workspace.editor->document() == before);
    workspace.cancelStroke();
    EXPECT_EQ(workspace.editor->document(), before);
    EXPECT_EQ(workspace.editor->stepCount(), 1u);
}

TEST(Script, StrokeThatChangesNothingIsNoStep) {
    Workspace workspace = onBall();
    workspace.press(Brush{}, {50, 0, 0}, {1, 0, 0});
    EXPECT_EQ(workspace.release(), "");
    EXPECT_EQ(workspace.editor->stepCount(), 1u);
}

TEST(Script, SetLineMakesAfterOfBefore) {
    Draws draws(33);
    Workspace workspace = onBall();
    for (int i = 0; i < 300; ++i) {
        const Fur before = workspace.editor->document().fur;
        Fur after = before;
        for (uint k = 0, edits = draws.below(4); k < edits; ++k) {
            Coat& coat = draws.below(2) ? after.over : after.under;
            const auto rows = coatParameters();
            const Parameter& row = rows[draws.below(static_cast<uint>(rows.size()))];
            setParameter(coat, row,
                         {draws.in(row.least, row.greatest), draws.in(row.least, row.greatest),
                          draws.in(row.least, row.greatest)});
        }
        if (draws.below(3) == 0) after.seed = draws.below(~0u);
        if (draws.below(3) == 0) after.hairs = draws.below(5000000);
        if (draws.below(3) == 0) {
            for (const Parameter& row : furParameters())
                if (row.kind == ParameterKind::direction)
                    setParameter(after, row, draws.inBox(1.0f) + vec3(0, 2, 0));
        }
        const std::string line = setLine(before, after);
        EXPECT_EQ(line.empty(), before == after);
        runLine(workspace, line);
        ASSERT_TRUE(workspace.editor->document().fur == after) << line;
    }
}

TEST(Script, FloodLineFloods) {
    Workspace workspace = onBall();
    Brush brush;
    brush.tool = Tool::comb;
    brush.mode = Mode::subtract;
    brush.strength = 0.3f;
    Groom wanted = workspace.editor->document().groom;
    flood(*workspace.query, wanted, brush, {0.1f, -0.7f, 0.2f});
    runLine(workspace, floodLine(brush, {0.1f, -0.7f, 0.2f}));
    for (std::size_t v = 0; v < wanted.fur.size(); ++v)
        EXPECT_EQ(workspace.editor->document().groom.fur[v], wanted.fur[v]);
}

TEST(Script, FloodOfEachToolThatNeedsNoPathChangesTheField) {
    for (const ToolInfo& info : tools()) {
        // The field is even, and there are no segments.
        if (info.needsPath || info.tool == Tool::smooth || info.tool == Tool::segment) continue;
        Workspace workspace = onBall();
        Brush brush;
        brush.tool = info.tool;
        brush.mode = info.tool == Tool::cut ? Mode::set : Mode::add;
        brush.value = 0.01f;
        brush.color = vec3(0.5f, 0.25f, 0.125f);
        Groom wanted = workspace.editor->document().groom;
        flood(*workspace.query, wanted, brush, {0.1f, -0.7f, 0.2f});
        runLine(workspace, floodLine(brush, {0.1f, -0.7f, 0.2f}));
        const Groom& after = workspace.editor->document().groom;
        EXPECT_EQ(workspace.editor->stepCount(), 2u) << info.name;
        for (std::size_t v = 0; v < wanted.fur.size(); ++v) {
            ASSERT_EQ(after.fur[v], wanted.fur[v]) << info.name;
            ASSERT_EQ(after.mask[v], wanted.mask[v]) << info.name;
        }
    }
}

TEST(Script, ResetBringsBackTheChannelsOfTheToolAndNoOthers) {
    const std::map<Tool, std::string> channels{
        {Tool::length, "l"},  {Tool::cut, "l"},       {Tool::density, "d"}, {Tool::comb, "v"},
        {Tool::part, "v"},    {Tool::twist, "v"},     {Tool::clump, "v"},   {Tool::puff, "v"},
        {Tool::flatten, "v"}, {Tool::smooth, "ldvt"}, {Tool::tint, "t"},    {Tool::mask, "m"},
        {Tool::segment, ""}};
    for (const ToolInfo& info : tools()) {
        Workspace workspace = onBall();
        for (const char* line : {"flood length set 0.5", "flood density set 0.25", "flood puff",
                                 "flood tint color 0.5 0.25 0", "flood mask set 0.5"})
            runLine(workspace, line);
        const Groom before = workspace.editor->document().groom;
        runLine(workspace, std::string("reset ") + info.name);
        const Groom& after = workspace.editor->document().groom;
        const Groom first = initialGroom(*workspace.editor->document().skin);
        for (const std::size_t v : {std::size_t{0}, std::size_t{700}}) {
            const auto has = [&](char channel) {
                return channels.at(info.tool).find(channel) != std::string::npos;
            };
            const FurVertex &is = after.fur[v], &was = before.fur[v], &goal = first.fur[v];
            // Half masked.
            EXPECT_FLOAT_EQ(is.furLength,
                            has('l') ? 0.5f * (was.furLength + goal.furLength) : was.furLength);
            EXPECT_FLOAT_EQ(is.density,
                            has('d') ? 0.5f * (was.density + goal.density) : was.density);
            EXPECT_LT(glm::distance(is.direction, has('v') ? 0.5f * (was.direction + goal.direction)
                                                           : was.direction),
                      1e-6f)
                << info.name;
            EXPECT_LT(glm::distance(is.tint, has('t') ? 0.5f * (was.tint + vec3(1.0f)) : was.tint),
                      1e-6f)
                << info.name;
            EXPECT_EQ(after.mask[v], has('m') ? 0.0f : 0.5f);
        }
    }
}

TEST(ScriptFile, ErrorSaysFileAndLine) {
    const TempFolder folder;
    Workspace workspace = onBall();
    const std::string path =
        folder.write("script.txt", "flood density set 0.25\n\n# fine so far\nflood fluff\nundo\n");
    const std::string error = refusal([&] { runScript(workspace, path); });
    EXPECT_TRUE(error.starts_with(path + ": line 4: ")) << error;
    EXPECT_EQ(workspace.editor->document().groom.fur[0].density, 0.25f);
}

TEST(ScriptFile, LastLineNeedsNoNewlineInAScriptButInAJournal) {
    const TempFolder folder;
    const std::string path =
        folder.write("script.txt", "flood density set 0.25\nflood density set 0.125");
    Workspace script = onBall(), journal = onBall();
    runScript(script, path);
    EXPECT_EQ(script.editor->document().groom.fur[0].density, 0.125f);
    replayJournal(journal, path);
    EXPECT_EQ(journal.editor->document().groom.fur[0].density, 0.25f);
}

TEST(ScriptFile, ReplayReturnsTheLinesThatWereRun) {
    const TempFolder folder;
    const std::string lines = "flood density set 0.25\n\nflood density set 0.5\n";
    Workspace workspace = onBall();
    EXPECT_EQ(replayJournal(workspace, folder.write("torn.txt", lines + "flood density se")),
              lines);
    EXPECT_EQ(replayJournal(workspace, folder.write("torn.txt", "flood")), "");
}

TEST(ScriptFile, TornJournalReplaysItsCompleteLinesWhereverItIsCut) {
    const TempFolder folder;
    Draws draws(34);
    Workspace painted = onBall();
    std::vector<std::string> lines;
    while (lines.size() < 6)
        if (std::string line = strokeByHand(painted, draws); !line.empty())
            lines.push_back(line + '\n');
    std::string text;
    for (const std::string& line : lines) text += line;
    for (int i = 0; i < 60; ++i) {
        const std::size_t cut = draws.below(static_cast<uint>(text.size() + 1));
        std::size_t complete = 0, length = 0;
        while (complete < lines.size() && length + lines[complete].size() <= cut)
            length += lines[complete++].size();
        Workspace replayed = onBall();
        replayJournal(replayed, folder.write("torn.txt", text.substr(0, cut)));
        EXPECT_EQ(replayed.editor->stepCount(), complete + 1);
    }
}

TEST(ScriptFile, SaveRefusesANameThatDoesNotEndInGlb) {
    const TempFolder folder;
    Workspace workspace = onBall();
    const std::string error = errorOf(workspace, "save " + folder.path("x.obj"));
    EXPECT_NE(error.find("does not end in .glb"), std::string::npos) << error;
    EXPECT_EQ(folder.fileCount(), 0u);
    runLine(workspace, "save " + folder.path("x.GLB"));
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(ScriptFile, MissingFileIsSaid) {
    const TempFolder folder;
    Workspace workspace;
    const std::string path = folder.path("none.txt");
    EXPECT_TRUE(refusal([&] { runScript(workspace, path); }).starts_with(path + ": "));
}

}  // namespace
}  // namespace pelage
