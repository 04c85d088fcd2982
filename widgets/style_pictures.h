#pragma once

#include "core/base/task.h"
#include "renderer/plan/planner.h"
#include "renderer/style_target.h"

#include <QColor>
#include <QImage>

namespace limner {

/// Small pictures for choosing styles. Keeps what planning one scan takes, apart from what the large picture keeps, so
/// that neither waits for the other. For a worker's thread; calls are serialised inside. Throws Error(cancelled) and
/// what planning throws.
class StylePictures {
  public:
    /// A figure of the shown scan, its longer side `edgePixels`, with its paper and its ink. Drawn plainer than the
    /// large picture.
    QImage figure(const RenderPlan& shown, const Figure& changed, int edgePixels, Task& task);

    /// Where the shown picture has what a style would go onto: a veil of the colour as strong as its share of each
    /// pixel, with a line around where that is more than half. Premultiplied, on nothing.
    QImage reach(const RenderPlan& shown, const StyleTarget& target, const QColor& colour, Task& task);

  private:
    Planner figures_;
    Planner reaches_; ///< apart: one planner keeps the fields of its last figure
};

} // namespace limner
