#include "core/project/history.h"

#include <algorithm>
#include <utility>

namespace limner {

History::History(Figure start, std::size_t limit) : limit_(std::max<std::size_t>(limit, 1)) {
    steps_.push_back({std::make_shared<const Figure>(std::move(start)), {}, {}, nextId_++});
}

std::string History::undoLabel() const { return canUndo() ? steps_[position_].label : std::string(); }

std::string History::redoLabel() const { return canRedo() ? steps_[position_ + 1].label : std::string(); }

bool History::merges(const Edit& edit) const {
    return mergeOpen_ && canUndo() && !edit.mergeKey.empty() && steps_[position_].mergeKey == edit.mergeKey;
}

bool History::apply(Edit edit) {
    if (edit.figure == *current())
        return false;
    steps_.resize(position_ + 1);
    if (merges(edit)) {
        if (edit.figure == *steps_[position_ - 1].figure) {
            steps_.pop_back();
            --position_;
            mergeOpen_ = false;
            return true;
        }
        steps_[position_].figure = std::make_shared<const Figure>(std::move(edit.figure));
        steps_[position_].id = nextId_++;
        return true;
    }
    mergeOpen_ = !edit.mergeKey.empty();
    steps_.push_back({std::make_shared<const Figure>(std::move(edit.figure)), std::move(edit.label),
                      std::move(edit.mergeKey), nextId_++});
    if (steps_.size() > limit_ + 1)
        steps_.erase(steps_.begin());
    position_ = steps_.size() - 1;
    return true;
}

bool History::undo() {
    if (!canUndo())
        return false;
    --position_;
    mergeOpen_ = false;
    return true;
}

bool History::goTo(std::size_t position) {
    if (position == position_ || position >= steps_.size())
        return false;
    position_ = position;
    mergeOpen_ = false;
    return true;
}

bool History::redo() {
    if (!canRedo())
        return false;
    ++position_;
    mergeOpen_ = false;
    return true;
}

} // namespace limner
