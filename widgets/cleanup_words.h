#pragma once

#include "core/figure/figure.h"

#include <QString>

namespace limner {

/// A clean-up step of the figure in plain words: "Keep the largest island above 300 HU".
QString cleanupWords(const CleanupStep& step, const Figure& figure);

/// What a kind of step does, for menus: "Keep the largest island".
QString cleanupKindWords(CleanupKind kind);

} // namespace limner
