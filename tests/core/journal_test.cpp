// journal_test.cpp -- what was appended survives the end of its editor, however it ends.
#include "core/journal.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

class JournalTest : public testing::Test {
protected:
    static std::string contentOf(const std::string& path) {
        std::stringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    // A journal whose editor is gone.
    void leaveBehind(const std::string& name, const std::string& content) const {
        temporary_.write(name, content);
    }

    const test::TempFolder temporary_;
    const std::string folder_ = temporary_.path();
};

TEST_F(JournalTest, MakesItsFolderAndKeepsEachLine) {
    Journal journal(folder_ + "/a/b");
    journal.append("open fox.glb");
    journal.append("undo");
    EXPECT_EQ(contentOf(journal.path()), "open fox.glb\nundo\n");
}

TEST_F(JournalTest, RestartBeginsAnew) {
    Journal journal(folder_);
    journal.append("open fox.glb");
    journal.append("undo");
    journal.restart({"open cat.glb"});
    journal.append("redo");
    EXPECT_EQ(contentOf(journal.path()), "open cat.glb\nredo\n");
}

TEST_F(JournalTest, AFailedRestartKeepsTheOldLinesAndTheLock) {
    Journal journal(folder_);
    journal.append("open fox.glb");
    journal.append("undo");
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, before.rlim_max};  // as a full disk
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(journal.restart({"open " + std::string(10000, 'x')}), std::runtime_error);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, handler);
    journal.append("redo");
    EXPECT_EQ(contentOf(journal.path()), "open fox.glb\nundo\nredo\n");
    EXPECT_EQ(temporary_.fileCount(), 1u);
    EXPECT_TRUE(lostWork(folder_).empty());
}

TEST_F(JournalTest, ARestartedJournalIsStillLocked) {
    Journal journal(folder_);
    journal.append("open fox.glb");
    journal.restart({"open cat.glb"});
    journal.append("undo");
    EXPECT_TRUE(lostWork(folder_).empty());
    const Journal other(folder_);  // sweeps
    EXPECT_TRUE(fs::exists(journal.path()));
}

TEST_F(JournalTest, GoodOrderLeavesNothingBehind) {
    {
        Journal journal(folder_);
        journal.append("open fox.glb");
        journal.append("undo");
    }
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(JournalTest, RefusesALineThatIsTwo) {
    Journal journal(folder_);
    journal.append("open fox.glb");
    EXPECT_THROW(journal.append("open a\nb.glb"), std::runtime_error);
    EXPECT_THROW(journal.restart({"open a\nb.glb"}), std::runtime_error);
    EXPECT_EQ(contentOf(journal.path()), "open fox.glb\n");
}

TEST_F(JournalTest, FolderThatCannotBeMadeIsSaid) {
    leaveBehind("file", "");
    EXPECT_THROW(Journal(folder_ + "/file/in"), std::runtime_error);
}

TEST_F(JournalTest, LiveEditorsAreNotLost) {
    Journal mine(folder_), other(folder_);
    mine.append("open fox.glb");
    mine.append("undo");
    EXPECT_NE(mine.path(), other.path());
    EXPECT_TRUE(lostWork(folder_).empty());
}

TEST_F(JournalTest, LostWorkNamesItsDocumentAndCountsCompleteEdits) {
    leaveBehind("b.journal", "open /home/a b/fox.glb\nundo\nredo\nstroke comb radius");
    leaveBehind("a.journal", "animal 100000\nundo\n");
    leaveBehind("none.journal", "open /home/cat.glb\n");
    leaveBehind("notes.txt", "open x\nundo\n");
    const std::vector<LostWork> lost = lostWork(folder_);
    ASSERT_EQ(lost.size(), 2u);
    EXPECT_EQ(lost[0].document, "animal");
    EXPECT_EQ(lost[0].edits, 1u);
    EXPECT_EQ(lost[1].document, "/home/a b/fox.glb");
    EXPECT_EQ(lost[1].edits, 2u);
    discardLostWork(lost[1]);
    EXPECT_EQ(lostWork(folder_).size(), 1u);
    EXPECT_TRUE(lostWork(folder_ + "/nowhere").empty());
}

TEST_F(JournalTest, NewEditorSweepsJournalsWithoutEditsAndNoOthers) {
    leaveBehind("edits.journal", "open fox.glb\nundo\n");
    leaveBehind("none.journal", "open fox.glb\n");
    leaveBehind("empty.journal", "");
    leaveBehind("notes.txt", "");
    const Journal journal(folder_);
    EXPECT_TRUE(fs::exists(folder_ + "/edits.journal"));
    EXPECT_FALSE(fs::exists(folder_ + "/none.journal"));
    EXPECT_FALSE(fs::exists(folder_ + "/empty.journal"));
    EXPECT_TRUE(fs::exists(folder_ + "/notes.txt"));
}

TEST_F(JournalTest, TakenOverWorkGoesOnInItsOwnFile) {
    leaveBehind("lost.journal", "open fox.glb\nundo\nstroke comb rad");
    Journal journal(folder_);
    const LostWork lost = lostWork(folder_).at(0);
    EXPECT_THROW(journal.takeOver(lost, "open fox.glb\n"), std::runtime_error);
    journal.takeOver(lost, "open fox.glb\nundo\n");
    EXPECT_TRUE(lostWork(folder_).empty());  // locked
    journal.append("redo");
    EXPECT_EQ(journal.path(), lost.path);
    EXPECT_EQ(contentOf(lost.path), "open fox.glb\nundo\nredo\n");
    EXPECT_EQ(temporary_.fileCount(), 1u);
}

TEST_F(JournalTest, NobodyTakesOrDiscardsWorkThatAnotherEditorGoesOnWith) {
    leaveBehind("lost.journal", "open fox.glb\nundo\n");
    Journal mine(folder_), other(folder_);
    mine.append("animal 100000");
    const LostWork lost = lostWork(folder_).at(0);
    other.takeOver(lost, "open fox.glb\nundo\n");
    EXPECT_THROW(mine.takeOver(lost, "open fox.glb\nundo\n"), std::runtime_error);
    EXPECT_THROW(discardLostWork(lost), std::runtime_error);
    mine.append("redo");
    EXPECT_EQ(contentOf(mine.path()), "animal 100000\nredo\n");
    EXPECT_EQ(contentOf(other.path()), "open fox.glb\nundo\n");
}

TEST_F(JournalTest, WorkThatIsGoneCanBeDiscardedButNotTakenOver) {
    leaveBehind("lost.journal", "open fox.glb\nundo\n");
    Journal journal(folder_);
    const LostWork lost = lostWork(folder_).at(0);
    discardLostWork(lost);
    EXPECT_THROW(journal.takeOver(lost, "open fox.glb\nundo\n"), std::runtime_error);
    EXPECT_NO_THROW(discardLostWork(lost));
    EXPECT_TRUE(fs::exists(journal.path()));
}

TEST_F(JournalTest, NewEditorSweepsARestartThatWasNeverFinished) {
    leaveBehind("half.unfinished", "open fox.glb\n# and more\n");
    EXPECT_TRUE(lostWork(folder_).empty());
    const Journal journal(folder_);
    EXPECT_FALSE(fs::exists(folder_ + "/half.unfinished"));
}

// Runs `prepare` and `work` in a process that is killed at the end, or before system call number
// `call` of the work; false when the work has no so many.
template <typename Prepare, typename Work>
bool killedBefore(int call, Prepare&& prepare, Work&& work) {
    const pid_t child = fork();
    if (child == 0) {
        auto prepared = prepare();
        ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        raise(SIGSTOP);
        work(*prepared);
        _exit(0);  // without any destructor, as if killed
    }
    int status = 0;
    waitpid(child, &status, 0);
    // The process stops on its way into each call and on its way out.
    for (int stop = 0; stop <= 2 * call && WIFSTOPPED(status); ++stop) {
        ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
        waitpid(child, &status, 0);
    }
    if (!WIFSTOPPED(status)) return false;
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return true;
}

TEST_F(JournalTest, KillAtAnyStepOfARestartLeavesTheOldLinesOrAllTheNew) {
    int old = 0, fresh = 0;
    for (int call = 0, more = 1; more; ++call) {
        more = killedBefore(
            call,
            [&] {
                auto journal = std::make_unique<Journal>(folder_);
                journal->append("open fox.glb");
                journal->append("undo");
                return journal;
            },
            [](Journal& journal) {
                journal.restart({"open cat.glb", "# no more"});
            });
        const std::vector<LostWork> lost = lostWork(folder_);
        ASSERT_EQ(lost.size(), 1u) << "killed before call " << call;
        const std::string lines = contentOf(lost[0].path);
        const bool isOld = lines == "open fox.glb\nundo\n";
        EXPECT_TRUE(isOld || lines == "open cat.glb\n# no more\n") << lines;
        ++(isOld ? old : fresh);
        discardLostWork(lost[0]);
    }
    EXPECT_GT(old, 3);  // before the file is made, locked, written, renamed
    EXPECT_GT(fresh, 1);
}

TEST_F(JournalTest, KillAtAnyStepOfTakingOverKeepsTheLostWork) {
    const std::string lines = "open fox.glb\nundo\n";
    int calls = 0;
    for (bool more = true; more; ++calls) {
        leaveBehind("lost.journal", lines + "stroke comb rad");
        more = killedBefore(
            calls, [] { return std::make_unique<int>(); },
            [&](int) {
                static Journal journal(folder_);
                journal.takeOver(lostWork(folder_).at(0), lines);
            });
        const std::vector<LostWork> lost = lostWork(folder_);
        ASSERT_EQ(lost.size(), 1u) << "killed before call " << calls;
        EXPECT_EQ(lost[0].path, folder_ + "/lost.journal");
        EXPECT_EQ(lost[0].edits, 1u);
        EXPECT_TRUE(contentOf(lost[0].path).starts_with(lines)) << "killed before call " << calls;
    }
    EXPECT_GT(calls, 10);
    EXPECT_EQ(contentOf(folder_ + "/lost.journal"), lines);  // the last time nobody was killed
}

// What an editor does that is killed: it tells through a pipe how many appends have returned.
[[noreturn]] void appendForEver(const std::string& folder, int tell) {
    Journal journal(folder);
    journal.append("open fox.glb");
    for (int i = 0;; ++i) {
        journal.append("set fur.seed " + std::to_string(i));
        if (write(tell, &i, sizeof i) != sizeof i) _exit(1);
    }
}

TEST_F(JournalTest, KillLosesNothingForWhichAppendReturned) {
    test::Draws draws(21);
    for (int round = 0; round < 12; ++round) {
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) appendForEver(folder_, ends[1]);
        close(ends[1]);
        int last = -1;
        const int enough = static_cast<int>(draws.below(40));
        while (last < enough && read(ends[0], &last, sizeof last) == sizeof last) {
        }
        usleep(draws.below(3000));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
        while (read(ends[0], &last, sizeof last) == sizeof last) {
        }
        close(ends[0]);

        const std::vector<LostWork> lost = lostWork(folder_);
        ASSERT_EQ(lost.size(), 1u);
        EXPECT_EQ(lost[0].document, "fox.glb");
        EXPECT_GE(lost[0].edits, static_cast<std::size_t>(last + 1));
        std::string wanted = "open fox.glb\n";
        for (int i = 0; i <= last; ++i) wanted += "set fur.seed " + std::to_string(i) + "\n";
        EXPECT_TRUE(contentOf(lost[0].path).starts_with(wanted));
        discardLostWork(lost[0]);
    }
}

TEST(JournalFolder, FollowsTheEnvironment) {
    const char* oldState = std::getenv("XDG_STATE_HOME");
    const std::string keep = oldState ? oldState : "";
    setenv("XDG_STATE_HOME", "/tmp/state", 1);
    EXPECT_EQ(journalFolder(), "/tmp/state/pelage");
    setenv("XDG_STATE_HOME", "relative", 1);  // to be ignored, says the XDG specification
    if (std::getenv("HOME")) {
        EXPECT_EQ(journalFolder(), std::string(std::getenv("HOME")) + "/.local/state/pelage");
    }
    if (oldState)
        setenv("XDG_STATE_HOME", keep.c_str(), 1);
    else
        unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace pelage
