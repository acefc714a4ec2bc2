// print.h -- results to stdout: one JSON object, or text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pelage {

using OrderedJson = nlohmann::ordered_json;  // numbers are double: floats are printed exactly

// Writes text to stdout and flushes it. Throws std::runtime_error when stdout takes no more.
void print(const std::string& text);

// One object and a newline. Bytes that are not UTF-8 (file names may hold them) become U+FFFD.
void printJson(const OrderedJson& object);

// "1.5 MB"
std::string bytesText(std::size_t bytes);

}  // namespace pelage
