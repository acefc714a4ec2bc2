// files.cpp -- the only place that writes files, and how a whole file is read.
#include "files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "text.h"

namespace pelage {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
    throw std::runtime_error(path + ": " + what + ": " + std::strerror(error));
}

// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    int number() const { return number_; }
    bool open() const { return number_ >= 0; }
    // Closes now; false when the system could not keep what was written.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

// The file that a path means in the end: symbolic links followed, also one that names no file yet.
std::string linkTarget(std::string path) {
    namespace fs = std::filesystem;
    for (int hop = 0; hop < 40; ++hop) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error) fail(path, "cannot follow the link", error.value());
        path = (fs::path(path).parent_path() / next).string();
    }
    fail(path, "cannot follow the link", ELOOP);
}

void writeAll(int file, std::span<const std::byte> bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t wrote = ::write(file, bytes.data(), bytes.size());
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) fail(path, "cannot write", errno);
        bytes = bytes.subspan(static_cast<std::size_t>(wrote));
    }
}

// Makes the new name of a file survive a power cut. Some file systems cannot sync a folder and say
// EINVAL; there the rename is as safe as it gets.
void syncFolder(const std::string& folder, const std::string& path) {
    const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!file.open()) fail(path, "cannot open the folder", errno);
    if (::fsync(file.number()) != 0 && errno != EINVAL) fail(path, "cannot sync the folder", errno);
}

// A file that is being written in the folder of the one that it will replace. Where the system can,
// it has no name until it is complete, so that it vanishes with a process that is killed.
class Beside {
public:
    Beside(const std::string& folder, const std::string& path)
        : path_(path),
          name_(folder + "/.pelage-XXXXXX"),
          file_(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600)) {
        if (file_.open() && ::access(self().c_str(), F_OK) == 0) return;
        file_ = Descriptor(::mkostemp(name_.data(), O_CLOEXEC));
        if (!file_.open()) fail(path_, "cannot write beside it", errno);
        named_ = true;
    }
    ~Beside() {
        if (named_) ::unlink(name_.c_str());
    }
    Beside(const Beside&) = delete;
    Beside& operator=(const Beside&) = delete;

    int number() const { return file_.number(); }

    void replace(const std::string& target) {
        if (!named_) giveName();
        if (!file_.close()) fail(path_, "cannot write", errno);
        if (::rename(name_.c_str(), target.c_str()) != 0) fail(path_, "cannot replace", errno);
        named_ = false;
    }

private:
    std::string self() const { return "/proc/self/fd/" + std::to_string(file_.number()); }

    void giveName() {
        const std::string stem = name_.substr(0, name_.size() - 6);
        for (int attempt = 100000; attempt < 1000000; ++attempt) {
            name_ = stem + std::to_string(attempt);
            named_ =
                ::linkat(AT_FDCWD, self().c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) == 0;
            if (named_) return;
            if (errno != EEXIST) break;
        }
        fail(path_, "cannot write beside it", errno);
    }

    std::string path_, name_;
    bool named_ = false;
    Descriptor file_;
};

}  // namespace

void writeFileAtomically(const std::string& path, std::span<const std::byte> bytes) {
    const std::string target = linkTarget(path);
    const std::string parent = std::filesystem::path(target).parent_path().string();
    const std::string folder = parent.empty() ? "." : parent;

    struct stat old {};
    const bool replaces = ::stat(target.c_str(), &old) == 0;
    if (replaces && !S_ISREG(old.st_mode))
        fail(path, "cannot write", S_ISDIR(old.st_mode) ? EISDIR : EINVAL);

    Beside file(folder, path);
    writeAll(file.number(), bytes, path);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    const mode_t mode = replaces ? old.st_mode & 07777u : 0666u & ~mask;
    if (::fchmod(file.number(), mode) != 0) fail(path, "cannot set permissions", errno);
    if (::fsync(file.number()) != 0) fail(path, "cannot sync", errno);
    file.replace(target);
    syncFolder(folder, path);
}

void makeFolder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw std::runtime_error(path + ": " + error.message());
}

bool hasExtension(const std::string& path, std::string_view extension) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    const std::string name = std::filesystem::path(path).filename().string();
    return name.size() > extension.size() &&
           std::ranges::equal(std::string_view(name).substr(name.size() - extension.size()),
                              extension, {}, lower, lower);
}

void expectExtension(const std::string& path, std::string_view extension) {
    if (!hasExtension(path, extension))
        throw std::runtime_error(inQuotes(path) + " does not end in " + std::string(extension));
}

std::vector<std::byte> readFile(const std::string& path, std::size_t limit) {
    // A pipe nobody writes to must not hang the open: hence O_NONBLOCK, which files ignore.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.open()) throw std::runtime_error(path + ": " + std::strerror(errno));
    struct stat about {};
    if (::fstat(file.number(), &about) != 0) fail(path, "cannot look at it", errno);
    if (!S_ISREG(about.st_mode)) throw std::runtime_error(path + ": is not a regular file");
    const auto size = static_cast<std::size_t>(about.st_size);
    if (size > limit) {
        throw std::runtime_error(path + ": is " + std::to_string(size) + " bytes long; at most " +
                                 std::to_string(limit) + " are read");
    }
    std::vector<std::byte> bytes(size);
    std::size_t have = 0;
    while (have < size) {
        const ssize_t got = ::read(file.number(), bytes.data() + have, size - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path, "cannot read", errno);
        if (got == 0) break;  // became shorter while it was read
        have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
}

}  // namespace pelage
