// warnings.h -- what a reader found worth telling: each thing once, and never a flood.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

class Warnings {
public:
    // Ignores what was said before, and counts what is too much to say.
    void add(std::string text) {
        if (std::find(lines_.begin(), lines_.end(), text) != lines_.end()) return;
        if (lines_.size() < kMost) {
            lines_.push_back(std::move(text));
        } else {
            ++more_;
        }
    }

    std::vector<std::string> take() {
        if (more_ > 0) lines_.push_back("and " + std::to_string(more_) + " more warnings");
        return std::move(lines_);
    }

private:
    static constexpr std::size_t kMost = 40;
    std::vector<std::string> lines_;
    std::size_t more_ = 0;
};

}  // namespace pelage
