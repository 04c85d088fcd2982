#include "core/base/task.h"

#include "core/base/error.h"

#include <algorithm>

namespace limner {

void Task::throwIfCancelled() const {
    if (cancelled()) {
        throw Error(ErrorKind::cancelled, {"cancelled", "", "", ""});
    }
}

void Task::beginPhase(const std::string& name) {
    if (whole_ != nullptr) {
        return;
    }
    const std::lock_guard lock(mutex_);
    phase_ = name;
    fraction_ = 0;
    if (listener_ != nullptr) {
        listener_->progressed(phase_, 0);
    }
}

void Task::progress(double fraction) {
    if (whole_ != nullptr) {
        whole_->progress(from_ + std::clamp(fraction, 0.0, 1.0) * (to_ - from_));
        return;
    }
    const std::lock_guard lock(mutex_);
    // Parallel workers report out of order; a bar that jumps back reads as a fault.
    fraction_ = std::max(fraction_, std::clamp(fraction, 0.0, 1.0));
    if (listener_ != nullptr) {
        listener_->progressed(phase_, fraction_);
    }
}

void Task::warn(const std::string& message) {
    if (whole_ != nullptr) {
        whole_->warn(message);
        return;
    }
    const std::lock_guard lock(mutex_);
    if (std::find(warnings_.begin(), warnings_.end(), message) != warnings_.end()) {
        return;
    }
    warnings_.push_back(message);
    if (listener_ != nullptr) {
        listener_->warned(message);
    }
}

std::vector<std::string> Task::warnings() const {
    if (whole_ != nullptr) {
        return whole_->warnings();
    }
    const std::lock_guard lock(mutex_);
    return warnings_;
}

} // namespace limner
