#include "app/studio/window_annotations.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "widgets/annotation_form.h"
#include "widgets/annotation_overlay.h"
#include "widgets/label_tool.h"
#include "widgets/viewport.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QShortcut>

#include <utility>

namespace limner {

WindowAnnotations::WindowAnnotations(const Workplace& place)
    : QObject(place.window), place_(place), form_(new AnnotationForm), overlay_(new AnnotationOverlay(place.viewport)),
      tool_(new LabelTool(place.viewport)) {
    panel_ = place_.addDock("dock.annotations", tr("Annotations"), form_, Qt::RightDockWidgetArea);
    connect(panel_, &QDockWidget::visibilityChanged, overlay_, &AnnotationOverlay::setActive);
    connect(form_, &AnnotationForm::edited, place_.document, &StudioDocument::apply);
    connect(form_, &AnnotationForm::selectionChanged, overlay_, [this] { overlay_->select(form_->selected()); });
    connect(overlay_, &AnnotationOverlay::edited, place_.document, &StudioDocument::apply);
    connect(overlay_, &AnnotationOverlay::chosen, form_, [this](std::size_t index) { form_->select(index); });
    connect(overlay_, &AnnotationOverlay::wordsWanted, form_, &AnnotationForm::writeWords);
    connect(overlay_, &AnnotationOverlay::removeWanted, form_, &AnnotationForm::removeSelected);
    connectTool();
    connect(place_.document, &StudioDocument::changed, this, &WindowAnnotations::showFigure);
    place_.viewport->installEventFilter(this);
    showFigure();
}

void WindowAnnotations::connectTool() {
    QAction* action = place_.actions->at("edit.add-label");
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this](bool on) {
        if (!on) {
            tool_->layDown();
            return;
        }
        showPanel();
        tool_->take();
    });
    connect(tool_, &LabelTool::takenChanged, action, &QAction::setChecked);
    // While the words are written the keyboard is not the tool's: Esc leaves it from there too.
    auto* leave = new QShortcut(Qt::Key_Escape, form_->words(), nullptr, nullptr, Qt::WidgetShortcut);
    leave->setEnabled(false);
    connect(tool_, &LabelTool::takenChanged, leave, &QShortcut::setEnabled);
    connect(leave, &QShortcut::activated, tool_, &LabelTool::layDown);
    connect(tool_, &LabelTool::edited, place_.document, &StudioDocument::apply);
    connect(tool_, &LabelTool::labelled, this,
            [this] { form_->writeWords(place_.document->figure()->annotations.size() - 1); });
    connect(form_, &AnnotationForm::labelWanted, action, &QAction::trigger);
}

void WindowAnnotations::showPanel() {
    panel_->show();
    panel_->raise();
}

void WindowAnnotations::showFigure() {
    const std::shared_ptr<const Figure> figure = place_.document->figure();
    form_->setFigure(figure);
    overlay_->setFigure(figure);
    tool_->setFigure(figure);
    place_.actions->at("edit.add-label")->setEnabled(figure != nullptr);
}

void WindowAnnotations::showPlaces() {
    const ScreenPicture& picture = *place_.viewport->picture();
    if (std::exchange(shown_, picture.image.cacheKey()) != picture.image.cacheKey())
        form_->setPlaces(picture.annotations);
}

bool WindowAnnotations::eventFilter(QObject* watched, QEvent* event) {
    // A new picture makes the viewport paint: the list says then which of them are in it.
    if (watched == place_.viewport && event->type() == QEvent::Paint && place_.viewport->picture())
        showPlaces();
    return QObject::eventFilter(watched, event);
}

} // namespace limner
