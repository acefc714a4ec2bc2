// text_scan.cpp -- numbers by std::from_chars: fast, and the same in every locale.
#include "text_scan.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "text.h"

namespace pelage {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool endsLine(char c) { return c == '\n' || c == '\r'; }

// std::from_chars knows no plus sign.
std::string_view withoutPlus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

template <typename T>
std::errc parse(std::string_view word, T& value) {
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    return result.ec == std::errc() && result.ptr != end ? std::errc::invalid_argument : result.ec;
}

}  // namespace

void TextScan::refuseAt(std::size_t line, const std::string& what) const {
    throw std::runtime_error(file_ + ": line " + std::to_string(line) + ": " + what);
}

bool TextScan::atJoint() const { return end_ - at_ > 1 && *at_ == '\\' && endsLine(at_[1]); }

void TextScan::skipBlanks() {
    while (at_ != end_) {
        if (isBlank(*at_)) {
            ++at_;
        } else if (atJoint()) {
            ++at_;
            nextLine();
        } else {
            return;
        }
    }
}

bool TextScan::atLineEnd() {
    skipBlanks();
    return at_ == end_ || endsLine(*at_) || *at_ == '#';
}

void TextScan::nextLine() {
    while (at_ != end_ && !endsLine(*at_)) ++at_;
    if (at_ == end_) return;
    const bool carriage = *at_++ == '\r';
    if (carriage && at_ != end_ && *at_ == '\n') ++at_;
    ++line_;
}

bool TextScan::nextContent() {
    while (!atEnd() && atLineEnd()) nextLine();
    return !atEnd();
}

std::string_view TextScan::word() {
    if (atLineEnd()) return {};
    const char* first = at_;
    while (at_ != end_ && !isBlank(*at_) && !endsLine(*at_) && !atJoint()) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view TextScan::rest() {
    skipBlanks();
    const char* first = at_;
    while (at_ != end_ && !endsLine(*at_)) ++at_;
    const char* last = at_;
    while (last != first && isBlank(last[-1])) --last;
    return {first, static_cast<std::size_t>(last - first)};
}

std::optional<float> TextScan::tryNumber() {
    const std::string_view text = word();
    if (text.empty()) return std::nullopt;
    float value = 0.0f;
    std::errc error = parse(withoutPlus(text), value);
    if (error == std::errc::result_out_of_range) {
        // Too small for a float is 0 or nearly so; too large is refused below.
        double wide = 0.0;
        error = parse(withoutPlus(text), wide);
        value = static_cast<float>(wide);
    }
    if (error != std::errc()) refuse(inQuotes(text) + " is not a number");
    if (!std::isfinite(value)) refuse(inQuotes(text) + " is not a finite number");
    return value;
}

float TextScan::number(const char* what) {
    const auto value = tryNumber();
    if (!value) refuse(std::string("ends where ") + what + " is expected");
    return *value;
}

std::optional<std::int64_t> TextScan::tryInteger() {
    const std::string_view text = word();
    if (text.empty()) return std::nullopt;
    std::int64_t value = 0;
    if (parse(withoutPlus(text), value) != std::errc())
        refuse(inQuotes(text) + " is not a whole number");
    return value;
}

std::int64_t TextScan::integer(const char* what) {
    const auto value = tryInteger();
    if (!value) refuse(std::string("ends where ") + what + " is expected");
    return *value;
}

}  // namespace pelage
