#include "widgets/transfer_editor_1d.h"

#include "core/figure/layer_edits.h"
#include "widgets/form_parts.h"
#include "widgets/transfer_parts.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace limner {

TransferEditor1d::TransferEditor1d(QWidget* parent)
    : QWidget(parent), canvas_(new TransferCanvas), what_(new QLabel), value_(new QDoubleSpinBox),
      opacity_(new QDoubleSpinBox),
      add_(textButton(tr("Add point"), tr("Add an opacity point after the selected one"))),
      step_(textButton(tr("Step"), tr("Let the opacity jump at the selected point instead of rising towards it"))),
      remove_(textButton(tr("Remove"), tr("Remove the selected point or style (Delete)"))),
      curve_(choiceBox("/layers/*/transfer/opacity_curve",
                       {{"linear", tr("Linear")}, {"smooth", tr("Smooth")}, {"step", tr("Steps")}})),
      counts_(new QComboBox) {
    value_->setKeyboardTracking(false);
    value_->setAccessibleName(tr("Value of the selected handle"));
    value_->setToolTip(tr("Data value of the selected handle, in the volume's unit"));
    opacity_->setKeyboardTracking(false);
    opacity_->setRange(0, 100);
    opacity_->setDecimals(1);
    opacity_->setSuffix(tr(" %"));
    opacity_->setAccessibleName(tr("Opacity of the selected point"));
    opacity_->setToolTip(tr("Opacity of the selected point, in percent for a thickness of one voxel"));
    counts_->addItem(tr("Logarithm"), static_cast<int>(CountScale::logarithmic));
    counts_->addItem(tr("Square root"), static_cast<int>(CountScale::root));
    counts_->addItem(tr("Plain counts"), static_cast<int>(CountScale::linear));
    counts_->setAccessibleName(tr("Histogram's scale"));
    counts_->setToolTip(tr("How the histogram's heights follow the number of voxels; the figure stays as it is"));
    counts_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    leaveWheelToPanel(counts_);
    layOut();
    connectParts();
    showSelection();
}

void TransferEditor1d::layOut() {
    auto* fields = new QHBoxLayout;
    fields->setSpacing(6);
    fields->addWidget(what_);
    fields->addWidget(value_, 1);
    fields->addWidget(opacity_, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    for (QToolButton* button : {add_, step_, remove_})
        buttons->addWidget(button);
    buttons->addWidget(curve_, 1);
    auto* view = new QHBoxLayout;
    view->setSpacing(6);
    auto* histogram = new QLabel(tr("Histogram"));
    histogram->setBuddy(counts_);
    histogram->setToolTip(counts_->toolTip());
    view->addWidget(histogram);
    view->addWidget(counts_, 1);
    view->addWidget(zoomButtons(canvas_));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(canvas_, 1);
    layout->addLayout(fields);
    layout->addLayout(buttons);
    layout->addLayout(view);
}

void TransferEditor1d::connectParts() {
    connect(canvas_, &TransferCanvas::edited, this, &TransferEditor1d::edited);
    connect(canvas_, &TransferCanvas::selectionChanged, this, [this] {
        showSelection();
        Q_EMIT selectionChanged();
    });
    connect(value_, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { canvas_->moveSelected(value, std::nullopt); });
    connect(opacity_, &QDoubleSpinBox::valueChanged, this,
            [this](double percent) { canvas_->moveSelected(value_->value(), percent / 100); });
    connect(add_, &QToolButton::clicked, canvas_, &TransferCanvas::addPointAfterSelected);
    connect(step_, &QToolButton::clicked, canvas_, &TransferCanvas::makeStepAtSelected);
    connect(remove_, &QToolButton::clicked, canvas_, &TransferCanvas::removeSelected);
    connect(curve_, &QComboBox::activated, this,
            [this](int index) { canvas_->setCurve(static_cast<OpacityCurve>(index)); }); // words in the enum's order
    connect(counts_, &QComboBox::currentIndexChanged, this,
            [this] { canvas_->setCountScale(static_cast<CountScale>(counts_->currentData().toInt())); });
}

void TransferEditor1d::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    const Volume* volume = figure && figure->volume ? figure->volume->data.get() : nullptr;
    if (volume) {
        const QSignalBlocker quiet(value_);
        const double width = volume->range().high - volume->range().low;
        // Points may lie outside the data; the fields follow them a good way.
        value_->setRange(volume->range().low - width, volume->range().high + width);
        const int decimals = width >= 200 ? 0 : static_cast<int>(std::ceil(3 - std::log10(std::max(width, 1e-6))));
        value_->setDecimals(std::clamp(decimals, 0, 8));
        value_->setSingleStep(std::pow(10.0, std::floor(std::log10(std::max(width, 1e-6) / 200))));
        const std::string& unit = volume->contents().unit;
        value_->setSuffix(unit.empty() ? QString() : " " + QString::fromStdString(unit));
    }
    locked_ = figure && layer < figure->layers.size() && !mayChange(*figure, layer);
    canvas_->setEnabled(!locked_);
    canvas_->setFigure(std::move(figure), layer);
}

std::optional<std::size_t> TransferEditor1d::selectedNode() const {
    const auto& handle = canvas_->selected();
    if (handle && handle->kind == TransferCanvas::HandleKind::node)
        return handle->index;
    return std::nullopt;
}

void TransferEditor1d::showSelection() {
    const QSignalBlocker quietValue(value_);
    const QSignalBlocker quietOpacity(opacity_);
    const Transfer* t = canvas_->transfer();
    const auto& handle = canvas_->selected();
    const bool point = !locked_ && t && handle && handle->kind == TransferCanvas::HandleKind::point;
    const bool node = !locked_ && t && handle && handle->kind == TransferCanvas::HandleKind::node;
    what_->setText(locked_ ? tr("The layer is locked")
                   : point ? tr("Point")
                   : node  ? tr("Style")
                           : tr("Nothing selected"));
    value_->setVisible(point || node);
    opacity_->setVisible(point);
    if (point) {
        value_->setValue(t->opacity[handle->index].x);
        opacity_->setValue(t->opacity[handle->index].y * 100);
    } else if (node) {
        value_->setValue(t->nodes[handle->index].at);
    }
    add_->setEnabled(t && !locked_);
    curve_->setEnabled(t && !locked_);
    if (t)
        curve_->setCurrentIndex(static_cast<int>(t->curve));
    step_->setEnabled(point);
    remove_->setEnabled(point || (node && t->nodes.size() > 1));
}

} // namespace limner
