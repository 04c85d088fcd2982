#include "widgets/part_form.h"

#include "widgets/core_words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr int kIndent = 20; // rows stand under the check box's words

} // namespace

PartForm::PartForm(std::string pointer, QWidget* parent)
    : QWidget(parent), pointer_(std::move(pointer)), present_(new QCheckBox(labelOfSetting(pointer_))),
      head_(new QHBoxLayout), body_(new QWidget), form_(formLayout(body_)) {
    present_->setToolTip(helpOfSetting(pointer_));
    form_->setContentsMargins(kIndent, 2, 0, 6);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    head_->addWidget(present_, 1);
    column->addLayout(head_);
    column->addWidget(body_);
    body_->hide();
    setEnabled(false);
    connect(present_, &QCheckBox::clicked, this, &PartForm::setPresent);
}

ParameterRow* PartForm::row(std::string_view pointer) const {
    const auto found = std::find_if(numbers_.begin(), numbers_.end(),
                                    [&](const ParameterRow* number) { return number->pointer() == pointer; });
    return found == numbers_.end() ? nullptr : *found;
}

ParameterRow* PartForm::addRow(const std::string& pointer, const ParameterRow::Useful& useful, const QString& label) {
    auto* row = new ParameterRow(pointer, useful);
    numbers_.push_back(row);
    addLabelled(form_, label.isEmpty() ? row->label() : label, row, row->slider());
    return row;
}

ColourButton* PartForm::addColourRow(const std::string& pointer) {
    auto* button = new ColourButton(labelOfSetting(pointer));
    button->setToolTip(helpOfSetting(pointer));
    addLabelled(form_, labelOfSetting(pointer), button);
    return button;
}

LightForm* PartForm::addLightRow(const std::string& pointer) {
    auto* light = new LightForm(pointer);
    QLabel* label = addLabelled(form_, labelOfSetting(pointer), light, light->kind());
    label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::MinimumExpanding); // beside the middle of the ball
    return light;
}

QComboBox* PartForm::addChoiceRow(const std::string& pointer, const ChoiceWords& words) {
    QComboBox* box = choiceBox(pointer, words);
    addLabelled(form_, labelOfSetting(pointer), box);
    choices_.emplace_back(pointer, box);
    return box;
}

QComboBox* PartForm::choice(std::string_view pointer) const {
    const auto found = std::ranges::find(choices_, pointer, [](const auto& c) { return std::string_view(c.first); });
    return found == choices_.end() ? nullptr : found->second;
}

void PartForm::onChosen(QComboBox* box, const std::function<void()>& then) {
    connect(box, &QComboBox::activated, this, then);
}

void PartForm::addBeside(QWidget* widget) { head_->addWidget(widget); }

bool PartForm::on() const { return figure_ && has(*figure_, layer_); }

bool PartForm::mayEdit() const { return figure_ && (!pointer_.starts_with("/layers/") || mayChange(*figure_, layer_)); }

void PartForm::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    const auto layers = [](const std::shared_ptr<const Figure>& f) { return f ? f->layers.size() : 0; };
    if (layer != layer_ || layers(figure) != layers(figure_) || scanOf(figure.get()) != scanOf(figure_.get()))
        forget();
    figure_ = std::move(figure);
    layer_ = layer;
    setEnabled(mayEdit());
    present_->setChecked(on());
    body_->setVisible(on());
    if (on())
        showPart();
}

void PartForm::setPresent(bool on) {
    const QString name = inSentence(present_->text());
    submit(on ? tr("Add %1").arg(name) : tr("Remove %1").arg(name), {}, false,
           [&](Figure& changed) { put(changed, layer_, on); });
    if (this->on())
        Q_EMIT opened();
}

void PartForm::submit(const QString& label, const std::string& key, bool ongoing,
                      const std::function<void(Figure&)>& change) {
    if (!mayEdit())
        return;
    Edit edit{*figure_, label.toStdString(), key.empty() ? key : pointer_ + "/" + key + "@" + std::to_string(layer_),
              ongoing};
    change(edit.figure);
    Q_EMIT edited(edit);
}

void scrollToOpened(QScrollArea* area) {
    for (PartForm* part : area->widget()->findChildren<PartForm*>())
        QObject::connect(part, &PartForm::opened, area, [area, part] {
            QTimer::singleShot(0, part, [=] { // once it is laid out
                area->ensureWidgetVisible(part, 0, 4);
                area->ensureWidgetVisible(part->present(), 0, 4); // of a part that is taller than the panel, its top
            });
        });
}

} // namespace limner
