#include "widgets/slider_row.h"

#include "widgets/form_parts.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>
#include <utility>

namespace limner {

SliderRow::SliderRow(const QString& name, const QString& tip, const Range& range, QWidget* parent)
    : QWidget(parent), name_(name.toStdString()), range_(range), slider_(new QSlider(Qt::Horizontal)),
      box_(new QDoubleSpinBox) {
    slider_->setRange(0, static_cast<int>(std::lround((range.high - range.low) / range.step)));
    slider_->setPageStep(std::max(1, slider_->maximum() / 10));
    slider_->setAccessibleName(name);
    slider_->setToolTip(tip);
    leaveWheelToPanel(slider_);
    box_->setRange(range.low, range.high);
    box_->setSingleStep(range.step);
    box_->setDecimals(range.decimals);
    box_->setSuffix(range.suffix);
    box_->setKeyboardTracking(false);
    box_->setAccessibleName(tr("%1, number").arg(name));
    box_->setToolTip(tip);
    leaveWheelToPanel(box_);
    constexpr int kBoxWidth = 78;
    box_->setFixedWidth(kBoxWidth);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(slider_, 1);
    layout->addWidget(box_);
    setFocusProxy(slider_);
    setToolTip(tip);
    const auto value = [this] { return range_.low + slider_->value() * range_.step; };
    connect(slider_, &QSlider::sliderPressed, this, [this] {
        dragged_ = false;
        key_.begin(name_);
    });
    connect(slider_, &QSlider::valueChanged, this, [this, value] {
        const bool down = slider_->isSliderDown();
        dragged_ = down;
        Q_EMIT changed(value(), down ? key_.during(name_) : key_.again(name_), down);
    });
    connect(slider_, &QSlider::sliderReleased, this, [this, value] {
        if (std::exchange(dragged_, false))
            Q_EMIT changed(value(), key_.during(name_), false);
    });
    connect(box_, &QDoubleSpinBox::valueChanged, this,
            [this](double typed) { Q_EMIT changed(typed, key_.again(name_), false); });
}

void SliderRow::setValue(double value) {
    const QSignalBlocker quiet[] = {QSignalBlocker(slider_), QSignalBlocker(box_)};
    if (!slider_->isSliderDown())
        slider_->setValue(static_cast<int>(std::lround((value - range_.low) / range_.step)));
    box_->setValue(value);
}

} // namespace limner
