// editor.h -- the document being edited and its history. The only owner of both.
//
// A slider drag and a brush stroke are the same thing: many edits, then one commit.
// History keeps whole documents; they share what did not change (chunked.h), so there are
// no inverse operations to write, and none to get wrong.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document.h"

namespace pelage {

class Editor {
public:
    static constexpr std::size_t kUndoSteps = 256;  // that can be undone; older ones are forgotten

    explicit Editor(Document opened);

    const Document& document() const { return working_; }

    // Changes the document on screen. Not yet a step of history: see commit, cancel.
    template <std::invocable<Document&> Change>
    void edit(Change&& change) {
        change(working_);
    }

    // Ends a run of edits as one named step; forgets what could be redone.
    // Does nothing if the run changed nothing, and says so: true when it made a step.
    bool commit(std::string label);

    // Drops the edits since the last commit.
    void cancel();

    // One step back or forward. Uncommitted edits are dropped first. False at the end.
    bool undo();
    bool redo();

    // Names for the Edit menu, empty when there is nothing to undo or redo.
    std::string_view undoLabel() const;
    std::string_view redoLabel() const;

    // The steps that are kept, oldest first, and which of them is on screen.
    std::size_t stepCount() const { return steps_.size(); }
    std::string_view stepLabel(std::size_t step) const { return steps_[step].label; }
    std::size_t currentStep() const { return current_; }

    // True when what is on screen is what markSaved was last called for (at first: as opened).
    bool saved() const { return current_ == saved_ && working_ == steps_[current_].document; }
    void markSaved() { saved_ = current_; }

private:
    struct Step {
        std::string label;  // what led here from the step before
        Document document;
    };

    static constexpr std::size_t kMaxSteps = 1 + kUndoSteps;

    std::vector<Step> steps_;  // never empty; steps_[0] is the document as opened
    std::size_t current_ = 0;
    std::optional<std::size_t> saved_ = 0;  // empty once the saved step is forgotten
    Document working_;
};

}  // namespace pelage
