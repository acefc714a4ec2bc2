// script.h -- one line of text, one edit: replay, tests, bug reports and crash recovery.
//
// The lines (documented in README.md; `pelage export --script FILE` and the journal use the same):
//   open PATH
//   animal [TRIANGLES]                     the built-in animal, as the program opens it
//   preset NAME|FILE                       a coat by its name, or a file that ends in .fur.json
//   set over.stiffness 0.3 [NAME VALUE ...]
//   stroke TOOL [add|subtract|set VALUE|scale FACTOR] [color r g b] radius R [strength S]
//          [falloff NAME] [mirror [xyz]] [straight] [through] [pressure] : px py pz nx ny nz  px py
//          pz nx ny nz ...
//   flood TOOL [add|subtract|set VALUE|scale FACTOR] [color r g b] [strength S] [direction x y z]
//   region WHERE [sizes] [falloff F] : CHANNEL ACT      as region_text.h says
//   gradient TOOL [between] from x y z VALUE to x y z VALUE         as gradient.h says
//   mask invert|clear|fill                 the whole painted mask, as mask_edit.h says
//   mask grow|shrink|smooth [RINGS]
//   mask from length|density|WHERE ...
//   reset TOOL                             what the tool paints, as it was before any painting
//   segment NAME [axis x y z] [weight W]  combs a body segment along its own axis or this one
//   body add|move|rename|remove NAME ...   the list of body segments, as segment_text.h says
//   comb head-to-tail [weight W]           combs the whole body along its segments
//   pose CLIP SECONDS [morph W W ...]      stands as at that moment of a clip, by name or number
//   pose rest [morph W W ...]              the weights are those of the morph targets, in order
//   subdivide [LEVELS]                     four triangles for each, once unless said (subdivide.h)
//   transfer PATH                          the groom of another file on this mesh (transfer.h)
//   undo
//   redo
//   save PATH                              refuses a name that does not end in .glb
// Blank lines and lines that begin with # do nothing. The words after TOOL may come in any order;
// `mirror` alone stands for `mirror x`, `straight` for distances that do not follow the surface.
// `pressure` stands last and adds a seventh number to each point, [0,1], by which the brush presses
// there; strength is 0.5 for a stroke and 1 for a flood unless said. Only comb takes a direction,
// and a flood of it needs one; only tint takes a color, linear RGB and 1 1 1 unless said; cut needs
// a value; after the tool segment comes the NAME of a body segment, as segment_text.h writes it, or
// # for none; part and clump cannot flood. Undo and redo at the end of the history do nothing. A pose
// is no step of history: it says where the points of the strokes after it lie, until the next pose
// or document. Numbers are written so that they read back bit for bit. PATH and NAME of a preset are
// the rest of the line.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "brush.h"
#include "editor.h"
#include "pose.h"

namespace pelage {

// What a script runs on: an editor and what goes with its skin. Empty until something is opened.
struct Workspace {
    std::unique_ptr<Editor> editor;
    std::unique_ptr<SkinQuery> query;  // of the skin as it stands, see follow()
    std::optional<Stroke> stroke;      // between press and release
    Pose pose;
    std::shared_ptr<const Skin> posed;  // null at rest

    // The skin as it stands: that of the document, in its pose.
    const std::shared_ptr<const Skin>& shown() const {
        return posed ? posed : editor->document().skin;
    }

    // Replaces the document, at rest. The old one stays if this throws.
    void open(Document document);

    // Takes a stroke in progress back, and makes the skin stand so. Quick enough for every frame
    // of an animation, because the query is left behind until follow().
    void stand(Pose to);
    // Makes `posed` and `query` those of the skin on screen, which undo, redo, edits of the mesh and
    // poses change; a stroke ends with its skin. Lines and presses do so by themselves, whoever
    // changes the document past this interface calls it.
    void follow();
    // Of the editor; `query` follows.
    bool undo();
    bool redo();

    // A stroke by hand. Drag and release do nothing without a press.
    void press(const Brush& brush, vec3 position, vec3 normal, float pressure = 1.0f);
    void drag(vec3 position, vec3 normal, float pressure = 1.0f);
    // Ends the stroke as one step of history, and returns its script line; empty if it changed
    // nothing, and then there is no step.
    std::string release();
    // Takes the stroke back.
    void cancelStroke();
};

// Labels of the steps that the editor's own window makes of the same edits.
inline constexpr const char* kSubdivideLabel = "Subdivide";
inline constexpr const char* kTransferLabel = "Transfer groom";

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

std::string subdivideLine(int levels);
std::string transferLine(const std::string& path);

// The line of a flood. The direction counts for comb only.
std::string floodLine(const Brush& brush, vec3 direction = vec3(0.0f));

}  // namespace pelage
