#include "widgets/island_overlay.h"

#include "core/figure/cleanup_start.h"
#include "widgets/viewport.h"

#include <QMouseEvent>

namespace limner {

IslandOverlay::IslandOverlay(Viewport* viewport) : ToolOverlay(viewport, tr("Keep the island here")) {}

QString IslandOverlay::hint() const {
    return missed_ ? tr("There is too little to see here to keep · click on the part that stays · Esc: leave")
                   : tr("Click on the part that stays; what is not connected with it goes · Esc: leave");
}

void IslandOverlay::mousePressEvent(QMouseEvent* event) {
    const auto& shown = viewport().picture();
    if (event->button() != Qt::LeftButton || !shown) {
        event->ignore();
        return;
    }
    const RenderPlan& plan = *shown->plan;
    const auto pick = viewport().pickAt(event->position());
    missed_ = !pick;
    update();
    if (!pick)
        return;
    Edit edit{*figure(), tr("Keep the island here").toStdString(), {}, false};
    edit.figure.cleanup.push_back(islandStep(*plan.figure, *plan.volume, pick->pointMm, pick->value));
    layDown();
    Q_EMIT edited(edit);
}

} // namespace limner
