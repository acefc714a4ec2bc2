// text_scan.h -- walks the numbers and words of a text file and knows the line it is on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pelage {

// Lines end in \n, \r\n or \r. A backslash before the end of a line joins it with the next; a
// word ends there. From a '#' that begins a word, the line is a comment. Every refusal is
// "horse.obj: line 12: ...".
class TextScan {
public:
    // `bytes` must outlive the scan.
    TextScan(std::string file, std::span<const std::byte> bytes)
        : file_(std::move(file)),
          at_(reinterpret_cast<const char*>(bytes.data())),
          end_(at_ + bytes.size()) {}

    std::size_t line() const { return line_; }
    std::size_t bytesLeft() const { return static_cast<std::size_t>(end_ - at_); }

    bool atEnd() const { return at_ == end_; }
    // Skips blanks and comments; true when nothing more is on this line.
    bool atLineEnd();
    void nextLine();
    // Goes to the next line that holds something; false at the end of the file.
    bool nextContent();

    // The next word of this line; empty at its end.
    std::string_view word();
    // What is left of this line, without blanks around it.
    std::string_view rest();

    // The next word as a number; nothing at the end of the line. What is no number, or none that
    // is finite as float, is refused.
    std::optional<float> tryNumber();
    float number(const char* what);  // refuses the end of the line
    std::optional<std::int64_t> tryInteger();
    std::int64_t integer(const char* what);

    [[noreturn]] void refuse(const std::string& what) const { refuseAt(line_, what); }
    [[noreturn]] void refuseAt(std::size_t line, const std::string& what) const;

private:
    bool atJoint() const;  // of two lines
    void skipBlanks();

    std::string file_;
    const char* at_;
    const char* end_;
    std::size_t line_ = 1;
};

}  // namespace pelage
