// editor_test.cpp -- the history restores exactly and never lies about what is saved.
#include "core/editor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/coat.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;

Editor smallEditor() { return Editor(test::evenDocument(test::sheet(20))); }

void paint(Editor& editor, uint vertex, float length) {
    editor.edit([&](Document& document) { document.groom.fur.edit(vertex).furLength = length; });
}

// All values of a document, by value: the slow way to hold a state.
struct Plain {
    std::vector<FurVertex> fur;
    std::vector<float> mask;
    Fur parameters;

    explicit Plain(const Document& document) : parameters(document.fur) {
        for (std::size_t v = 0; v < document.groom.fur.size(); ++v) {
            fur.push_back(document.groom.fur[v]);
            mask.push_back(document.groom.mask[v]);
        }
    }
    bool operator==(const Plain&) const = default;
};

TEST(Editor, UndoAndRedoWalkTheSteps) {
    Editor editor = smallEditor();
    EXPECT_FALSE(editor.undo());
    EXPECT_EQ(editor.undoLabel(), "");
    paint(editor, 3, 1.0f);
    EXPECT_TRUE(editor.commit("First"));
    paint(editor, 3, 2.0f);
    EXPECT_TRUE(editor.commit("Second"));
    EXPECT_EQ(editor.undoLabel(), "Second");
    EXPECT_TRUE(editor.undo());
    EXPECT_EQ(editor.document().groom.fur[3].furLength, 1.0f);
    EXPECT_EQ(editor.undoLabel(), "First");
    EXPECT_EQ(editor.redoLabel(), "Second");
    EXPECT_TRUE(editor.redo());
    EXPECT_EQ(editor.document().groom.fur[3].furLength, 2.0f);
    EXPECT_FALSE(editor.redo());
}

TEST(Editor, CommitOfNothingIsNothing) {
    Editor editor = smallEditor();
    EXPECT_FALSE(editor.commit("Nothing"));
    editor.edit([](Document&) {});
    EXPECT_FALSE(editor.commit("Nothing"));
    EXPECT_EQ(editor.stepCount(), 1u);
    paint(editor, 0, 1.0f);
    editor.commit("Something");
    editor.undo();
    EXPECT_FALSE(editor.commit("Nothing"));
    EXPECT_EQ(editor.redoLabel(), "Something");  // and what can be redone is not forgotten
}

TEST(Editor, CommitForgetsWhatCouldBeRedone) {
    Editor editor = smallEditor();
    paint(editor, 0, 1.0f);
    editor.commit("First");
    editor.undo();
    paint(editor, 1, 1.0f);
    editor.commit("Other");
    EXPECT_FALSE(editor.redo());
    EXPECT_EQ(editor.stepCount(), 2u);
    EXPECT_EQ(editor.stepLabel(1), "Other");
}

TEST(Editor, CancelAndUndoDropUncommittedEdits) {
    Editor editor = smallEditor();
    paint(editor, 0, 1.0f);
    editor.commit("First");
    const Document kept = editor.document();
    paint(editor, 0, 9.0f);
    editor.cancel();
    EXPECT_EQ(editor.document(), kept);
    paint(editor, 0, 9.0f);
    editor.undo();
    editor.redo();
    EXPECT_EQ(editor.document(), kept);
}

TEST(Editor, UndoRestoresExactly) {
    for (uint history = 0; history < 200; ++history) {
        Draws draws(history);
        Editor editor = smallEditor();
        std::vector<Plain> states{Plain(editor.document())};  // as a plain list would keep them
        std::size_t at = 0;
        for (int operation = 0; operation < 150; ++operation) {
            const uint kind = draws.below(10);
            if (kind < 5) {
                for (uint i = 0, count = draws.below(20); i < count; ++i) {
                    const uint v =
                        draws.below(static_cast<uint>(editor.document().groom.fur.size()));
                    editor.edit([&](Document& document) {
                        document.groom.fur.edit(v).density = draws.in(0.0f, 1.0f);
                        if (draws.below(3) == 0) document.groom.mask.edit(v) = draws.in(0.0f, 1.0f);
                    });
                }
                if (draws.below(4) == 0)
                    editor.edit([&](Document& d) { d.fur.over.stiffness = draws.in(0.0f, 1.0f); });
                if (draws.below(5) == 0) {
                    editor.cancel();
                } else if (editor.commit("Edit")) {
                    states.erase(states.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                                 states.end());
                    states.emplace_back(editor.document());
                    ++at;
                }
            } else if (kind < 8) {
                EXPECT_EQ(editor.undo(), at > 0);
                at -= at > 0;
            } else {
                EXPECT_EQ(editor.redo(), at + 1 < states.size());
                at += at + 1 < states.size();
            }
            ASSERT_TRUE(Plain(editor.document()) == states[at])
                << "history " << history << ", operation " << operation;
        }
    }
}

TEST(Editor, TwoHundredStepsCanBeUndone) {
    static_assert(Editor::kUndoSteps >= 200);
    Editor editor = smallEditor();
    for (uint i = 1; i <= 1000; ++i) {
        paint(editor, i % 400, static_cast<float>(i));
        editor.commit("Step " + std::to_string(i));
    }
    std::size_t undone = 0;
    while (editor.undo()) ++undone;
    EXPECT_EQ(undone, Editor::kUndoSteps);
    EXPECT_EQ(editor.stepCount(), Editor::kUndoSteps + 1);
    // What is oldest now is the state after step 1000 - 256.
    EXPECT_EQ(editor.document().groom.fur[(1000 - Editor::kUndoSteps) % 400].furLength,
              static_cast<float>(1000 - Editor::kUndoSteps));
}

TEST(Editor, SavedFollowsUndoAndRedo) {
    Editor editor = smallEditor();
    EXPECT_TRUE(editor.saved());
    paint(editor, 0, 1.0f);
    EXPECT_FALSE(editor.saved());
    editor.commit("First");
    EXPECT_FALSE(editor.saved());
    editor.markSaved();
    EXPECT_TRUE(editor.saved());
    editor.undo();
    EXPECT_FALSE(editor.saved());
    editor.redo();
    EXPECT_TRUE(editor.saved());
    paint(editor, 0, 2.0f);
    EXPECT_FALSE(editor.saved());
    editor.cancel();
    EXPECT_TRUE(editor.saved());
}

TEST(Editor, OverwrittenSavedStepIsNeverSavedAgain) {
    Editor editor = smallEditor();
    paint(editor, 0, 1.0f);
    editor.commit("Saved");
    editor.markSaved();
    editor.undo();
    paint(editor, 0, 2.0f);
    editor.commit("Other");
    EXPECT_FALSE(editor.saved());
    editor.undo();
    EXPECT_FALSE(editor.saved());
}

TEST(Editor, ForgottenSavedStepIsNeverSavedAgain) {
    Editor editor = smallEditor();  // saved as opened
    for (std::size_t i = 0; i <= Editor::kUndoSteps; ++i) {
        paint(editor, 0, static_cast<float>(i + 1));
        editor.commit("Step");
    }
    EXPECT_FALSE(editor.saved());
    while (editor.undo()) EXPECT_FALSE(editor.saved());
    EXPECT_FALSE(editor.saved());
}

TEST(Editor, HistorySharesWhatDidNotChange) {
    Editor editor = Editor(test::evenDocument(test::sheet(100)));
    const Document before = editor.document();
    paint(editor, 5000, 1.0f);
    editor.commit("One vertex");
    std::size_t shared = 0;
    const auto& fur = editor.document().groom.fur;
    for (std::size_t c = 0; c < fur.chunkCount(); ++c)
        shared += fur.sharesChunk(before.groom.fur, c);
    EXPECT_EQ(shared, fur.chunkCount() - 1);
    EXPECT_TRUE(editor.document().groom.mask == before.groom.mask);
}

}  // namespace
}  // namespace pelage
