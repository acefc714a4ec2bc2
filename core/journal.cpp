// journal.cpp -- files that outlive their editor only if it was killed.
#include "journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace pelage {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".journal";
constexpr const char* kUnfinished = ".unfinished";  // it will be renamed to a journal

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

// A file descriptor that closes itself.
class File {
public:
    explicit File(int number) : number_(number) {}
    File(File&& other) noexcept : number_(other.release()) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (number_ >= 0) close(number_);
    }
    int number() const { return number_; }
    bool isOpen() const { return number_ >= 0; }
    int release() { return std::exchange(number_, -1); }

private:
    int number_;
};

// A new file's name is on the disk only when its folder is.
void syncFolder(const std::string& folder) {
    const File file(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!file.isOpen() || fsync(file.number()) != 0) fail(folder, "cannot be synced");
}

bool writeAll(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = write(file, text.data(), text.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

LostWork readJournal(const std::string& path) {
    LostWork lost;
    lost.path = path;
    std::ifstream stream(path, std::ios::binary);
    std::string line;
    // getline also returns an unfinished last line, at the end of the file.
    for (std::size_t number = 0; std::getline(stream, line) && !stream.eof(); ++number) {
        if (number > 0) {
            ++lost.edits;
        } else {
            lost.document =
                line.starts_with("open ") ? line.substr(5) : line.substr(0, line.find(' '));
        }
    }
    return lost;
}

// All lines of the journal that were finished.
std::string completeLines(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    text.resize(text.rfind('\n') + 1);  // none: npos + 1 is 0
    return text;
}

// The journals that no editor holds, with at least one edit. The others are swept away on request,
// under their lock, so that an editor that is making one just now notices.
std::vector<LostWork> lostJournals(const std::string& folder, bool sweep) {
    std::vector<LostWork> found;
    std::error_code error;  // a folder that cannot be read has no journals for us
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        const bool unfinished = entry.path().extension() == kUnfinished;
        if (entry.path().extension() != kExtension && !unfinished) continue;
        const File file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
        struct stat status {};
        if (!file.isOpen() || fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
            continue;
        if (flock(file.number(), LOCK_SH | LOCK_NB) != 0) continue;
        LostWork lost = readJournal(path);
        if (lost.edits > 0 && !unfinished) {
            found.push_back(std::move(lost));
        } else if (sweep) {
            unlink(path.c_str());
        }
    }
    std::sort(found.begin(), found.end(),
              [](const LostWork& a, const LostWork& b) { return a.path < b.path; });
    return found;
}

void refuseNewline(const std::string& path, std::string_view line) {
    if (line.find('\n') != std::string_view::npos)
        throw std::runtime_error(path + ": a line of the journal cannot hold a newline");
}

// True if the file is still in its folder: another editor's sweep may have come between the
// making of the file and its lock.
bool stillNamed(int file) {
    struct stat status {};
    return fstat(file, &status) == 0 && status.st_nlink > 0;
}

// The journal of an editor that is gone, for us alone; not open if it is gone as well. Throws when
// another editor holds it.
File lockedAlone(const std::string& path) {
    File file(open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (!file.isOpen()) {
        if (errno != ENOENT) fail(path, "cannot be opened");
        return file;
    }
    if (flock(file.number(), LOCK_EX | LOCK_NB) != 0)
        fail(path, "another editor goes on with this work");
    return stillNamed(file.number()) ? std::move(file) : File(-1);
}

struct NewFile {
    std::string path;
    File file;
};

// An empty journal under a name of its own, locked.
NewFile newFile(const std::string& folder, const char* extension) {
    for (;;) {
        std::string path = folder + "/XXXXXX" + extension;
        const int number =
            mkostemps(path.data(), static_cast<int>(std::strlen(extension)), O_APPEND | O_CLOEXEC);
        if (number < 0) fail(folder, "no journal can be made there");
        NewFile made{path, File(number)};
        if (flock(number, LOCK_EX) != 0) {
            const int why = errno;
            unlink(path.c_str());
            errno = why;
            fail(path, "cannot be locked");
        }
        if (stillNamed(number)) return made;
    }
}

}  // namespace

Journal::Journal(std::string folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw std::runtime_error(folder + ": cannot be made: " + error.message());
    lostJournals(folder, true);

    NewFile made = newFile(folder, kExtension);
    path_ = std::move(made.path);
    file_ = made.file.release();
    syncFolder(folder);
}

Journal::~Journal() {
    unlink(path_.c_str());
    close(file_);
}

void Journal::append(std::string_view line) {
    refuseNewline(path_, line);
    std::string text(line);
    text += '\n';
    if (!writeAll(file_, text) || fdatasync(file_) != 0) {
        const int why = errno;
        // What follows must not be glued to half a line. If this fails too, the disk is gone.
        if (ftruncate(file_, static_cast<off_t>(size_)) != 0) fail(path_, "cannot be cut back");
        errno = why;
        fail(path_, "cannot be written");
    }
    size_ += text.size();
}

void Journal::restart(std::initializer_list<std::string_view> lines) {
    std::string text;
    for (const std::string_view line : lines) {
        refuseNewline(path_, line);
        text.append(line) += '\n';
    }
    const std::string folder = fs::path(path_).parent_path().string();
    NewFile made = newFile(folder, kUnfinished);
    if (!writeAll(made.file.number(), text) || fdatasync(made.file.number()) != 0 ||
        rename(made.path.c_str(), path_.c_str()) != 0) {
        const int why = errno;
        unlink(made.path.c_str());
        errno = why;
        fail(path_, "cannot be begun anew");
    }
    close(std::exchange(file_, made.file.release()));
    size_ = text.size();
    syncFolder(folder);
}

void Journal::takeOver(const LostWork& lost, std::string_view lines) {
    File file = lockedAlone(lost.path);
    if (!file.isOpen() || completeLines(lost.path) != lines)
        throw std::runtime_error(lost.path + ": another editor has gone on with this work");
    if (ftruncate(file.number(), static_cast<off_t>(lines.size())) != 0)
        fail(lost.path, "cannot be cut after its last line");
    const std::string mine = std::exchange(path_, lost.path);
    close(std::exchange(file_, file.release()));
    size_ = lines.size();
    unlink(mine.c_str());
}

std::string journalFolder() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && state[0] == '/')
        return std::string(state) + "/pelage";
    if (const char* home = std::getenv("HOME"); home && home[0] == '/')
        return std::string(home) + "/.local/state/pelage";
    throw std::runtime_error("no place for the journal: HOME names no folder");
}

std::vector<LostWork> lostWork(const std::string& folder) { return lostJournals(folder, false); }

void discardLostWork(const LostWork& lost) {
    const File file = lockedAlone(lost.path);
    if (file.isOpen() && unlink(lost.path.c_str()) != 0) fail(lost.path, "cannot be removed");
}

}  // namespace pelage
