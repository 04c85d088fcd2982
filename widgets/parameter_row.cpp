#include "widgets/parameter_row.h"

#include "core/figure/parameters.h"
#include "widgets/core_words.h"
#include "widgets/form_parts.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr int kSteps = 200; // of the slider: half a percent each

} // namespace

ParameterRow::ParameterRow(std::string pointer, const Useful& useful, QWidget* parent)
    : QWidget(parent), pointer_(std::move(pointer)), parameter_(findParameter(pointer_)), useful_(useful),
      slider_(new QSlider(Qt::Horizontal)), box_(new QDoubleSpinBox), picture_(new QLabel) {
    assert(parameter_);
    const QString tip = coreWord(parameter_->help);
    slider_->setRange(0, kSteps);
    slider_->setPageStep(kSteps / 10);
    slider_->setAccessibleName(label());
    slider_->setToolTip(tip);
    leaveWheelToPanel(slider_);
    setUseful(useful);
    const std::string& unit = parameter_->unit;
    box_->setSuffix(unit.starts_with("mm") ? tr(" mm") : unit == "deg" ? tr("°") : QString());
    box_->setKeyboardTracking(false);
    box_->setAccessibleName(tr("%1, number").arg(label()));
    box_->setToolTip(tip);
    leaveWheelToPanel(box_);
    constexpr int kBoxWidth = 96; // legal ranges reach 100000; that is no reason to take the slider's room
    box_->setFixedWidth(kBoxWidth);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(picture_);
    layout->addWidget(slider_, 1);
    layout->addWidget(box_);
    picture_->setToolTip(tip);
    picture_->hide();
    setFocusProxy(slider_);
    connectParts();
}

void ParameterRow::connectParts() {
    connect(slider_, &QSlider::sliderPressed, this, [this] {
        dragged_ = false;
        key_.begin(pointer_);
    });
    connect(slider_, &QSlider::valueChanged, this, [this] {
        dragged_ = slider_->isSliderDown();
        const bool down = slider_->isSliderDown();
        Q_EMIT changed(sliderValue(), down ? key_.during(pointer_) : key_.again(pointer_), down);
    });
    connect(slider_, &QSlider::sliderReleased, this, [this] {
        if (std::exchange(dragged_, false))
            Q_EMIT changed(sliderValue(), key_.during(pointer_), false);
    });
    connect(box_, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { Q_EMIT changed(value, key_.again(pointer_), false); });
}

void ParameterRow::setUseful(const Useful& useful) {
    const QSignalBlocker quiet(box_);
    useful_ = useful;
    const double least = std::pow(10.0, -useful.decimals);
    const double low = parameter_->low.value_or(useful.low);
    box_->setDecimals(useful.decimals);
    box_->setRange(parameter_->lowExcluded ? low + least : low, parameter_->high.value_or(useful.high));
    box_->setSingleStep((useful.high - useful.low) / 100);
}

QString ParameterRow::label() const { return coreWord(parameter_->label); }

void ParameterRow::setPicture(const QImage& picture) {
    picture_->setPixmap(QPixmap::fromImage(picture));
    picture_->setVisible(!picture.isNull());
}

double ParameterRow::sliderValue() const {
    const double way = std::pow(static_cast<double>(slider_->value()) / kSteps, useful_.power);
    const double value = useful_.low + (useful_.high - useful_.low) * way;
    return std::clamp(value, box_->minimum(), box_->maximum());
}

void ParameterRow::setValue(double value) {
    const QSignalBlocker quiet[] = {QSignalBlocker(slider_), QSignalBlocker(box_)};
    const double width = useful_.high - useful_.low; // 0: of a constant scan's values
    const double share = width > 0 ? std::clamp((value - useful_.low) / width, 0.0, 1.0) : 0;
    if (!slider_->isSliderDown())
        slider_->setValue(static_cast<int>(std::lround(std::pow(share, 1 / useful_.power) * kSteps)));
    box_->setValue(value);
}

} // namespace limner
