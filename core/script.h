// script.h -- one line of text, one edit: replay, tests, bug reports and crash recovery.
//
// The lines (documented in README.md; `pelage export --script FILE` and the journal use the same):
//   open PATH
//   preset NAME
//   set over.stiffness 0.3
//   stroke TOOL [add|subtract|set VALUE] radius R strength S [falloff NAME] [mirror] [through]
//          : px py pz nx ny nz  px py pz nx ny nz ...
//   flood TOOL [add|subtract|set VALUE] strength S [direction x y z]
//   undo
//   redo
//   save PATH
// Blank lines and lines that begin with # do nothing. Numbers are written so that they read back
// bit for bit. PATH is the rest of the line.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "brush.h"
#include "editor.h"

namespace pelage {

// What a script runs on: an editor and what goes with its skin. Empty until something is opened.
struct Workspace {
    std::unique_ptr<Editor> editor;
    std::unique_ptr<SkinQuery> query;

    // Replaces the document. The old one stays if this throws.
    void open(Document document);
};

// Runs one line; each line that edits ends in one commit. Throws std::runtime_error with what is
// wrong in the line; the document is then as before it.
void runLine(Workspace& workspace, std::string_view line);

// Runs a script file; errors are prefixed with "FILE: line N: ".
void runScript(Workspace& workspace, const std::string& path);

}  // namespace pelage
