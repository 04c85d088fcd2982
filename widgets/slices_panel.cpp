#include "widgets/slices_panel.h"

#include "widgets/form_parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

namespace limner {

SlicesPanel::SlicesPanel(QWidget* parent)
    : QWidget(parent), words_(new QLabel), lookHere_(new QPushButton(tr("&Look here"))) {
    auto* split = new QSplitter(Qt::Vertical);
    split->setChildrenCollapsible(true);
    for (const SlicePlane plane : {SlicePlane::axial, SlicePlane::coronal, SlicePlane::sagittal}) {
        auto* canvas = new SliceCanvas(plane);
        canvases_[static_cast<std::size_t>(plane)] = canvas;
        split->addWidget(canvas);
        connect(canvas, &SliceCanvas::pointMoved, this, [this](const glm::dvec3& pointMm) {
            setPoint(pointMm);
            Q_EMIT pointMoved(pointMm_);
        });
    }
    words_->setAccessibleName(tr("Value and place of the point"));
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setToolTip(tr("The scan's value at the cross hairs, and their place in patient coordinates (LPS, mm)"));
    lookHere_->setToolTip(tr("Put the point into the middle of the figure; views and turns go about it"));
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 6);
    foot->addWidget(words_, 1);
    foot->addWidget(lookHere_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(split, 1);
    layout->addLayout(foot);
    connect(lookHere_, &QPushButton::clicked, this, [this] {
        Edit edit{*figure_, tr("Look at point").toStdString(), {}, false};
        edit.figure.camera.targetMm = pointMm_;
        Q_EMIT edited(edit);
    });
    setFigure(nullptr, {});
}

void SlicesPanel::setFigure(std::shared_ptr<const Figure> figure, const ValueRange& window) {
    const Volume* before = scanOf(figure_.get());
    figure_ = std::move(figure);
    const Volume* scan = scanOf(figure_.get());
    setEnabled(scan != nullptr);
    for (SliceCanvas* canvas : canvases_) {
        canvas->setVolume(scan ? figure_->volume->data : nullptr);
        if (scan)
            canvas->setLook(sliceLook(*figure_, window));
    }
    if (scan && scan != before)
        setPoint(scan->grid().centreMm());
    showPoint();
}

void SlicesPanel::setPoint(const glm::dvec3& pointMm) {
    const Volume* scan = scanOf(figure_.get());
    if (!scan)
        return;
    const Grid& grid = scan->grid();
    const glm::dvec3 voxel = glm::clamp(grid.voxelFromMm(pointMm), glm::dvec3(-0.5), glm::dvec3(grid.dims) - 0.5);
    pointMm_ = grid.mmFromVoxel(voxel);
    for (SliceCanvas* canvas : canvases_)
        canvas->setPoint(pointMm_);
    showPoint();
}

void SlicesPanel::showPoint() {
    const Volume* scan = scanOf(figure_.get());
    if (!scan) {
        words_->clear();
        return;
    }
    const QString unit = QString::fromStdString(scan->contents().unit);
    const double value = trilinear(*scan, scan->grid().voxelFromMm(pointMm_));
    const auto text = [](double mm) { return QLocale().toString(mm, 'f', 1); };
    words_->setText(
        tr("%1 %2 at %3, %4, %5 mm")
            .arg(QLocale().toString(value, 'g', 4), unit, text(pointMm_.x), text(pointMm_.y), text(pointMm_.z))
            .simplified());
}

} // namespace limner
