// print.cpp -- results to stdout.
#include "app/cli/print.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace pelage {

void print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout)) {
        throw std::runtime_error(std::string("standard output: ") + std::strerror(errno));
    }
}

void printJson(const OrderedJson& object) {
    print(object.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
}

std::string bytesText(std::size_t bytes) {
    constexpr std::array kUnits = {"B", "kB", "MB", "GB"};
    double size = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; size >= 1000.0 && unit + 1 < kUnits.size(); ++unit) size /= 1000.0;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), unit == 0 ? "%.0f %s" : "%.1f %s", size, kUnits[unit]);
    return text.data();
}

}  // namespace pelage
