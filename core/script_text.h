// script_text.h -- how brushes are written in a line of script, and read back bit for bit.
#pragma once

#include <string>
#include <string_view>

#include "brush.h"

namespace pelage {

// "length set 0.03 strength 0.5": what strokes and floods have in common.
std::string toolText(const Brush& brush);
// "comb add strength 0.5 radius 0.05 falloff sharp mirror xz straight through": the brush of a
// stroke, without what is at its default and can be left out.
std::string brushText(const Brush& brush);

// The words of a line, one after the other.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    // The next word, empty at the end.
    std::string_view next();
    // What is left of the line, without blanks around it.
    std::string_view rest();
    // The same with the blanks at its end, which a file name may have.
    std::string_view path();
    bool done() { return rest().empty(); }

private:
    std::string_view rest_;
};

// Throw std::runtime_error unless the line ends here, or this is the next word.
void expectEnd(Words& words);
void expectWord(Words& words, std::string_view expected);

// The text as one word, with blanks, control characters and % written as %20 and so on; and back.
// The latter throws std::runtime_error naming what is no such word.
std::string wordText(std::string_view text);
std::string textOfWord(std::string_view word);

// The word, or the next one, or the next three, as numbers. Throws std::runtime_error "WHAT \"x\"
// is no number from LEAST to GREATEST".
float numberFrom(std::string_view word, std::string_view what, float least, float greatest);
float numberAfter(Words& words, std::string_view what, float least, float greatest);
// `greatest` of the three: 1e6 keeps squares of them finite.
vec3 pointAfter(Words& words, std::string_view what, float greatest = 1e6f);
// "0.5 1 2"
std::string pointText(vec3 point);

// The row of the tool table. Throws std::runtime_error that lists the tools.
const ToolInfo& toolNamed(std::string_view word);

struct BrushWords {
    Brush brush;
    std::string_view stopped;  // the word that no brush knows; empty at the end of the line
};
// The brush that the words describe, up to the first word that no brush knows. Without `ofStroke`
// it is that of a flood, which has no radius. Throws std::runtime_error naming the offending word.
BrushWords brushFromWords(Words& words, bool ofStroke);

}  // namespace pelage
