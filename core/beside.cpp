// beside.cpp -- checks a reference twice: as text, and by where it leads on the disk.
#include "beside.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "files.h"
#include "text.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

std::string percentDecoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned value = 0;
        const char* digits = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() &&
            std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
            out += static_cast<char>(static_cast<unsigned char>(value));
            i += 2;
        } else {
            out += text[i];
        }
    }
    return out;
}

// "http:", "file:", "C:" and the like; a one-letter scheme is a drive.
bool hasScheme(std::string_view text) {
    const std::size_t colon = text.find(':');
    return colon != std::string_view::npos &&
           std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' ||
                      c == '.';
           });
}

// Why a decoded reference is refused, or null.
const char* objection(std::string_view name) {
    if (name.empty()) return "is empty";
    if (name.front() == '/' || name.front() == '~')
        return "is not relative to the folder of the file";
    if (hasScheme(name)) return "has a scheme; only files beside this one are read";
    for (const char c : name) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return "holds a control character";
        if (std::string_view("\\|`$<>*?#\"").find(c) != std::string_view::npos) {
            return "holds a character that no name of a file beside this one has";
        }
    }
    for (const fs::path& step : fs::path(name)) {
        if (step == "..") return "leads out of the folder of the file";
    }
    return nullptr;
}

}  // namespace

std::string pathBeside(const std::string& owner, std::string_view uri) {
    const auto refuse = [&](const std::string& why) {
        throw std::runtime_error((owner.empty() ? "" : owner + ": ") + "reference " +
                                 inQuotes(uri) + " " + why);
    };
    if (owner.empty()) refuse("is to another file, and there is no folder to look in");
    const std::string name = percentDecoded(uri);
    if (const char* why = objection(name)) refuse(why);

    const fs::path parent = fs::path(owner).parent_path();
    const fs::path folder = fs::weakly_canonical(parent.empty() ? fs::path(".") : parent);
    std::error_code error;
    const fs::path file = fs::weakly_canonical(folder / name, error);
    if (error) refuse("cannot be followed: " + error.message());
    const auto [inFolder, inFile] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    if (inFolder != folder.end() || inFile == file.end()) {
        refuse("leads out of the folder of the file");
    }
    return file.string();
}

std::vector<std::byte> readBeside(const std::string& owner, std::string_view uri,
                                  std::size_t limit) {
    const std::string path = pathBeside(owner, uri);
    try {
        return readFile(path, limit);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(owner + ": reference " + inQuotes(uri) + ": " + error.what());
    }
}

}  // namespace pelage
