// journal.h -- committed edits as lines of script in a file, so that a killed editor loses nothing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

// The journal of one running editor. Each line is on the disk when append returns.
class Journal {
public:
    // A new, empty journal file in `folder` (made if absent), locked while this object lives.
    explicit Journal(std::string folder);
    ~Journal();  // removes the file: the editor ended in good order
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    // Throws std::runtime_error when the disk refuses.
    void append(std::string_view line);
    // Begins anew: what came before is saved elsewhere or given up. `line` is the new first line.
    void restart(std::string_view line);
    const std::string& path() const { return path_; }

private:
    std::string path_;
    int file_ = -1;
};

// Where journals live: $XDG_STATE_HOME/pelage or ~/.local/state/pelage.
std::string journalFolder();

// A journal that an editor left behind without ending in good order (its lock is free).
struct LostWork {
    std::string path;      // of the journal
    std::string document;  // what its open line names
    std::size_t edits = 0;
};
std::vector<LostWork> lostWork(const std::string& folder);

}  // namespace pelage
