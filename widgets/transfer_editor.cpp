#include "widgets/transfer_editor.h"

#include "core/figure/layer_edits.h"
#include "core/figure/plane_view.h"
#include "core/figure/transfer_kinds.h"
#include "widgets/form_parts.h"
#include "widgets/transfer_parts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace limner {

TransferEditor::TransferEditor(TransferEditor1d* line, QWidget* parent)
    : QWidget(parent), line_(line), plane_(new TransferEditor2d), stack_(new QStackedWidget), first_(new QComboBox),
      second_(new QComboBox), note_(new QLabel) {
    auto* axes = new QHBoxLayout;
    axes->setContentsMargins(8, 6, 8, 0);
    axes->setSpacing(6);
    const auto add = [&](const QString& text, QComboBox* box, const QString& tip) {
        auto* label = new QLabel(text);
        label->setBuddy(box);
        label->setToolTip(tip);
        box->setAccessibleName(tip);
        box->setToolTip(tip);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        leaveWheelToPanel(box);
        axes->addWidget(label);
        axes->addWidget(box, 1);
    };
    add(tr("Axis"), first_, tr("The measure that picks style and opacity"));
    add(tr("and"), second_, tr("A second measure: the function is drawn over the plane of both"));
    note_->setWordWrap(true);
    note_->setContentsMargins(8, 0, 8, 0);
    note_->hide();
    stack_->addWidget(line_);
    stack_->addWidget(plane_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(axes);
    layout->addWidget(note_);
    layout->addWidget(stack_, 1);
    connect(plane_, &TransferEditor2d::edited, this, &TransferEditor::edited);
    connect(first_, &QComboBox::activated, this, [this] { takeFirst(chosenWord(first_)); });
    connect(second_, &QComboBox::activated, this, [this] { takeSecond(chosenWord(second_)); });
    fillBoxes();
}

const Transfer* TransferEditor::transfer() const {
    return figure_ && layer_ < figure_->layers.size() ? &figure_->layers[layer_].transfer : nullptr;
}

bool TransferEditor::showsPlane() const { return stack_->currentWidget() == plane_; }

QString TransferEditor::note() const { return note_->text(); }

void TransferEditor::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    figure_ = std::move(figure);
    layer_ = layer;
    plane_->setFigure(figure_, layer_);
    const bool plane = transfer() && secondAxis(*transfer());
    stack_->setCurrentWidget(plane ? static_cast<QWidget*>(plane_) : line_);
    fillBoxes();
}

void TransferEditor::fillBoxes() {
    const Transfer* t = transfer();
    QString missing;
    const auto fill = [&](QComboBox* box, const std::string& now) {
        const QSignalBlocker quiet(box);
        box->clear();
        if (box == second_)
            box->addItem(tr("no second axis"), QString());
        for (const char* word : axisWords()) {
            box->addItem(axisName(word), QString(word));
            const QString lacks = figure_ ? axisMissing(*figure_, word) : QString();
            auto* item = qobject_cast<QStandardItemModel*>(box->model())->item(box->count() - 1);
            item->setToolTip(lacks);
            item->setEnabled(lacks.isEmpty() || now == word);
            if (now == word && !lacks.isEmpty())
                missing = lacks;
        }
        choose(box, now);
        box->setEnabled(t && mayChange(*figure_, layer_));
    };
    const bool plane = t && secondAxis(*t);
    fill(first_, !t ? "value" : plane ? t->axes[0] : t->axis);
    fill(second_, plane ? t->axes[1] : "");
    note_->setText(missing);
    note_->setVisible(!missing.isEmpty());
}

void TransferEditor::emitTransfer(const Transfer& changed, const QString& label) {
    if (!mayChange(*figure_, layer_) || changed == *transfer())
        return;
    Edit edit{*figure_, label.toStdString(), {}, false};
    edit.figure.layers[layer_].transfer = changed;
    Q_EMIT edited(edit);
}

void TransferEditor::takeFirst(const std::string& axis) {
    const Transfer* t = transfer();
    const bool same = !t || axis == (secondAxis(*t) ? t->axes[0] : t->axis);
    if (!same)
        emitTransfer(withAxis(*figure_, *t, 0, axis), tr("Change the axis"));
    fillBoxes(); // a refused choice goes back
}

void TransferEditor::takeSecond(const std::string& axis) {
    const Transfer* t = transfer();
    if (t && axis.empty() && secondAxis(*t)) {
        emitTransfer(withOneAxis(*t, shownPlane(*figure_, *t)), tr("Use one axis"));
    } else if (t && !axis.empty() && !secondAxis(*t) && axis != t->axis) {
        Transfer start = *t;
        if (transferAxis(axis) == TransferAxis::distance && !start.distance)
            start.distance.emplace().fromMm = figure_->camera.targetMm;
        const ValueRange x = shownRange(*figure_, start, firstAxis(start));
        const ValueRange y = shownRange(*figure_, start, transferAxis(axis));
        emitTransfer(withTwoAxes(start, axis, {{x.low, y.low}, {x.high, y.high}}), tr("Use two axes"));
    } else if (t && !axis.empty() && secondAxis(*t) && axis != t->axes[1]) {
        emitTransfer(withAxis(*figure_, *t, 1, axis), tr("Change the second axis"));
    }
    fillBoxes();
}

void TransferEditor::setMark(const std::optional<TransferPlane::Mark>& mark) {
    line_->canvas()->setMark(mark);
    plane_->canvas()->setMark(mark);
}

} // namespace limner
