// journal.h -- committed edits as lines of script in a file, so that a killed editor loses nothing.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

// A journal that an editor left behind without ending in good order (its lock is free). Replay it
// with replayJournal (script.h).
struct LostWork {
    std::string path;       // of the journal
    std::string document;   // what its first line names: a path, or "animal"
    std::size_t edits = 0;  // complete lines after the first
};
// The journal of one running editor. Each line is on the disk when append returns.
class Journal {
public:
    // A new, empty journal file in `folder` (made if absent), locked while this object lives.
    // Sweeps away what killed editors left there without an edit in it. Throws std::runtime_error.
    explicit Journal(std::string folder);
    ~Journal();  // removes the file: the editor ended in good order
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    // Throws std::runtime_error when the disk refuses, and then no part of the line is kept; and
    // for a line that holds a newline, which only the name of a file can.
    void append(std::string_view line);
    // Begins anew: what came before is saved elsewhere or given up. Whoever is killed meanwhile
    // leaves the old lines or all the new ones; throws like append, and then the old are kept.
    void restart(std::initializer_list<std::string_view> lines);
    // Goes on in the journal of lost work, which was replayed: these are its complete lines. They
    // are ours from now on, and the file that was ours is removed. Whoever is killed meanwhile
    // leaves the lost work as it was. Throws when another editor has taken it up, changed or
    // discarded it; then nothing has changed here.
    void takeOver(const LostWork& lost, std::string_view lines);
    const std::string& path() const { return path_; }

private:
    std::string path_;
    int file_ = -1;
    std::size_t size_ = 0;  // bytes of complete lines
};

// Where journals live: $XDG_STATE_HOME/pelage or ~/.local/state/pelage. Throws std::runtime_error
// when neither variable names an absolute path.
std::string journalFolder();

// Journals with at least one edit, in the order of their paths. A folder that is not there has
// none.
std::vector<LostWork> lostWork(const std::string& folder);
// Removes the journal, which nobody wants. Throws when another editor has taken it up.
void discardLostWork(const LostWork& lost);

}  // namespace pelage
