// bad_lines.h -- lines of script that are refused, each in one clear line that changes nothing.
#pragma once

#include <span>

#include "core/script.h"
#include "gtest/gtest.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage::test {

struct BadLine {
    const char *line, *says;
};

// What a line is refused with.
inline std::string errorOf(Workspace& workspace, std::string_view line) {
    return refusal([&] { runLine(workspace, line); });
}

inline void expectRefused(std::span<const BadLine> lines) {
    Workspace workspace;
    workspace.open(evenDocument(ball(1)));
    const Document before = workspace.editor->document();
    for (const auto& [line, says] : lines) {
        const std::string error = errorOf(workspace, line);
        EXPECT_NE(error.find(says), std::string::npos) << line << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    EXPECT_EQ(workspace.editor->document(), before);
}

}  // namespace pelage::test
