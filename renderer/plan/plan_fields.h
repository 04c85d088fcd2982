#pragma once

#include "core/base/task.h"
#include "core/volume/derived_fields.h"
#include "renderer/plan/plan_layer.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace limner {

/// Keeps the last few results of a computation by what they were made from. Successive plans differ in few inputs.
template <typename Key, typename Value>
class RecentResults {
  public:
    explicit RecentResults(std::size_t kept = 1) : kept_(kept) {}

    template <typename Compute>
    const Value& get(const Key& key, const Compute& compute) {
        for (std::size_t i = 0; i < results_.size(); ++i) {
            if (results_[i].first == key) {
                std::rotate(results_.begin(), results_.begin() + static_cast<std::ptrdiff_t>(i),
                            results_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
                return results_.front().second;
            }
        }
        results_.insert(results_.begin(), {key, compute()});
        if (results_.size() > kept_) {
            results_.pop_back();
        }
        return results_.front().second;
    }

  private:
    std::size_t kept_;
    std::vector<std::pair<Key, Value>> results_; ///< latest first
};

/// The fields beside the scan that a plan's layers read: computed when a figure first needs them, kept while figures
/// still do.
class PlanFields {
  public:
    /// Fills in `interpolation`, `gradient` and their fields.
    void chooseEstimators(RenderPlan& plan, Task& task);
    /// Ranges of the axes that a layer may use, on the plan's volume. Throws as `addFields` does.
    AxisRanges axisRanges(const RenderPlan& plan, const Layer& layer, Task& task);
    /// Fills in labels, distances, the second volume, local statistics and the field that curvature is measured on,
    /// where layers or importance read them. Throws Error(badInput) for what a layer asks for and the figure has not.
    void addFields(RenderPlan& plan, Task& task);

  private:
    using VolumePointer = std::shared_ptr<const Volume>;
    struct LabelKey {
        VolumePointer labels;
        VolumePointer volume;
        std::map<int, std::uint8_t> slots;
        friend bool operator==(const LabelKey&, const LabelKey&) = default;
    };
    struct DistanceKey {
        VolumePointer labels;
        VolumePointer volume;
        int label = 0;
        friend bool operator==(const DistanceKey&, const DistanceKey&) = default;
    };
    void addLabels(RenderPlan& plan, Task& task);
    const VolumePointer& distanceMap(const RenderPlan& plan, const Layer& layer, Task& task);

    RecentResults<VolumePointer, VolumePointer> splines_;
    RecentResults<VolumePointer, GradientEstimator> automatic_;
    RecentResults<VolumePointer, VolumePointer> slices_; ///< thick ones, blurred
    RecentResults<VolumePointer, VolumePointer> bends_;
    RecentResults<VolumePointer, std::vector<VolumePointer>> blurs_;
    RecentResults<LabelKey, VolumePointer> slots_;
    RecentResults<DistanceKey, VolumePointer> distances_{4}; ///< layers may each have their own
    RecentResults<std::pair<VolumePointer, VolumePointer>, VolumePointer> second_;
    RecentResults<std::pair<VolumePointer, double>, VolumePointer> statistics_;
};

} // namespace limner
