#pragma once

#include "core/figure/figure.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace limner {

/// What a control asks for: a whole new figure, never a change in place.
struct Edit {
    Figure figure;
    std::string label;    ///< for people, in the imperative: "Move opacity point"
    std::string mergeKey; ///< edits with the same key that follow each other are one step; empty: never merged
    bool ongoing = false; ///< more of the same gesture is to come (a drag): drafts are enough
};

/// Undo and redo over figure values. Undo is a pointer move: every step is a whole figure, which is cheap because
/// volumes and style pictures are shared. Not thread-safe: one thread (the interface's) owns it.
class History {
  public:
    /// Names one state of the document; never reused within a history. A document is unchanged when its id is the one
    /// it was saved with.
    using StateId = std::uint64_t;

    struct Step {
        std::shared_ptr<const Figure> figure;
        std::string label; ///< of the edit that led here; the start's is empty
        std::string mergeKey;
        StateId id = 0;
    };

    /// Keeps at most `limit` undo steps; the oldest fall away.
    explicit History(Figure start = {}, std::size_t limit = 1000);

    [[nodiscard]] const std::shared_ptr<const Figure>& current() const { return steps_[position_].figure; }
    [[nodiscard]] StateId stateId() const { return steps_[position_].id; }
    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ + 1 < steps_.size(); }
    /// Label of the step that undo takes back or redo repeats; empty where there is none.
    [[nodiscard]] std::string undoLabel() const;
    [[nodiscard]] std::string redoLabel() const;
    /// All kept states, oldest first, for a list; `position` is the current one's place.
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] std::size_t position() const { return position_; }

    /// Makes the edit's figure the current one; what could be redone is gone. An edit that changes nothing is no step;
    /// one that merges back to where its gesture began takes the step away. Returns whether the state changed.
    bool apply(Edit edit);
    /// The next edit starts a step of its own, whatever its key (after a save, a pause, a finished gesture).
    void endMerge() { mergeOpen_ = false; }
    /// Return false at the end of the list.
    bool undo();
    bool redo();
    /// Goes to a kept state by its place in `steps`, any number of steps back or forth; all steps stay. Returns whether
    /// that is another state than the current one; a place that is not there is none.
    bool goTo(std::size_t position);

  private:
    [[nodiscard]] bool merges(const Edit& edit) const;

    std::vector<Step> steps_; ///< never empty
    std::size_t position_ = 0;
    std::size_t limit_;
    StateId nextId_ = 1;
    bool mergeOpen_ = false;
};

} // namespace limner
