// script_text.h -- how numbers and brushes are written in a line of script, and read back bit for
// bit.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "brush.h"

namespace pelage {

// The shortest text that reads back to the same float.
std::string floatText(float number);
// Empty unless all of the text is one finite number.
std::optional<float> floatFromText(std::string_view text);

// "comb add radius 0.05 strength 0.5 falloff smooth mirror through", without what is at its default
// and can be left out.
std::string brushText(const Brush& brush);

// The words of a line, one after the other.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    // The next word, empty at the end.
    std::string_view next();
    // What is left of the line, without blanks around it.
    std::string_view rest();
    bool done() { return rest().empty(); }

private:
    std::string_view rest_;
};

// The brush that the words describe, up to ":" or, for a flood, up to the first word that no brush
// knows, which is left. Throws std::runtime_error naming the offending word.
struct BrushWords {
    Brush brush;
    std::string_view stopped;  // the word that ended it, empty at the end of the line
};
BrushWords brushFromWords(Words& words, bool needsRadius);

}  // namespace pelage
