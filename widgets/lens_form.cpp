#include "widgets/lens_form.h"

#include "widgets/core_words.h"
#include "widgets/form_parts.h"
#include "widgets/importance_form.h"
#include "widgets/lens_place.h"
#include "widgets/parameter_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr std::size_t kMostLenses = 64; // that a figure may have
constexpr int kListHeight = 72;         // three lenses; more scroll

} // namespace

LensForm::LensForm(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), add_(new QPushButton(tr("Add &lens"))),
      remove_(new QPushButton(tr("Remo&ve"))), settings_(new QWidget), kind_(new QComboBox), shape_(new QComboBox),
      follows_(new QCheckBox(tr("&Follow the anatomy"))) {
    list_->setFixedHeight(kListHeight);
    list_->setUniformItemSizes(true);
    list_->setAccessibleName(tr("Lenses"));
    list_->setToolTip(tr("Importance acts under the lenses only; without any it acts everywhere"));
    add_->setToolTip(tr("Add a lens in the middle of the figure"));
    remove_->setToolTip(tr("Remove the chosen lens"));
    follows_->setToolTip(tr("The lens stays on the same place of the body as the view turns"));
    buildChoices();
    buildRows(formLayout(settings_));
    layOut();
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        showLens();
        Q_EMIT lensSelected();
    });
    connect(add_, &QPushButton::clicked, this, &LensForm::addLens);
    connect(remove_, &QPushButton::clicked, this, &LensForm::removeLens);
    connect(follows_, &QCheckBox::clicked, this, [this](bool on) {
        editLens(on ? tr("Anchor lens") : tr("Let go of lens"), {}, false,
                 [&](Lens& lens) { lens = lensFollowing(*figure_, lens, on); });
    });
    showLens();
}

void LensForm::buildChoices() {
    kind_->addItem(tr("Circular, with an edge"), "circular");
    kind_->addItem(tr("Gaussian, fading out"), "gaussian");
    kind_->addItem(tr("Screen door, of dots"), "screendoor");
    kind_->setAccessibleName(tr("Kind of lens"));
    kind_->setToolTip(helpOfSetting("/importance/lenses/0/kind"));
    shape_->addItem(tr("Circle"), "circle");
    shape_->addItem(tr("Ellipse"), "ellipse");
    shape_->addItem(tr("Box"), "box");
    shape_->setAccessibleName(tr("Shape of the lens"));
    shape_->setToolTip(helpOfSetting("/importance/lenses/0/shape"));
    connect(kind_, &QComboBox::activated, this, [this](int row) {
        editLens(tr("Change kind of lens"), {}, false,
                 [&](Lens& lens) { lens.kind = kind_->itemData(row).toString().toStdString(); });
    });
    connect(shape_, &QComboBox::activated, this, [this](int row) {
        editLens(tr("Change shape of lens"), {}, false, [&](Lens& lens) {
            constexpr double kOblong = 1.5; // an ellipse as wide as high would be the circle again
            if (lens.shape == "circle" && lens.aspect == 1)
                lens.aspect = kOblong;
            lens.shape = shape_->itemData(row).toString().toStdString();
        });
    });
}

void LensForm::buildRows(QFormLayout* form) {
    addLabelled(form, tr("&Kind"), kind_);
    addLabelled(form, tr("S&hape"), shape_);
    const auto add = [&](const char* pointer, ParameterRow::Useful useful, double& (*of)(Lens&)) {
        auto* row = new ParameterRow(pointer, useful);
        rows_.push_back({row, of});
        addLabelled(form, row->label(), row, row->slider());
        connect(row, &ParameterRow::changed, this, [=, this](double value, const std::string& key, bool ongoing) {
            editLens(tr("Change %1 of lens").arg(inSentence(row->label())), key, ongoing,
                     [&](Lens& lens) { of(lens) = value; });
        });
    };
    add("/importance/lenses/*/radius", {0, 0.6, 3}, [](Lens& lens) -> double& { return lens.radius; });
    add("/importance/lenses/*/aspect", {0.2, 4, 2}, [](Lens& lens) -> double& { return lens.aspect; });
    add("/importance/lenses/*/angle_deg", {-90, 90, 0}, [](Lens& lens) -> double& { return lens.angleDeg; });
    add("/importance/lenses/*/soft", {0, 1, 2}, [](Lens& lens) -> double& { return lens.soft; });
    add("/importance/lenses/*/cell", {0.001, 0.02, 4}, [](Lens& lens) -> double& { return lens.cell; });
    add("/importance/lenses/*/inside", {0, 2, 2}, [](Lens& lens) -> double& { return lens.inside; });
    add("/importance/lenses/*/outside", {0, 2, 2}, [](Lens& lens) -> double& { return lens.outside; });
    form->addRow(QString(), follows_);
}

void LensForm::layOut() {
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(4);
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    auto* top = new QHBoxLayout;
    top->addWidget(list_, 1);
    top->addLayout(buttons);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(top);
    column->addWidget(settings_);
}

ParameterRow* LensForm::row(std::string_view pointer) const {
    const auto found =
        std::find_if(rows_.begin(), rows_.end(), [&](const Entry& entry) { return entry.row->pointer() == pointer; });
    return found == rows_.end() ? nullptr : found->row;
}

const std::vector<Lens>& LensForm::lenses() const {
    static const std::vector<Lens> none;
    return figure_ && figure_->importance ? figure_->importance->lenses : none;
}

std::optional<std::size_t> LensForm::selected() const {
    const int row = list_->currentRow();
    return row >= 0 && static_cast<std::size_t>(row) < lenses().size() ? std::optional<std::size_t>(row) : std::nullopt;
}

void LensForm::select(std::optional<std::size_t> lens) { list_->setCurrentRow(lens ? static_cast<int>(*lens) : -1); }

void LensForm::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    const int count = static_cast<int>(lenses().size());
    {
        const QSignalBlocker quiet(list_);
        while (list_->count() > count)
            delete list_->takeItem(list_->count() - 1);
        while (list_->count() < count)
            list_->addItem(tr("Lens %1").arg(list_->count() + 1));
    }
    add_->setEnabled(figure_ && lenses().size() < kMostLenses);
    showLens();
}

void LensForm::showLens() {
    const auto chosen = selected();
    remove_->setEnabled(chosen.has_value());
    settings_->setEnabled(chosen.has_value());
    Lens lens = chosen ? lenses()[*chosen] : Lens{};
    choose(kind_, lens.kind);
    choose(shape_, lens.shape);
    for (const Entry& entry : rows_)
        entry.row->setValue(entry.of(lens));
    row("/importance/lenses/*/soft")->setEnabled(lens.kind == "circular"); // the others fade by themselves
    row("/importance/lenses/*/cell")->setEnabled(lens.kind == "screendoor");
    for (const char* oblong : {"/importance/lenses/*/aspect", "/importance/lenses/*/angle_deg"})
        row(oblong)->setEnabled(lens.shape != "circle");
    follows_->setChecked(lens.anchorMm.has_value());
}

void LensForm::editLens(const QString& label, const std::string& key, bool ongoing,
                        const std::function<void(Lens&)>& change) {
    const auto chosen = selected();
    if (!chosen)
        return;
    const std::string own = key.empty() ? key : key + "@" + std::to_string(*chosen);
    Edit edit{*figure_, label.toStdString(), own, ongoing};
    change(edit.figure.importance->lenses[*chosen]);
    Q_EMIT edited(edit);
}

void LensForm::addLens() {
    if (!figure_ || lenses().size() >= kMostLenses)
        return;
    Edit edit{*figure_, tr("Add lens").toStdString(), {}, false};
    if (!edit.figure.importance)
        edit.figure.importance = firstImportance();
    edit.figure.importance->lenses.emplace_back();
    Q_EMIT edited(edit);
    if (!lenses().empty())
        select(lenses().size() - 1);
}

void LensForm::removeLens() {
    const auto chosen = selected();
    if (!chosen)
        return;
    Edit edit{*figure_, tr("Remove lens").toStdString(), {}, false};
    auto& left = edit.figure.importance->lenses;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(*chosen));
    Q_EMIT edited(edit);
}

} // namespace limner
