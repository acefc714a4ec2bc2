// reading.h -- what tests of readers need: a folder of their own, and the words of a refusal.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gtest/gtest.h"

namespace pelage::test {

// What the work was refused with, or "(not refused)".
template <typename Work>
std::string refusal(Work&& work) {
    try {
        work();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "(not refused)";
}

inline std::vector<std::byte> bytesOf(std::string_view text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

// A folder that is removed with all in it.
class TempFolder {
public:
    TempFolder() {
        std::string name = testing::TempDir() + "pelage-XXXXXX";
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TempFolder() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string path() const { return path_.string(); }
    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, std::span<const std::byte> bytes) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream file(path_ / name, std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
        return path(name);
    }
    std::string write(const std::string& name, std::string_view text) const {
        return write(name, bytesOf(text));
    }
    std::size_t fileCount() const {
        const std::filesystem::directory_iterator files(path_);
        return static_cast<std::size_t>(std::distance(begin(files), end(files)));
    }

private:
    std::filesystem::path path_;
};

// A mesh beside the repository, or an empty path when it is not there.
inline std::string sharedMesh(const std::string& name) {
    const std::string path = std::string(PELAGE_SHARED_DIR) + "/meshes/" + name;
    return std::filesystem::exists(path) ? path : std::string();
}

}  // namespace pelage::test
