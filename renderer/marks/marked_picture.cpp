#include "renderer/marks/marked_picture.h"

#include "renderer/marks/draw_marks.h"
#include "renderer/marks/lay_marks.h"
#include "renderer/marks/mark_field.h"

namespace limner {

RenderResult renderLayers(const RenderPlan& plan, const Backend& backend, const Tile& tile, Task& task) {
    if (!plan.marks || plan.marks->layersDrawn)
        return backend.render(plan, tile, task);
    RenderResult result;
    result.picture = Picture(tile.size);
    return result;
}

void Backend::layDots(const RenderPlan& plan, const Tile& tile, Picture& picture, Task& task) const {
    layMarks(drawMarks(plan, task, {true, false}), plan.size, tile, picture);
}

MarkedPicture::MarkedPicture(const RenderPlan& plan, const Backend& backend, Task& task)
    : plan_(plan), backend_(backend), dotsByBackend_(backend.laysDots(plan)) {
    if (plan.marks)
        marks_ = drawMarks(plan, task, {!dotsByBackend_, true});
}

RenderResult MarkedPicture::render(const Tile& tile, Task& task) const {
    RenderResult result = renderLayers(plan_, backend_, tile, task);
    if (marks_) {
        task.throwIfCancelled();
        if (dotsByBackend_)
            backend_.layDots(plan_, tile, result.picture, task); // of one ink: before strokes or after, it is the same
        layMarks(*marks_, plan_.size, tile, result.picture);
    }
    return result;
}

} // namespace limner
