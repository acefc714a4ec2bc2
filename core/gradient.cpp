// gradient.cpp -- ramps: their values at the vertices, and their lines of script.
#include "gradient.h"

#include <cassert>
#include <stdexcept>

#include "text.h"
#include "tools.h"

namespace pelage {
namespace {

// Where the vertex lies along the line: 0 at `from`, 1 at `to`.
double placeAlong(const Gradient& gradient, vec3 position) {
    const glm::dvec3 from(gradient.from), along = glm::dvec3(gradient.to) - from;
    return glm::dot(glm::dvec3(position) - from, along) / glm::dot(along, along);
}

// The numbers of one end's value.
int valuesOf(Tool tool) { return tool == Tool::tint ? 3 : 1; }

float mostOf(Tool tool) { return toolInfo(tool).ofLength ? kGreatestLength : 1.0f; }

struct End {
    vec3 place{0.0f}, value{0.0f};
};

End endFrom(Words& words, Tool tool) {
    End end;
    end.place = pointAfter(words, "the end of a gradient");
    for (int i = 0; i < valuesOf(tool); ++i)
        end.value[i] = numberAfter(words, "the value", 0.0f, mostOf(tool));
    return end;
}

std::string endText(Tool tool, const End& end) {
    std::string text = ' ' + pointText(end.place);
    for (int i = 0; i < valuesOf(tool); ++i) text += ' ' + floatText(end.value[i]);
    return text;
}

}  // namespace

bool hasGradient(Tool tool) {
    return tool == Tool::length || tool == Tool::density || tool == Tool::mask ||
           tool == Tool::tint;
}

void applyGradient(const Skin& skin, Groom& groom, const Gradient& gradient) {
    assert(hasGradient(gradient.tool) && gradient.from != gradient.to);
    Brush brush{.tool = gradient.tool, .strength = 1.0f};
    if (toolInfo(gradient.tool).hasSet) brush.mode = Mode::set;
    Touching touching;
    touching.coverage = 1.0f;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const double place = placeAlong(gradient, skin.vertices[v].position);
        if (gradient.between && !(place >= 0.0 && place <= 1.0)) continue;
        const float t = static_cast<float>(glm::clamp(place, 0.0, 1.0));
        brush.color = glm::mix(gradient.start, gradient.end, t);
        brush.value = brush.color.x;
        writeVertex(groom, v, brushedFur(skin, groom, brush, v, touching),
                    brushedMask(groom, brush, v, touching));
    }
}

std::string gradientLine(const Gradient& gradient) {
    return std::string("gradient ") + toolInfo(gradient.tool).name +
           (gradient.between ? " between" : "") + " from" +
           endText(gradient.tool, {gradient.from, gradient.start}) + " to" +
           endText(gradient.tool, {gradient.to, gradient.end});
}

void runGradient(const Skin& skin, Editor& editor, Words& words) {
    Gradient gradient;
    gradient.tool = toolNamed(words.next()).tool;
    const char* name = toolInfo(gradient.tool).name;
    if (!hasGradient(gradient.tool))
        throw std::runtime_error(std::string(name) +
                                 " has no gradient; length, density, mask and tint have");
    if (Words ahead = words; ahead.next() == "between") {
        words = ahead;
        gradient.between = true;
    }
    expectWord(words, "from");
    const End from = endFrom(words, gradient.tool);
    expectWord(words, "to");
    const End to = endFrom(words, gradient.tool);
    expectEnd(words);
    if (from.place == to.place) throw std::runtime_error("both ends are the same point");
    gradient.from = from.place;
    gradient.start = from.value;
    gradient.to = to.place;
    gradient.end = to.value;
    editor.edit([&](Document& document) { applyGradient(skin, document.groom, gradient); });
    editor.commit(std::string("Gradient of ") + name);
}

}  // namespace pelage
