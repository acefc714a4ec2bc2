// script.h -- one line of text, one edit: replay, tests, bug reports and crash recovery.
//
// The lines (documented in README.md; `pelage export --script FILE` and the journal use the same):
//   open PATH
//   animal [TRIANGLES]                     the built-in animal, as the program opens it
//   preset NAME|FILE                       a coat by its name, or a file that ends in .fur.json
//   set over.stiffness 0.3 [NAME VALUE ...]
//   stroke TOOL [add|subtract|set VALUE] [color r g b] radius R [strength S] [falloff NAME]
//          [mirror] [through] : px py pz nx ny nz  px py pz nx ny nz ...
//   flood TOOL [add|subtract|set VALUE] [color r g b] [strength S] [direction x y z]
//   region WHERE [sizes] [falloff F] : CHANNEL ACT      as region_text.h says
//   reset TOOL                             what the tool paints, as it was before any painting
//   segment NAME [axis x y z] [weight W]  combs a body segment along its own axis or this one
//   comb head-to-tail [weight W]           combs the whole body along its segments
//   undo
//   redo
//   save PATH                              refuses a name that does not end in .glb
// Blank lines and lines that begin with # do nothing. The words after TOOL may come in any order;
// strength is 0.5 for a stroke and 1 for a flood unless said. Only comb takes a direction, and a
// flood of it needs one; only tint takes a color, linear RGB and 1 1 1 unless said; cut needs a
// value; part and clump cannot flood. Undo and redo at the end of the history do nothing. Numbers
// are written so that they read back bit for bit. PATH and NAME of a preset are the rest of the line.
#pragma once

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
    std::optional<Stroke> stroke;  // between press and release

    // Replaces the document. The old one stays if this throws.
    void open(Document document);

    // A stroke by hand. Drag and release do nothing without a press.
    void press(const Brush& brush, vec3 position, vec3 normal);
    void drag(vec3 position, vec3 normal);
    // Ends the stroke as one step of history, and returns its script line; empty if it changed
    // nothing, and then there is no step.
    std::string release();
    // Takes the stroke back.
    void cancelStroke();
};

// Runs one line; each line that edits ends in one commit. Drops edits that were not committed, and
// a stroke in progress. Throws std::runtime_error with what is wrong in the line; the document is
// then as before it.
void runLine(Workspace& workspace, std::string_view line);

// Runs a script file; errors are prefixed with "FILE: line N: ". The lines before stay done.
void runScript(Workspace& workspace, const std::string& path);

// Runs the journal of an editor that was killed: as a script, but a last line without its newline
// was never finished and is left out. Returns the lines that were run, each with its newline.
std::string replayJournal(Workspace& workspace, const std::string& path);

// The line that makes `after` of `before`, bit for bit: "set over.stiffness 0.3 fur.hairs 90000".
// Empty when they are equal.
std::string setLine(const Fur& before, const Fur& after);

// The line of a flood. The direction counts for comb only.
std::string floodLine(const Brush& brush, vec3 direction = vec3(0.0f));

}  // namespace pelage
