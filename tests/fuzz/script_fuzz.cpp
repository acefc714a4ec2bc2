// script_fuzz.cpp -- any text is a script or an error of one line, and leaves the groom in range.
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "../core/test_skins.h"
#include "core/coat.h"
#include "core/script.h"
#include "fuzz.h"

namespace pelage {
namespace {

using fuzz::check;

void checkGroom(const Groom& groom) {
    for (std::size_t v = 0; v < groom.fur.size(); ++v) {
        const FurVertex& fur = groom.fur[v];
        check(fur.furLength >= 0.0f && fur.furLength <= 1e6f);
        check(fur.density >= 0.0f && fur.density <= 1.0f);
        check(glm::length(fur.direction) <= 1.0f + 1e-5f);
        check(groom.mask[v] >= 0.0f && groom.mask[v] <= 1.0f);
    }
}

// The name of the line's command; files are left alone here.
bool touchesFiles(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return false;
    line.remove_prefix(first);
    return line.starts_with("open") || line.starts_with("save") || line.starts_with("animal") ||
           (line.starts_with("preset") && line.find('.') != line.npos);
}

}  // namespace
}  // namespace pelage

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pelage;
    static const Document document = test::evenDocument(test::ball(2));
    Workspace workspace;
    workspace.open(document);
    std::string_view text(reinterpret_cast<const char*>(data), size);
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (touchesFiles(line)) continue;
        const Document before = workspace.editor->document();
        if (!fuzz::doneOrRefused([&] { runLine(workspace, line); }))
            check(workspace.editor->document() == before);
    }
    checkGroom(workspace.editor->document().groom);
    return 0;
}
