#include "widgets/importance_form.h"

#include "widgets/core_words.h"
#include "widgets/form_parts.h"
#include "widgets/lens_form.h"
#include "widgets/parameter_row.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {

Importance firstImportance() {
    Importance result;
    result.weights.gradient = 4;
    return result;
}

ImportanceForm::ImportanceForm(QWidget* parent)
    : QWidget(parent), through_(new QCheckBox(tr("Let what matters &show through"))), lenses_(new LensForm),
      parts_(new QWidget), last_(firstImportance()) {
    through_->setToolTip(
        tr("Important matter is seen through what lies in front of it, without cutting anything away"));
    QFormLayout* measures = formLayout();
    QFormLayout* limits = formLayout();
    buildRows(measures, limits);
    layOut(measures, limits);
    connect(through_, &QCheckBox::clicked, this, &ImportanceForm::setPresent);
    connect(lenses_, &LensForm::edited, this, &ImportanceForm::edited);
    setFigure(nullptr);
}

void ImportanceForm::buildRows(QFormLayout* measures, QFormLayout* limits) {
    using I = Importance;
    using Useful = ParameterRow::Useful;
    const auto add = [this](QFormLayout* form, const char* pointer, Useful useful, double& (*of)(I&)) {
        auto* row = new ParameterRow(pointer, useful);
        rows_.push_back({row, of});
        addLabelled(form, row->label(), row, row->slider());
        connect(row, &ParameterRow::changed, this, [=, this](double value, const std::string& key, bool ongoing) {
            if (!figure_ || !figure_->importance)
                return;
            Edit edit{*figure_, tr("Change %1").arg(inSentence(row->label())).toStdString(), key, ongoing};
            of(*edit.figure.importance) = value;
            Q_EMIT edited(edit);
        });
    };
    const Useful weight{0, 10, 2};
    add(measures, "/importance/global", weight, [](I& i) -> double& { return i.global; });
    add(measures, "/importance/weights/intensity", weight, [](I& i) -> double& { return i.weights.intensity; });
    add(measures, "/importance/weights/extinction", weight, [](I& i) -> double& { return i.weights.extinction; });
    add(measures, "/importance/weights/gradient", weight, [](I& i) -> double& { return i.weights.gradient; });
    add(measures, "/importance/weights/silhouette", weight, [](I& i) -> double& { return i.weights.silhouette; });
    add(measures, "/importance/weights/unocclusion", weight, [](I& i) -> double& { return i.weights.unocclusion; });
    add(measures, "/importance/weights/lighting", weight, [](I& i) -> double& { return i.weights.lighting; });
    add(measures, "/importance/weights/object", weight, [](I& i) -> double& { return i.weights.object; });
    add(measures, "/importance/weights/statistics", weight, [](I& i) -> double& { return i.weights.statistics; });
    add(limits, "/importance/background", weight, [](I& i) -> double& { return i.background; });
    add(limits, "/importance/cap", {0, 20, 1}, [](I& i) -> double& { return i.cap; });
    add(limits, "/importance/noise_floor", {0, 0.2, 3}, [](I& i) -> double& { return i.noiseFloor; });
}

void ImportanceForm::layOut(QFormLayout* measures, QFormLayout* limits) {
    auto* parts = new QVBoxLayout(parts_);
    parts->setContentsMargins(0, 0, 0, 0);
    parts->addWidget(heading(tr("What matters")));
    parts->addLayout(measures);
    parts->addSpacing(6);
    parts->addWidget(heading(tr("Where it matters")));
    parts->addWidget(lenses_);
    parts->addSpacing(6);
    parts->addWidget(heading(tr("Limits")));
    parts->addLayout(limits);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(through_);
    column->addWidget(parts_);
    column->addStretch(1);
    QScrollArea* scroll = scrolling(content);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    setMinimumWidth(content->minimumSizeHint().width());
}

ParameterRow* ImportanceForm::row(std::string_view pointer) const {
    const auto found =
        std::find_if(rows_.begin(), rows_.end(), [&](const Entry& entry) { return entry.row->pointer() == pointer; });
    return found == rows_.end() ? nullptr : found->row;
}

void ImportanceForm::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    setEnabled(figure_ != nullptr);
    const bool on = figure_ && figure_->importance;
    if (on)
        last_ = *figure_->importance;
    through_->setChecked(on);
    parts_->setEnabled(on);
    Importance shown = on ? *figure_->importance : Importance{};
    for (const Entry& entry : rows_)
        entry.row->setValue(entry.of(shown));
    lenses_->setFigure(figure_);
}

void ImportanceForm::setPresent(bool on) {
    if (!figure_)
        return;
    Edit edit{*figure_, (on ? tr("Show what matters") : tr("Show nothing through")).toStdString(), {}, false};
    edit.figure.importance = on ? std::optional(last_) : std::nullopt;
    Q_EMIT edited(edit);
}

} // namespace limner
