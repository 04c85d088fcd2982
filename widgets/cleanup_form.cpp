#include "widgets/cleanup_form.h"

#include "core/figure/cleanup_start.h"
#include "core/figure/parameters.h"
#include "widgets/cleanup_words.h"
#include "widgets/core_words.h"
#include "widgets/form_parts.h"
#include "widgets/parameter_row.h"

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr std::size_t kMostSteps = 1024; // that a figure may have
constexpr CleanupKind kKinds[] = {CleanupKind::keepLargest, CleanupKind::keepAt, CleanupKind::removeIslands,
                                  CleanupKind::scissors, CleanupKind::eraseLabel};

bool countsMatter(CleanupKind kind) {
    return kind == CleanupKind::keepLargest || kind == CleanupKind::keepAt || kind == CleanupKind::removeIslands;
}

} // namespace

CleanupForm::CleanupForm(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), add_(new QPushButton(tr("&Add step"))),
      earlier_(new QPushButton(tr("&Earlier"))), later_(new QPushButton(tr("La&ter"))),
      remove_(new QPushButton(tr("&Delete"))), kinds_(new QMenu(this)),
      none_(new QLabel(tr("Nothing is taken away. Add a step to remove a table, a headrest, crumbs or a label; the "
                          "scan itself stays as it is."))),
      settings_(new QWidget), form_(new QFormLayout(settings_)), side_(new QComboBox),
      look_(new QPushButton(tr("&Look from there"))), label_(new QSpinBox) {
    list_->setAccessibleName(tr("Clean-up steps"));
    list_->setToolTip(helpOfSetting("/cleanup"));
    list_->setWordWrap(true);
    list_->setTextElideMode(Qt::ElideNone);
    none_->setWordWrap(true);
    earlier_->setToolTip(tr("The chosen step runs before the one above it"));
    later_->setToolTip(tr("The chosen step runs after the one below it"));
    remove_->setToolTip(tr("Delete the chosen step; what it took away comes back"));
    buildMenu();
    buildRows();
    buildOthers();
    layOut();
    connect(list_, &QListWidget::currentRowChanged, this, &CleanupForm::showStep);
    connect(earlier_, &QPushButton::clicked, this, [this] { moveStep(-1); });
    connect(later_, &QPushButton::clicked, this, [this] { moveStep(1); });
    connect(remove_, &QPushButton::clicked, this, &CleanupForm::removeStep);
    setFigure(nullptr, nullptr);
}

void CleanupForm::buildMenu() {
    add_->setToolTip(tr("Add a step after the others"));
    for (const CleanupKind kind : kKinds) {
        const bool inPicture = kind == CleanupKind::keepAt || kind == CleanupKind::scissors;
        QAction* action = kinds_->addAction(cleanupKindWords(kind) + (inPicture ? "…" : ""));
        action->setData(static_cast<int>(kind));
        connect(action, &QAction::triggered, this, [this, kind] { addStep(kind); });
    }
    add_->setMenu(kinds_);
}

void CleanupForm::buildRows() {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setVerticalSpacing(4);
    const auto add = [this](const char* pointer, ParameterRow::Useful useful, double& (*of)(CleanupStep&),
                            bool (*has)(CleanupKind)) {
        auto* row = new ParameterRow(pointer, useful);
        rows_.push_back({row, of, has});
        addLabelled(form_, row->label(), row, row->slider());
        connect(row, &ParameterRow::changed, this, [=, this](double value, const std::string& key, bool ongoing) {
            editStep(tr("Change %1").arg(inSentence(row->label())), key, ongoing,
                     [&](CleanupStep& step) { of(step) = value; });
        });
    };
    add(
        "/cleanup/*/above", {0, 1, 2}, [](CleanupStep& s) -> double& { return s.above; }, countsMatter);
    add(
        "/cleanup/*/below_mm3", {0, 10000, 2}, [](CleanupStep& s) -> double& { return s.belowMm3; },
        [](CleanupKind kind) { return kind == CleanupKind::removeIslands; });
    add(
        "/cleanup/*/opening_mm", {0, 10, 2}, [](CleanupStep& s) -> double& { return s.openingMm; },
        [](CleanupKind kind) { return kind == CleanupKind::keepLargest; });
}

void CleanupForm::buildOthers() {
    side_->addItem(tr("What is inside the outline"), static_cast<int>(ScissorsSide::inside));
    side_->addItem(tr("What is outside"), static_cast<int>(ScissorsSide::outside));
    side_->setAccessibleName(tr("Side that is cut away"));
    side_->setToolTip(helpOfSetting("/cleanup/*/side"));
    look_->setToolTip(tr("Turn the figure to the view in which the outline was drawn"));
    label_->setRange(0, 65535); // of a label volume
    label_->setKeyboardTracking(false);
    label_->setAccessibleName(tr("Label to erase"));
    label_->setToolTip(helpOfSetting("/cleanup/*/label"));
    addLabelled(form_, tr("C&ut away"), side_);
    form_->addRow(QString(), look_);
    addLabelled(form_, tr("La&bel"), label_);
    connect(side_, &QComboBox::activated, this, [this](int row) {
        editStep(tr("Cut the other side"), {}, false,
                 [&](CleanupStep& step) { step.side = static_cast<ScissorsSide>(side_->itemData(row).toInt()); });
    });
    connect(look_, &QPushButton::clicked, this, [this] {
        const auto chosen = selected();
        if (!chosen || !steps()[*chosen].camera)
            return;
        Edit edit{*figure_, tr("Look from the lasso's view").toStdString(), {}, false};
        edit.figure.camera = *steps()[*chosen].camera;
        Q_EMIT edited(edit);
    });
    connect(label_, &QSpinBox::valueChanged, this, [this](int value) {
        editStep(tr("Change label to erase"), "cleanup/label", false, [&](CleanupStep& step) { step.label = value; });
    });
}

void CleanupForm::layOut() {
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(4);
    for (QPushButton* button : {add_, earlier_, later_, remove_})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto* top = new QHBoxLayout;
    top->addWidget(list_, 1);
    top->addLayout(buttons);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(none_);
    column->addLayout(top, 1);
    column->addWidget(settings_);
}

ParameterRow* CleanupForm::row(std::string_view pointer) const {
    const auto found =
        std::find_if(rows_.begin(), rows_.end(), [&](const Entry& entry) { return entry.row->pointer() == pointer; });
    return found == rows_.end() ? nullptr : found->row;
}

const std::vector<CleanupStep>& CleanupForm::steps() const {
    static const std::vector<CleanupStep> none;
    return figure_ ? figure_->cleanup : none;
}

std::optional<std::size_t> CleanupForm::selected() const {
    const int row = list_->currentRow();
    return row >= 0 && static_cast<std::size_t>(row) < steps().size() ? std::optional<std::size_t>(row) : std::nullopt;
}

void CleanupForm::select(std::optional<std::size_t> step) { list_->setCurrentRow(step ? static_cast<int>(*step) : -1); }

void CleanupForm::setFigure(std::shared_ptr<const Figure> figure, std::shared_ptr<const Histogram> histogram) {
    const bool sameScan = scanOf(figure_.get()) == scanOf(figure.get());
    figure_ = std::move(figure);
    histogram_ = std::move(histogram);
    if (!sameScan)
        fitRanges();
    const std::size_t before = static_cast<std::size_t>(list_->count());
    {
        const QSignalBlocker quiet(list_);
        while (static_cast<std::size_t>(list_->count()) > steps().size())
            delete list_->takeItem(list_->count() - 1);
        while (static_cast<std::size_t>(list_->count()) < steps().size())
            list_->addItem(QString());
        for (std::size_t i = 0; i < steps().size(); ++i) {
            const QString text = tr("%1. %2").arg(i + 1).arg(cleanupWords(steps()[i], *figure_));
            list_->item(static_cast<int>(i))->setText(text);
        }
        if (before < steps().size()) // one has come, from here or from a tool over the picture
            select(steps().size() - 1);
    }
    setEnabled(figure_ != nullptr);
    add_->setEnabled(scanOf(figure_.get()) && histogram_ && steps().size() < kMostSteps);
    for (QAction* action : kinds_->actions()) {
        const bool label = static_cast<CleanupKind>(action->data().toInt()) == CleanupKind::eraseLabel;
        action->setEnabled(!label || (figure_ && figure_->labels && figure_->labels->data));
    }
    none_->setVisible(steps().empty());
    showStep();
}

void CleanupForm::fitRanges() {
    const Volume* scan = scanOf(figure_.get());
    if (!scan)
        return;
    const ValueRange range = scan->range();
    const double span = range.high - range.low;
    const int fine = span > 0 ? static_cast<int>(std::ceil(3 - std::log10(span))) : 2; // a thousandth of the range
    row("/cleanup/*/above")->setUseful({range.low, range.high, std::clamp(fine, 0, 9)});
    const glm::dvec3 size = scan->grid().sizeMm();
    const double whole = size.x * size.y * size.z;
    constexpr double kLargeIsland = 0.01; // of the box: nobody calls more an island
    const int finer = whole > 0 ? static_cast<int>(std::ceil(5 - std::log10(whole))) : 2;
    row("/cleanup/*/below_mm3")->setUseful({0, kLargeIsland * whole, std::clamp(finer, 0, 9)});
}

void CleanupForm::showStep() {
    const auto chosen = selected();
    CleanupStep step = chosen ? steps()[*chosen] : CleanupStep{};
    const auto shows = [&](CleanupKind kind) { return chosen && step.kind == kind; };
    remove_->setEnabled(chosen.has_value());
    earlier_->setEnabled(chosen && *chosen > 0);
    later_->setEnabled(chosen && *chosen + 1 < steps().size());
    settings_->setVisible(chosen.has_value());
    for (const Entry& entry : rows_) {
        form_->setRowVisible(entry.row, chosen && entry.has(step.kind));
        entry.row->setValue(entry.of(step));
    }
    form_->setRowVisible(side_, shows(CleanupKind::scissors));
    form_->setRowVisible(look_, shows(CleanupKind::scissors));
    form_->setRowVisible(label_, shows(CleanupKind::eraseLabel));
    side_->setCurrentIndex(side_->findData(static_cast<int>(step.side)));
    look_->setEnabled(step.camera && figure_ && *step.camera != figure_->camera);
    const QSignalBlocker quiet(label_);
    label_->setValue(step.label);
}

void CleanupForm::editStep(const QString& label, const std::string& key, bool ongoing,
                           const std::function<void(CleanupStep&)>& change) {
    const auto chosen = selected();
    if (!chosen)
        return;
    const std::string own = key.empty() ? key : key + "@" + std::to_string(*chosen);
    Edit edit{*figure_, label.toStdString(), own, ongoing};
    change(edit.figure.cleanup[*chosen]);
    Q_EMIT edited(edit);
}

void CleanupForm::addStep(CleanupKind kind) {
    const Volume* scan = scanOf(figure_.get());
    if (!scan || !histogram_ || steps().size() >= kMostSteps)
        return;
    if (kind == CleanupKind::scissors) {
        Q_EMIT scissorsWanted();
        return;
    }
    if (kind == CleanupKind::keepAt) {
        Q_EMIT islandWanted();
        return;
    }
    Edit edit{*figure_, cleanupKindWords(kind).toStdString(), {}, false};
    edit.figure.cleanup.push_back(startingStep(kind, *scan, *histogram_));
    Q_EMIT edited(edit);
}

void CleanupForm::removeStep() {
    const auto chosen = selected();
    if (!chosen)
        return;
    Edit edit{*figure_, tr("Delete clean-up step").toStdString(), {}, false};
    edit.figure.cleanup.erase(edit.figure.cleanup.begin() + static_cast<std::ptrdiff_t>(*chosen));
    Q_EMIT edited(edit);
}

void CleanupForm::moveStep(int by) {
    const auto chosen = selected();
    const auto to = static_cast<std::ptrdiff_t>(chosen.value_or(0)) + by;
    if (!chosen || to < 0 || to >= static_cast<std::ptrdiff_t>(steps().size()))
        return;
    Edit edit{*figure_, tr("Reorder clean-up steps").toStdString(), {}, false};
    std::swap(edit.figure.cleanup[*chosen], edit.figure.cleanup[static_cast<std::size_t>(to)]);
    Q_EMIT edited(edit);
    select(static_cast<std::size_t>(to));
}

} // namespace limner
