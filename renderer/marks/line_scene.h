#pragma once

#include "renderer/marks/mark_field.h"
#include "renderer/marks/mark_view.h"
#include "renderer/marks/marks.h"

namespace limner {

/// What all line marks are drawn from.
struct LineScene {
    const MarkField& field;
    const MarkView& view;
    const MarkDepth& depth; ///< empty: lines behind matter are drawn like those before it
    InkColour ink{0};
    bool moving = false; ///< silhouettes are plain segments, as many as are asked for, at once
};

} // namespace limner
