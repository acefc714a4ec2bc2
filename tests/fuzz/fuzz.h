// fuzz.h -- what every fuzz target holds the code to: bad input is refused with one line, or read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>

namespace pelage::fuzz {

// Ends the run, and libFuzzer keeps the input. Unlike assert, in every build.
inline void check(bool holds) {
    if (!holds) __builtin_trap();
}

// Bad input is refused by std::runtime_error and in no other way; its message is one line.
// True when the work was done.
template <typename Work>
bool doneOrRefused(Work&& work) {
    try {
        work();
        return true;
    } catch (const std::runtime_error& error) {
        const std::string_view message = error.what();
        check(!message.empty() && message.find('\n') == message.npos);
        return false;
    }
}

// The body of a mesh reader's target. The reader gets no path, so that it opens no file beside it.
template <typename Reader>
int readMesh(Reader&& reader, const std::uint8_t* data, std::size_t size) {
    doneOrRefused([&] { reader(std::as_bytes(std::span(data, size)), "", nullptr); });
    return 0;
}

}  // namespace pelage::fuzz
