#include "widgets/label_tool.h"

#include "core/figure/annotation_edits.h"
#include "widgets/viewport.h"

#include <QMouseEvent>

namespace limner {

LabelTool::LabelTool(Viewport* viewport) : ToolOverlay(viewport, tr("Add label")) {}

QString LabelTool::hint() const {
    if (missed_)
        return tr("There is too little to see here to point at · click on the structure · Esc: leave");
    return labelled_ ? tr("Type the words, then click on the next structure · Esc: leave")
                     : tr("Click on the structure to name, then type · Esc: leave");
}

void LabelTool::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !viewport().picture() ||
        figure()->annotations.size() >= kMostAnnotations) {
        event->ignore();
        return;
    }
    const auto pick = viewport().pickAt(event->position());
    missed_ = !pick;
    update();
    if (!pick)
        return;
    Edit edit{*figure(), tr("Add label").toStdString(), {}, false};
    Annotation label = newAnnotation("label");
    label.text = tr("Label").toStdString();
    label.anchorMm = pick->pointMm;
    edit.figure.annotations.push_back(label);
    labelled_ = true;
    setAccessibleDescription(hint());
    Q_EMIT edited(edit);
    Q_EMIT labelled();
}

} // namespace limner
